//! Values in the text of a case: `KEY=VALUE` of the command line is written into it before it is read, studies read them.

use super::{Case, CaseError, Result, library, source::alternatives};
use crate::units::did_you_mean;
use toml_edit::{DocumentMut, Item, Table, Value};

const MATERIAL: &str = "material";

/// The text with every override applied in order; text that is not TOML is returned as it is, to be reported later.
pub(crate) fn apply(text: &str, overrides: &[String]) -> Result<String> {
    if overrides.is_empty() {
        return Ok(text.to_owned());
    }
    let Ok(mut document) = text.parse::<DocumentMut>() else { return Ok(text.to_owned()) };
    for written in &overrides.iter().flat_map(|written| spread(&document, written)).collect::<Vec<_>>() {
        let fail = |what: String, help: String| CaseError::bare(format!("override `{written}`: {what}"), help);
        let usage = "write KEY=VALUE, such as tools.punch.friction=0.1 or blank.thickness=\"0.9 mm\"";
        let (path, value) =
            written.split_once('=').ok_or_else(|| fail("there is no `=` in it".into(), usage.into()))?;
        let segments: Vec<&str> = path.split('.').map(str::trim).collect();
        let Some((key, tables)) = segments.split_last().filter(|_| segments.iter().all(|s| !s.is_empty())) else {
            return Err(fail("it names no key".into(), usage.into()));
        };
        let optional = "solver output stop friction stage forming_limit press finished springback report";
        for optional in optional.split(' ').filter(|optional| tables == [*optional]) {
            document.entry(optional).or_insert(Item::Table(Table::new()));
        }
        let mut here = document.as_item_mut();
        for (depth, segment) in tables.iter().enumerate() {
            let known = keys(here);
            here = child(here, segment).ok_or_else(|| {
                let near = did_you_mean(segment, known.iter().map(String::as_str));
                let all = if known.is_empty() { "nothing".into() } else { known.join(", ") };
                let help = match known.first().map(String::as_str) {
                    Some("0") => format!("its tables are numbered: write {}.0.{segment}", tables[..depth].join(".")),
                    _ => format!("{near}it holds {all}"),
                };
                fail(format!("there is no table [{}]", tables[..=depth].join(".")), help)
            })?;
        }
        // All of a title block is text, a number of a drawing too.
        let read = value.trim().parse::<Value>().ok().filter(|read| tables != ["report"] || read.is_str());
        let value = read.unwrap_or_else(|| Value::from(value.trim()));
        if let (&[MATERIAL], Some(name)) = (&segments[..], value.as_str()) {
            replace_material(&mut document, name);
            continue;
        }
        alternatives(key).for_each(|other| drop(here.as_table_like_mut().and_then(|table| table.remove(other))));
        set(here, key, value).ok_or_else(|| fail(format!("[{}] holds no `{key}`", tables.join(".")), usage.into()))?;
    }
    Ok(document.to_string())
}

/// Overrides of every table, `tools.*.friction=0.1`; `friction` is of all tools, `strength`, `coil` of the metal; `last` ends a list.
fn spread(document: &DocumentMut, written: &str) -> Vec<String> {
    let Some((path, value)) = written.split_once('=') else { return vec![written.to_owned()] };
    let path = match path.trim() {
        "friction" => "tools.*.friction",
        "strength" => "material.strength",
        "coil" => "material.coil",
        _ => path,
    };
    let found = |above: &str| above.split('.').map(str::trim).try_fold(document.as_item(), |item, key| item.get(key));
    if let Some((above, below)) = path.split_once(".last.") {
        let entries = found(above).and_then(Item::as_array).map_or(0, toml_edit::Array::len);
        return vec![format!("{above}.{}.{below}={value}", entries.saturating_sub(1))];
    }
    let Some((above, below)) = path.split_once(".*.") else { return vec![format!("{path}={value}")] };
    let tables = found(above).and_then(Item::as_table_like).into_iter().flat_map(|table| table.iter());
    let tables: Vec<&str> = tables.filter(|(_, item)| item.is_table_like()).map(|(key, _)| key).collect();
    match tables.is_empty() {
        true => vec![format!("{path}={value}")],
        false => tables.into_iter().map(|table| format!("{above}.{table}.{below}={value}")).collect(),
    }
}

