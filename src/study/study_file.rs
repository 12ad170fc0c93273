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

use super::StudyError;
use super::base_case::read_text;
use super::error::fail;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// Keys of every case, by which one is recognised.
const CASE_KEYS: [&str; 3] = ["blank", "tools", "material"];

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    case: PathBuf,
    #[serde(default)]
    set: Vec<String>,
    #[serde(default)]
    one_at_a_time: bool,
    runs: Option<u64>,
    seed: Option<u32>,
    to: Option<Curves>,
    #[serde(default)]
    vary: Table,
    #[serde(default)]
    together: Vec<Table>,
}

#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Curves {
    One(PathBuf),
    Many(Vec<PathBuf>),
}

/// A study; paths are relative to the working directory.
#[derive(Debug)]
pub(super) struct StudyFile {
    pub case: PathBuf,
    pub set: Vec<String>,
    pub one_at_a_time: bool,
    pub runs: Option<u64>,
    pub seed: Option<u32>,
    pub to: Vec<PathBuf>,
    /// `KEY=VALUES & KEY=VALUES`.
    pub vary: Vec<String>,
}

impl StudyFile {
    /// Reads a study file, or a case file as a study without variables; `set` comes behind its own, `vary` replaces them.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String]) -> Result<Self, StudyError> {
        let shown = path.display();
        let text = read_text(path, "give a case file, or a study file")?;
        let is_case = toml::from_str::<Table>(&text)
            .map_or(true, |table| !table.contains_key("case") && CASE_KEYS.iter().any(|key| table.contains_key(*key)));
        if is_case {
            let (case, vary) = (path.to_owned(), vary.to_vec());
            return Ok(Self { case, set, one_at_a_time: false, runs: None, seed: None, to: Vec::new(), vary });
        }
        let written: Written = toml::from_str(&text).map_err(|error| {
            StudyError::new(format!("{shown}: {}", error.to_string().trim_end()), "see `stampflow sweep --help`")
        })?;
        let beside = |other: &PathBuf| path.parent().unwrap_or(Path::new("")).join(other);
        let case = beside(&written.case);
        if !case.exists() {
            let what = format!("{shown}: there is no file {}", case.display());
            return fail(what, "`case` is the path of a case file, relative to the study file");
        }
        let to = match &written.to {
            None => Vec::new(),
            Some(Curves::One(path)) => vec![beside(path)],
            Some(Curves::Many(paths)) => paths.iter().map(beside).collect(),
        };
        let mut own = pairs(&written.vary, "").map_err(|error| error.within(format!("{shown}: ")))?;
        for together in &written.together {
            let keys = pairs(together, "").map_err(|error| error.within(format!("{shown}: ")))?;
            if keys.is_empty() {
                return fail(format!("{shown}: a [[together]] has no keys"), "give it two keys or more");
            }
            own.push(keys.join(" & "));
        }
        let Written { one_at_a_time, runs, seed, .. } = written;
        let vary = if vary.is_empty() { own } else { vary.to_vec() };
        Ok(Self { case, set: [written.set, set].concat(), one_at_a_time, runs, seed, to, vary })
    }
}

/// `KEY=VALUES` of every dotted key below a table.
fn pairs(table: &Table, above: &str) -> Result<Vec<String>, StudyError> {
    let plain = |value: &Value| value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let mut all = Vec::new();
    for (name, value) in table {
        let key = format!("{above}{name}");
        match value {
            Value::Table(table) => all.extend(pairs(table, &format!("{key}."))?),
            Value::Array(values) => {
                all.push(format!("{key}={}", values.iter().map(plain).collect::<Vec<_>>().join(", ")));
            }
            Value::Datetime(_) => {
                return fail(format!("{key} gives no values"), "write \"4..10 mm/7\" or [0.04, 0.08]");
            }
            value => all.push(format!("{key}={}", plain(value))),
        }
    }
    Ok(all)
}
