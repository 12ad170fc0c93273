//! Values in the text of a case, for studies that change them.

use super::{Case, library, overrides};
use toml_edit::{DocumentMut, Item, TableLike, Value};

impl Case {
    /// Values in its text at a dotted path of keys, each with its path: `friction` is that of every tool. A key of the
    /// material is looked up in the library too, if the case takes its sheet from there.
    pub fn written(&self, key: &str) -> Vec<(String, String)> {
        let [Some(own), library] = self.documents() else { return Vec::new() };
        let value = |path: &str| at(&own, path).or_else(|| at(library.as_ref()?, path))?.as_value().map(plain);
        let paths = overrides::spread(&own, &format!("{key}="));
        let paths = paths.iter().map(|path| path.trim_end_matches('=').to_owned());
        paths.filter_map(|path| value(&path).map(|value| (path, value))).collect()
    }

    /// Its hardening law as a value that `material.hardening` may be set to; `None` where the text has none.
    pub fn hardening(&self) -> Option<Value> {
        let law = |document: &DocumentMut| Some(inline(at(document, "material.hardening")?.as_table_like()?));
        self.documents().iter().flatten().find_map(law).map(Value::InlineTable)
    }

    /// The sheet of the library that it names.
    pub fn sheet(&self) -> Option<library::Entry> {
        let document = self.text.parse::<DocumentMut>().ok()?;
        let material = document.get("material")?;
        let name = material.as_str().or_else(|| material.get("name")?.as_str())?;
        library::material(name).ok()
    }

    /// Its text and that of its sheet in the library.
    fn documents(&self) -> [Option<DocumentMut>; 2] {
        let library = self.sheet().and_then(|sheet| sheet.text.parse().ok());
        [self.text.parse().ok(), library]
    }
}

fn at<'a>(document: &'a DocumentMut, path: &str) -> Option<&'a Item> {
    path.split('.').map(str::trim).try_fold(document.as_item(), |item, key| match key.parse::<usize>() {
        Ok(index) if !item.is_table_like() => item.get(index),
        _ => item.get(key),
    })
}

fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.clone().decorated("", "").to_string().trim().to_owned(), str::to_owned)
}

/// A table on one line.
fn inline(table: &dyn TableLike) -> toml_edit::InlineTable {
    let mut line = toml_edit::InlineTable::new();
    for (key, item) in table.iter() {
        let value = match item {
            Item::Table(table) => Value::InlineTable(inline(table)),
            Item::Value(value) => on_one_line(value),
            _ => continue,
        };
        line.insert(key, value);
    }
    line
}

/// A value without what stands between its lines.
fn on_one_line(value: &Value) -> Value {
    match value {
        Value::Array(array) => Value::Array(array.iter().map(on_one_line).collect()),
        Value::InlineTable(table) => Value::InlineTable(inline(table)),
        plain => plain.clone().decorated("", ""),
    }
}