/// Puts a sheet of the library in the place of all that the case says of its material but how it is solved, `mode`.
fn replace_material(document: &mut DocumentMut, name: &str) {
    let old = document.get(MATERIAL);
    let mode = old.and_then(|material| material.get("mode")).and_then(Item::as_value).cloned();
    let mut table = Table::new();
    if let Some(Item::Table(old)) = old {
        *table.decor_mut() = old.decor().clone();
        table.set_position(old.position().or_else(|| old.iter().find_map(|(_, item)| item.as_table()?.position())));
    }
    table.insert("name", Item::Value(name.into()));
    mode.and_then(|mode| table.insert("mode", Item::Value(mode)));
    document.insert(MATERIAL, Item::Table(table));
}

fn keys(item: &Item) -> Vec<String> {
    let entries = item.as_array().map(toml_edit::Array::len).or(item.as_array_of_tables().map(|tables| tables.len()));
    match item.as_table_like() {
        Some(table) => table.iter().map(|(key, _)| key.to_owned()).collect(),
        None => (0..entries.unwrap_or(0)).map(|i| i.to_string()).collect(),
    }
}

fn child<'a>(item: &'a mut Item, segment: &str) -> Option<&'a mut Item> {
    let entry = match segment.parse::<usize>() {
        Ok(index) if !item.is_table_like() => item.get_mut(index)?,
        // Indexing by a missing name would insert it.
        _ => item.get(segment).is_some().then(|| item.get_mut(segment))??,
    };
    (entry.is_table_like() || entry.is_array() || entry.is_array_of_tables()).then_some(entry)
}

/// Sets a key of a table (new or not) or an entry of an array (that exists); comments stay, but a placeholder's.
fn set(item: &mut Item, key: &str, mut value: Value) -> Option<()> {
    if let (Ok(index), false) = (key.parse::<usize>(), item.is_table_like()) {
        *item.get_mut(index)? = Item::Value(value);
        return Some(());
    }
    let table = item.as_table_like_mut()?;
    let old = table.get(key).and_then(Item::as_value);
    if let Some(old) = old.filter(|old| !old.to_string().contains("# placeholder")) {
        *value.decor_mut() = old.decor().clone();
    }
    table.insert(key, Item::Value(value));
    Some(())
}

impl Case {
    /// Values in its text at a dotted path of keys, each with its path: `friction` is that of every tool. A key of the
    /// material is looked up in the library too, if the case takes its sheet from there.
    pub fn written(&self, key: &str) -> Vec<(String, String)> {
        let Ok(own) = self.text.parse::<DocumentMut>() else { return Vec::new() };
        let library = self.sheet().and_then(|sheet| sheet.text.parse::<DocumentMut>().ok());
        let value = |path: &str| at(&own, path).or_else(|| at(library.as_ref()?, path))?.as_value().map(plain);
        let paths = spread(&own, &format!("{key}="));
        let paths = paths.iter().map(|path| path.trim_end_matches('=').to_owned());
        paths.filter_map(|path| value(&path).map(|value| (path, value))).collect()
    }

    /// Its hardening law as a value that `material.hardening` may be set to; `None` where the text has none.
    pub fn hardening(&self) -> Option<Value> {
        let law = |text: &str| at(&text.parse::<DocumentMut>().ok()?, "material.hardening")?.clone().into_value().ok();
        law(&self.text).or_else(|| law(&self.sheet()?.text))
    }

    /// The sheet of the library that it names.
    pub fn sheet(&self) -> Option<library::Entry> {
        let document = self.text.parse::<DocumentMut>().ok()?;
        let name = at(&document, MATERIAL).filter(|item| item.is_str()).or_else(|| at(&document, "material.name"))?;
        library::material(name.as_str()?).ok()
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
