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
use crate::case::files::{self, Disk, Files};
use std::path::{Path, PathBuf};
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// The keys of a study.
const KEYS: [&str; 5] = ["case", "set", "one_at_a_time", "vary", "together"];

/// Keys of every case, by which one is known.
const CASE: [&str; 2] = ["blank", "tools"];

/// What every study says.
pub(super) struct Study {
    /// The whole file.
    pub document: DocumentMut,
    /// The case that it is of, from where the file stands.
    pub case: PathBuf,
    /// Overrides of all runs.
    pub set: Vec<String>,
    /// The file as it is named, and its text.
    shown: String,
    text: String,
}

impl Study {
    /// Reads a file that may have these keys.
    pub fn read(path: &Path, keys: &[&str]) -> Result<Self, StudyError> {
        let shown = path.display();
        let disk: &dyn Files = &Disk;
        let text = disk.text(path, files::CASE).map_err(|error| {
            let help = error.remedy("give a study file, or a case file with --vary");
            StudyError::new(format!("cannot read {shown}: {error}"), help)
        })?;
        let document: DocumentMut = text.parse().map_err(|error: toml_edit::TomlError| {
            let line = error.span().map_or(0, |span| 1 + text[..span.start].matches('\n').count());
            StudyError::new(format!("{shown}, line {line}: {}", error.message()), "a study is TOML, as a case file")
        })?;
        let wrong = |what: String| StudyError::new(format!("{shown}{what}"), format!("it has {}", keys.join(", ")));
        if !document.contains_key("case") && CASE.iter().any(|key| document.contains_key(key)) {
            let what = format!("{shown} is a case, and nothing of it is varied");
            return Err(StudyError::new(what, "say what is: --vary KEY=VALUES, as often as needed"));
        }
        if let Some((key, _)) = document.iter().find(|(key, _)| !keys.contains(key)) {
            return Err(wrong(format!("{}: `{key}` is no key of this study", on_line(&text, key))));
        }
        let case = document.get("case").and_then(Item::as_str).ok_or_else(|| wrong(": it names no `case`".into()))?;
        let case = path.parent().unwrap_or(Path::new("")).join(case);
        if !case.exists() {
            let what = format!("{shown}{}: there is no file {}", on_line(&text, "case"), case.display());
            return Err(StudyError::new(what, "`case` is the path of a case file from where the study stands"));
        }
        let set = document.get("set").map_or(Ok(Vec::new()), |set| {
            let texts = set.as_array().map(|set| set.iter().map(|text| text.as_str().map(str::to_owned)).collect());
            texts
                .flatten()
                .ok_or_else(|| wrong(": `set` is no list of texts such as \"tools.punch.friction=0.1\"".into()))
        })?;
        let shown = shown.to_string();
        Ok(Self { document, case, set, shown, text })
    }

    /// A mistake in what it says of a key, with its place.
    fn of_key(&self, key: &str, error: StudyError) -> StudyError {
        match error {
            StudyError::Asked { what, help } => {
                StudyError::new(format!("{}{}: {what}", self.shown, on_line(&self.text, key)), help)
            }
            of_case => of_case,
        }
    }

    /// All keys below a table, dotted, in their order.
    fn keys(&self, table: &dyn TableLike, above: &str) -> Result<Vec<Vary>, StudyError> {
        let mut all = Vec::new();
        for (name, item) in table.iter() {
            let key = if above.is_empty() { name.to_owned() } else { format!("{above}.{name}") };
            let placed = |error| self.of_key(name, error);
            match item {
                Item::Value(Value::Array(values)) => {
                    let texts: Vec<String> = values.iter().map(plain).collect();
                    all.push(Vary::of(&key, &texts.join(", ")).map_err(placed)?);
                }
                Item::Value(Value::InlineTable(table)) => all.extend(self.keys(table, &key)?),
                Item::Value(value) => all.push(Vary::of(&key, &plain(value)).map_err(placed)?),
                Item::Table(table) => all.extend(self.keys(table, &key)?),
                _ => {
                    let what = format!("{key} gives no values");
                    return Err(placed(StudyError::new(what, "write \"4..10 mm/7\" or [0.04, 0.08]")));
                }
            }
        }
        Ok(all)
    }
}

/// Reads a study; overrides come behind its own.
///
/// # Errors
/// When it cannot be read, is no TOML, has a key that is none of a study, or as [`Plan::new`].
pub fn load(path: &Path, overrides: Vec<String>) -> Result<Plan, StudyError> {
    let study = Study::read(path, &KEYS)?;
    let document = &study.document;
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
        axes.extend(study.keys(table, "")?.into_iter().map(|vary| vec![vary]));
    }
    if let Some(together) = document.get("together") {
        let tables = together.as_array_of_tables().ok_or_else(|| wrong("`together` is written [[together]]".into()))?;
        for table in tables {
            axes.push(Vary::as_many(study.keys(table, "")?).map_err(|error| study.of_key("[together]", error))?);
        }
    }
    if axes.iter().any(Vec::is_empty) {
        return Err(wrong("a [[together]] has no keys".into()));
    }
    Ok(Plan::new(&study.case, study.set.iter().cloned().chain(overrides).collect(), axes)?.made(how))
}

/// `, line 7`, where a line begins with a key or with its table; nothing where none does.
fn on_line(text: &str, key: &str) -> String {
    let is_there = |line: &str| {
        let rest = line.trim_start().trim_start_matches('[').split('=').next().unwrap_or("");
        rest.split(['.', ']']).map(str::trim).any(|part| part == key.trim_matches(['[', ']']))
    };
    text.lines().position(is_there).map_or_else(String::new, |line| format!(", line {}", line + 1))
}

/// A value as it would stand on the command line.
fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.clone().decorated("", "").to_string(), str::to_owned)
}
