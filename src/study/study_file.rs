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
//! ```

use super::{base_case::read_text, *};
use serde::Deserialize;
use toml::{Table, Value};

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
    to: Option<Value>,
    #[serde(skip)]
    pub curves: Vec<PathBuf>,
    /// `KEY=VALUES`.
    #[serde(skip)]
    pub variables: Vec<String>,
    #[serde(default)]
    vary: Table,
}

impl StudyFile {
    /// Reads a study file, or a case file as a study without variables; `set` comes behind its own, `vary` replaces them.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String]) -> Result<Self> {
        let text = read_text(path, "give a case file, or a study file")?;
        let is_case = toml::from_str::<Table>(&text)
            .map_or(true, |table| !table.contains_key("case") && CASE_KEYS.iter().any(|key| table.contains_key(*key)));
        let mut file = match is_case {
            true => Self { case: path.to_owned(), ..Self::default() },
            false => Self::read(&text, path).map_err(|e| e.within(format!("{}: ", path.display())))?,
        };
        file.set.extend(set);
        if !vary.is_empty() {
            file.variables = vary.to_vec();
        }
        Ok(file)
    }

    fn read(text: &str, path: &Path) -> Result<Self> {
        // Messages quote lines of studies only.
        let is_study = toml::from_str::<Table>(text).is_ok_and(|table| table.contains_key("case"));
        let wrong = |error: toml::de::Error| {
            let what = if is_study { error.to_string() } else { error.message().to_owned() };
            StudyError::new(what.trim_end(), "see `stampflow sweep --help`")
        };
        let mut file: Self = toml::from_str(text).map_err(wrong)?;
        let beside = |other: &PathBuf| path.parent().unwrap_or(Path::new("")).join(other);
        file.case = beside(&file.case);
        let paths = |to: &Value| if let Value::Array(all) = to { all.clone() } else { vec![to.clone()] };
        file.curves = file.to.iter().flat_map(paths).map(|path| beside(&plain(&path).into())).collect();
        let help = "`case` is the path of a case file, relative to the study file";
        ensure(file.case.exists(), format!("there is no file {}", file.case.display()), help)?;
        file.variables = pairs(&file.vary, "")?;
        Ok(file)
    }
}

fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn pairs(table: &Table, above: &str) -> Result<Vec<String>> {
    let mut all = Vec::new();
    for (name, value) in table {
        let key = format!("{above}{name}");
        match value {
            Value::Table(table) => all.extend(pairs(table, &format!("{key}."))?),
            Value::Datetime(_) => {
                return fail(format!("{key} gives no values"), "write \"4..10 mm/7\" or [0.04, 0.08]");
            }
            Value::Array(values) => all.push(format!("{key}={}", joined(values.iter().map(plain), ", "))),
            value => all.push(format!("{key}={}", plain(value))),
        }
    }
    Ok(all)
}
