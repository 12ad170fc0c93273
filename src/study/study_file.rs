//! Study files: a sweep, a scatter or a fit as TOML.
//!
//! ```toml
//! case = "cup.toml"                        # relative to this file
//! set = ["tools.punch.friction=0.1"]       # overrides of all designs
//! one_at_a_time = false                    # sweep: each key by itself
//! runs = 1024                              # scatter: sample size
//! seed = 1                                 # scatter: seed of the sample
//! to = "curve.csv"                         # fit: measured curves
//!
//! [vary]                                   # as --vary has it; the last key varies fastest
//! tools.die.shoulder = "4..10 mm/7"
//! friction = [0.04, 0.08, 0.12]
//!
//! [[together]]                             # sweep: keys that move together
//! blank.radius = "50..60 mm/3"
//! tools.punch.travel = "30..36 mm/3"
//! ```

use super::base_case::read_text;
use super::{StudyError, fail};
use serde::{Deserialize, Deserializer};
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// Keys of every case, by which one is recognised.
const CASE_KEYS: [&str; 3] = ["blank", "tools", "material"];

/// A study; paths are relative to the working directory once it is loaded.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyFile {
    pub case: PathBuf,
    #[serde(default)]
    pub set: Vec<String>,
    #[serde(default)]
    pub one_at_a_time: bool,
    pub runs: Option<u64>,
    pub seed: Option<u32>,
    #[serde(default, deserialize_with = "one_or_many")]
    pub to: Vec<PathBuf>,
    /// `KEY=VALUES & KEY=VALUES`.
    #[serde(skip)]
    pub variables: Vec<String>,
    #[serde(default)]
    vary: Table,
    #[serde(default)]
    together: Vec<Table>,
}

impl StudyFile {
    /// Reads a study file, or a case file as a study without variables; `set` comes behind its own, `vary` replaces them.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String]) -> Result<Self, StudyError> {
        let shown = path.display();
        let text = read_text(path, "give a case file, or a study file")?;
        let is_case = toml::from_str::<Table>(&text)
            .map_or(true, |table| !table.contains_key("case") && CASE_KEYS.iter().any(|key| table.contains_key(*key)));
        let mut file = if is_case {
            Self::default()
        } else {
            Self::read(&text, path).map_err(|e| e.within(format!("{shown}: ")))?
        };
        if is_case {
            file.case = path.to_owned();
        }
        file.set.extend(set);
        if !vary.is_empty() {
            file.variables = vary.to_vec();
        }
        Ok(file)
    }

    fn read(text: &str, path: &Path) -> Result<Self, StudyError> {
        let wrong =
            |error: toml::de::Error| StudyError::new(error.to_string().trim_end(), "see `stampflow sweep --help`");
        let mut file: Self = toml::from_str(text).map_err(wrong)?;
        let beside = |other: &PathBuf| path.parent().unwrap_or(Path::new("")).join(other);
        (file.case, file.to) = (beside(&file.case), file.to.iter().map(beside).collect());
        if !file.case.exists() {
            let what = format!("there is no file {}", file.case.display());
            return fail(what, "`case` is the path of a case file, relative to the study file");
        }
        file.variables = pairs(&file.vary, "")?;
        for together in &file.together {
            match pairs(together, "")?.join(" & ") {
                none if none.is_empty() => return fail("a [[together]] has no keys", "give it two keys or more"),
                keys => file.variables.push(keys),
            }
        }
        Ok(file)
    }
}

fn one_or_many<'de, D: Deserializer<'de>>(paths: D) -> Result<Vec<PathBuf>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Paths {
        One(PathBuf),
        Many(Vec<PathBuf>),
    }
    Ok(match Paths::deserialize(paths)? {
        Paths::One(path) => vec![path],
        Paths::Many(paths) => paths,
    })
}

/// `KEY=VALUES` of every dotted key below a table.
fn pairs(table: &Table, above: &str) -> Result<Vec<String>, StudyError> {
    let plain = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let mut all = Vec::new();
    for (name, value) in table {
        let key = format!("{above}{name}");
        let values = match value {
            Value::Table(table) => {
                all.extend(pairs(table, &format!("{key}."))?);
                continue;
            }
            Value::Datetime(_) => {
                return fail(format!("{key} gives no values"), "write \"4..10 mm/7\" or [0.04, 0.08]");
            }
            Value::Array(values) => values.iter().map(plain).collect::<Vec<_>>().join(", "),
            value => plain(value),
        };
        all.push(format!("{key}={values}"));
    }
    Ok(all)
}
