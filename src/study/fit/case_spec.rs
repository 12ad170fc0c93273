//! What is fitted to what: from the command line, or a study file.
//!
//! ```toml
//! case = "cup.toml"                                    # from where this file stands
//! to = "curve.csv"                                     # or a list; those of the case's [[compare]] when not given
//!
//! [fit]
//! friction = [0.1, 0.01, 0.3]                          # start, low, high
//! material.hardening.swift.k = "500 in 300..800 MPa"
//! ```

use super::range::Range;
use super::target::Target;
use crate::case::files::{self, Disk, Files};
use crate::study::vary::counted;
use crate::study::{Readings, StudyError, Subject};
use std::path::{Path, PathBuf};
use toml_edit::{DocumentMut, Item, TableLike, Value};

/// What is fitted to what.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseFitSpec {
    /// The case.
    pub subject: Subject,
    /// Its keys.
    pub ranges: Vec<Range>,
    /// Measured curves; never empty.
    pub targets: Vec<Target>,
}

/// The keys of a study file that a fit has.
const KEYS: [&str; 4] = ["case", "set", "fit", "to"];

/// Reads a study file: `case`, `set`, `to` and `[fit]` with `key = [start, low, high]`. Overrides come behind its own, ranges and
/// curves in place of its own.
///
/// # Errors
/// When it cannot be read or something in it is wrong.
pub fn load(
    path: &Path,
    overrides: Vec<String>,
    ranges: Vec<Range>,
    to: &[Readings],
) -> Result<CaseFitSpec, StudyError> {
    let disk: &dyn Files = &Disk;
    let shown = path.display();
    let text = disk.text(path, files::CASE).map_err(|error| {
        StudyError::new(format!("cannot read {shown}: {error}"), "give a case file, or a study file with [fit]")
    })?;
    let document: Option<DocumentMut> =
        text.parse().ok().filter(|document: &DocumentMut| document.get("case").is_some());
    let (case, mut set, mut own, mut curves) = (path.to_owned(), Vec::new(), Vec::new(), Vec::new());
    let Some(document) = document else { return CaseFitSpec::new(case, overrides, ranges, to) };
    let wrong = |what: String| {
        StudyError::new(
            format!("{shown}: {what}"),
            "a study of a fit has case, set, to and [fit] with key = [start, low, high]",
        )
    };
    if let Some((key, _)) = document.iter().find(|(key, _)| !KEYS.contains(key)) {
        return Err(wrong(format!("`{key}` is no key of a fit")));
    }
    let beside = |name: &str| path.parent().unwrap_or(Path::new("")).join(name);
    let texts = |key: &str| match document.get(key) {
        None => Ok(Vec::new()),
        Some(item) => match (item.as_str(), item.as_array()) {
            (Some(text), _) => Some(vec![text.to_owned()]),
            (_, Some(array)) => array.iter().map(|text| text.as_str().map(str::to_owned)).collect::<Option<Vec<_>>>(),
            _ => None,
        }
        .ok_or_else(|| wrong(format!("`{key}` is no list of texts"))),
    };
    set.extend(texts("set")?);
    set.extend(overrides);
    curves.extend(texts("to")?.iter().map(|name| Readings::File(beside(name))));
    if let Some(fit) = document.get("fit") {
        let table = fit.as_table_like().ok_or_else(|| wrong("`fit` is no table".into()))?;
        keys(table, "", &mut own)?;
    }
    let case = beside(document.get("case").and_then(Item::as_str).ok_or_else(|| wrong("`case` is no text".into()))?);
    let ranges = if ranges.is_empty() { own } else { ranges };
    CaseFitSpec::new(case, set, ranges, if to.is_empty() { &curves } else { to })
}

/// All ranges below a table, dotted.
fn keys(table: &dyn TableLike, above: &str, all: &mut Vec<Range>) -> Result<(), StudyError> {
    for (key, item) in table.iter() {
        let key = if above.is_empty() { key.to_owned() } else { format!("{above}.{key}") };
        let plain =
            |value: &Value| value.as_str().map_or_else(|| value.clone().decorated("", "").to_string(), str::to_owned);
        match item {
            Item::Value(Value::Array(values)) => {
                let texts: Vec<String> = values.iter().map(plain).collect();
                let [start, low, high] = texts.as_slice() else {
                    return Err(StudyError::new(counted(&key, texts.len()), "write [START, LOW, HIGH]"));
                };
                all.push(Range::of_three(&key, [start, low, high])?);
            }
            Item::Value(Value::InlineTable(table)) => keys(table, &key, all)?,
            Item::Value(value) => all.push(Range::of(&key, &plain(value))?),
            Item::Table(table) => keys(table, &key, all)?,
            _ => return Err(StudyError::new(format!("{key} gives no range"), "write [START, LOW, HIGH]")),
        }
    }
    Ok(())
}

impl CaseFitSpec {
    /// Of a case with overrides; its own comparisons are the curves where none are given.
    ///
    /// # Errors
    /// When the case cannot be read, a key is not there or given twice, or there is nothing to fit or to fit to.
    pub fn new(case: PathBuf, overrides: Vec<String>, ranges: Vec<Range>, to: &[Readings]) -> Result<Self, StudyError> {
        Self::of(Subject::new(case, overrides)?, ranges, to)
    }

    /// Of a case that was read.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn of(subject: Subject, ranges: Vec<Range>, to: &[Readings]) -> Result<Self, StudyError> {
        if ranges.is_empty() {
            return Err(StudyError::new(
                "no key is to be fitted",
                "give --vary \"tools.punch.friction=0.1 in 0.01..0.3\"",
            ));
        }
        if let Some(i) = (1..ranges.len()).find(|&i| ranges[..i].iter().any(|other| other.key == ranges[i].key)) {
            return Err(StudyError::new(format!("{} is given twice", ranges[i].key), "give each key once"));
        }
        let targets = match to {
            [] => Target::of(&subject.case(&[])?),
            curves => curves.iter().map(Target::load).collect::<Result<_, _>>()?,
        };
        if targets.is_empty() {
            let what = "there is no curve to fit to, and the case has no [[compare]] with one";
            return Err(StudyError::new(what, "give --to curve.csv"));
        }
        for range in &ranges {
            subject.case(&range.settings(range.start))?;
        }
        Ok(Self { subject, ranges, targets })
    }

    /// The overrides that make the case of some values.
    pub(super) fn settings(&self, values: &[f64]) -> Vec<String> {
        self.ranges.iter().zip(values).flat_map(|(range, value)| range.settings(*value)).collect()
    }
}
