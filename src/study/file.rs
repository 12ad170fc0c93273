//! A study as a file.
//!
//! ```toml
//! case = "cup.toml"                        # from where this file stands
//! set = ["tools.punch.friction=0.1"]       # of all designs; none when not given
//! one_at_a_time = false                    # true: each key by itself, not every combination
//!
//! [vary]                                   # every combination, the last key fastest
//! tools.die.shoulder = "4..10 mm/7"
//! friction = [0.04, 0.08, 0.12]
//!
//! [[together]]                             # keys that go together, one value each
//! blank.diameter = "100..120 mm/3"
//! tools.punch.travel = "30..36 mm/3"
//! ```

use super::plan::{How, Plan};
use super::{StudyError, Vary};
use crate::files::{self, Disk, Files};
use std::path::{Path, PathBuf};
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// The keys of a study.
const KEYS: [&str; 5] = ["case", "set", "one_at_a_time", "vary", "together"];

/// What every study says.
pub(super) struct Study {
    /// The whole file.
    pub document: DocumentMut,
    /// The case that it is of, from where the file stands.
    pub case: PathBuf,
    /// Overrides of all runs.
    pub set: Vec<String>,
}

impl Study {
    /// Reads a file that may have these keys.
    pub fn read(path: &Path, keys: &[&str]) -> Result<Self, StudyError> {
        let shown = path.display();
        let disk: &dyn Files = &Disk;
        let text = disk.text(path, files::CASE).map_err(|error| {
            StudyError::new(format!("cannot read {shown}: {error}"), "give a study file, or a case file with --vary")
        })?;
        let document: DocumentMut = text.parse().map_err(|error: toml_edit::TomlError| {
            let line = error.span().map_or(0, |span| 1 + text[..span.start].matches('\n').count());
            StudyError::new(format!("{shown}, line {line}: {}", error.message()), "a study is TOML, as a case file")
        })?;
        let wrong = |what: String| StudyError::new(format!("{shown}: {what}"), format!("it has {}", keys.join(", ")));
        if let Some((key, _)) = document.iter().find(|(key, _)| !keys.contains(key)) {
            return Err(wrong(format!("`{key}` is no key of this study")));
        }
        let case = document.get("case").and_then(Item::as_str).ok_or_else(|| wrong("it names no `case`".into()))?;
        let case = path.parent().unwrap_or(Path::new("")).join(case);
        let set = document.get("set").map_or(Ok(Vec::new()), |set| {
            let texts = set.as_array().map(|set| set.iter().map(|text| text.as_str().map(str::to_owned)).collect());
            texts
                .flatten()
                .ok_or_else(|| wrong("`set` is no list of texts such as \"tools.punch.friction=0.1\"".into()))
        })?;
        Ok(Self { document, case, set })
    }
}

/// Reads a study; overrides come behind its own.
///
/// # Errors
/// When it cannot be read, is no TOML, has a key that is none of a study, or as [`Plan::new`].
pub fn load(path: &Path, overrides: Vec<String>) -> Result<Plan, StudyError> {
    let Study { document, case, set } = Study::read(path, &KEYS)?;
    let wrong = |what: String| {
        let help = "a study has case, set, one_at_a_time, [vary] and [[together]]";
        StudyError::new(format!("{}: {what}", path.display()), help)
    };
    let how = match document.get("one_at_a_time").map(Item::as_bool) {
        None | Some(Some(false)) => How::Combined,
        Some(Some(true)) => How::OneAtATime,
        Some(None) => return Err(wrong("`one_at_a_time` is neither true nor false".into())),
    };
    let mut axes = Vec::new();
    if let Some(vary) = document.get("vary") {
        let table = vary.as_table_like().ok_or_else(|| wrong("`vary` is no table".into()))?;
        axes.extend(keys(table, "")?.into_iter().map(|vary| vec![vary]));
    }
    if let Some(together) = document.get("together") {
        let tables = together.as_array_of_tables().ok_or_else(|| wrong("`together` is written [[together]]".into()))?;
        for table in tables {
            axes.push(Vary::as_many(keys(table, "")?)?);
        }
    }
    if axes.iter().any(Vec::is_empty) {
        return Err(wrong("a [[together]] has no keys".into()));
    }
    Ok(Plan::new(case, set.into_iter().chain(overrides).collect(), axes)?.made(how))
}

/// All keys below a table, dotted, in their order.
fn keys(table: &dyn TableLike, above: &str) -> Result<Vec<Vary>, StudyError> {
    let mut all = Vec::new();
    for (key, item) in table.iter() {
        let key = if above.is_empty() { key.to_owned() } else { format!("{above}.{key}") };
        match item {
            Item::Value(Value::Array(values)) => {
                let texts: Vec<String> = values.iter().map(plain).collect();
                all.push(Vary::of(&key, &texts.join(","))?);
            }
            Item::Value(Value::InlineTable(table)) => all.extend(keys(table, &key)?),
            Item::Value(value) => all.push(Vary::of(&key, &plain(value))?),
            Item::Table(table) => all.extend(keys(table, &key)?),
            _ => return Err(StudyError::new(format!("{key} gives no values"), "write \"4..10 mm/7\" or [0.04, 0.08]")),
        }
    }
    Ok(all)
}

/// A value as it would stand on the command line.
fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.clone().decorated("", "").to_string(), str::to_owned)
}
