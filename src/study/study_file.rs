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
use crate::case::files::{self, Disk, Files};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use toml::{Table, Value};

/// Keys of every case, by which one is recognised.
const CASE_KEYS: [&str; 3] = ["blank", "tools", "material"];

/// A study as its file has it.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StudyFile {
    /// The case; relative to the working directory once loaded.
    pub case: PathBuf,
    /// Overrides of all designs.
    #[serde(default)]
    pub set: Vec<String>,
    /// Whether a sweep changes each key by itself.
    #[serde(default)]
    pub one_at_a_time: bool,
    /// Sample size of a scatter.
    pub runs: Option<u64>,
    /// Seed of a scatter.
    pub seed: Option<u32>,
    #[serde(default)]
    to: Curves,
    #[serde(default)]
    vary: Table,
    #[serde(default)]
    together: Vec<Table>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(untagged)]
enum Curves {
    One(PathBuf),
    Many(Vec<PathBuf>),
}

impl Default for Curves {
    fn default() -> Self {
        Self::Many(Vec::new())
    }
}

impl StudyFile {
    /// Reads a study file, or a case file as a study without variables; `set` and `vary` come behind its own.
    ///
    /// # Errors
    /// When it cannot be read or has a key that no study has.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String]) -> Result<(Self, Vec<String>), StudyError> {
        let shown = path.display();
        let disk: &dyn Files = &Disk;
        let text = disk.text(path, files::CASE).map_err(|error| {
            let help = error.remedy("give a case file, or a study file");
            StudyError::new(format!("cannot read {shown}: {error}"), help)
        })?;
        let is_case = toml::from_str::<Table>(&text)
            .map_or(true, |table| !table.contains_key("case") && CASE_KEYS.iter().any(|key| table.contains_key(*key)));
        let mut file = if is_case {
            Self { case: path.to_owned(), ..Self::default() }
        } else {
            let mut file: Self = toml::from_str(&text).map_err(|error| {
                StudyError::new(format!("{shown}: {}", error.to_string().trim_end()), "see `stampflow sweep --help`")
            })?;
            file.case = beside(path, &file.case);
            if !file.case.exists() {
                let what = format!("{shown}: there is no file {}", file.case.display());
                return Err(StudyError::new(what, "`case` is the path of a case file, relative to the study file"));
            }
            file.to = Curves::Many(file.curves().iter().map(|curve| beside(path, curve)).collect());
            file
        };
        file.set.extend(set);
        let place = |error: StudyError| match error {
            StudyError::Request { what, help } => StudyError::new(format!("{shown}: {what}"), help),
            of_case @ StudyError::Case(_) => of_case,
        };
        let mut all = pairs(&file.vary, "").map_err(place)?;
        for together in &file.together {
            let keys = pairs(together, "").map_err(place)?;
            if keys.is_empty() {
                return Err(place(StudyError::new("a [[together]] has no keys", "give it two keys or more")));
            }
            all.push(keys.join(" & "));
        }
        if !vary.is_empty() {
            all = vary.to_vec();
        }
        Ok((file, all))
    }

    /// Measured curves of a fit.
    pub fn curves(&self) -> &[PathBuf] {
        match &self.to {
            Curves::One(path) => std::slice::from_ref(path),
            Curves::Many(paths) => paths,
        }
    }
}

fn beside(file: &Path, other: &Path) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).join(other)
}

/// `KEY=VALUES` of every dotted key below a table.
fn pairs(table: &Table, above: &str) -> Result<Vec<String>, StudyError> {
    let mut all = Vec::new();
    for (name, value) in table {
        let key = if above.is_empty() { name.clone() } else { format!("{above}.{name}") };
        match value {
            Value::Table(table) => all.extend(pairs(table, &key)?),
            Value::Array(values) => {
                let texts: Vec<String> = values.iter().map(plain).collect();
                all.push(format!("{key}={}", texts.join(", ")));
            }
            Value::String(_) | Value::Integer(_) | Value::Float(_) | Value::Boolean(_) => {
                all.push(format!("{key}={}", plain(value)));
            }
            Value::Datetime(_) => {
                return Err(StudyError::new(format!("{key} gives no values"), "write \"4..10 mm/7\" or [0.04, 0.08]"));
            }
        }
    }
    Ok(all)
}

fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
