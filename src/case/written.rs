//! Values in the text of a case, for studies that change them.

use super::{Case, library, overrides};
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// The table that a sheet of the library fills.
const MATERIAL: &str = "material";

impl Case {
    /// What its text writes at a dotted path of keys, as an override would name it, with the path: of `friction` that of
    /// every tool; of a key of the material what the library has where the case takes its sheet from there.
    pub fn written(&self, key: &str) -> Vec<(String, String)> {
        let Ok(document) = self.text.parse::<DocumentMut>() else { return Vec::new() };
        let library = self.library_text().and_then(|text| text.parse::<DocumentMut>().ok());
        let paths = overrides::spread(&document, &format!("{key}="));
        let paths = paths.iter().map(|path| path.trim_end_matches('=').to_owned());
        paths
            .filter_map(|path| {
                let found = at(&document, &path).or_else(|| at(library.as_ref()?, &path))?;
                Some((path, plain(found.as_value()?)))
            })
            .collect()
    }

    /// Its hardening law as a value that `material.hardening` may be set to; `None` where the text has none.
    pub fn hardening(&self) -> Option<Value> {
        let library = self.library_text();
        let of = |text: &str| {
            let document = text.parse::<DocumentMut>().ok()?;
            at(&document, "material.hardening")?.as_table_like().map(|table| Value::InlineTable(inline(table)))
        };
        of(&self.text).or_else(|| of(library?))
    }

    /// The sheet of the library that it names.
    pub fn sheet(&self) -> Option<library::Entry> {
        let document = self.text.parse::<DocumentMut>().ok()?;
        let material = document.get(MATERIAL)?;
        let name = material.as_str().or_else(|| material.get("name")?.as_str())?;
        library::material(name).ok()
    }

    fn library_text(&self) -> Option<&'static str> {
        self.sheet().map(|sheet| sheet.text)
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
