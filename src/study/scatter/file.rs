//! A scatter as a file.
//!
//! ```toml
//! case = "cup.toml"                        # from where this file stands
//! set = ["tools.punch.friction=0.1"]       # of all runs; none when not given
//! runs = 1024                              # points of the sample
//! seed = 1
//! correlate = ["material.hardening.swift.k,material.hardening.swift.n=-0.8"]
//!
//! [scatter]                                # as --vary has it; what is declared when not given
//! friction = "uniform 0.05..0.12"
//! blank.thickness = "normal 1 ± 0.02 mm in 0.95..1.05 mm"
//! ```

use super::{Asked, Correlation};
use crate::case::files::{self, Disk, Files};
use crate::study::StudyError;
use crate::study::file::Study;
use std::path::{Path, PathBuf};
use toml_edit::{Item, TableLike};

/// The keys of a scatter.
const KEYS: &[&str] = &["case", "set", "runs", "seed", "correlate", "scatter"];

/// What a file asks for: the case, overrides of all runs, and the scatter. A file without the key `case` is a case.
///
/// # Errors
/// When it cannot be read, or has what no scatter has.
pub fn load(path: &Path) -> Result<(PathBuf, Vec<String>, Asked), StudyError> {
    let mut asked = Asked::default();
    if !is_study(path) {
        return Ok((path.to_owned(), Vec::new(), asked));
    }
    let Study { document, case, set, .. } = Study::read(path, KEYS)?;
    let wrong = |what: &str| {
        let help = "a scatter has case, set, runs, seed, correlate and [scatter]";
        StudyError::new(format!("{}: {what}", path.display()), help)
    };
    if let Some(runs) = document.get("runs") {
        asked.points = whole(runs).ok_or_else(|| wrong("`runs` is no whole number"))?;
    }
    if let Some(seed) = document.get("seed") {
        let seed = whole(seed).and_then(|seed| u32::try_from(seed).ok());
        asked.seed = seed.ok_or_else(|| wrong("`seed` is no whole number from 0 to 4294967295"))?;
    }
    if let Some(pairs) = document.get("correlate") {
        let pairs = pairs.as_array().ok_or_else(|| wrong("`correlate` is no list of texts such as \"a,b=-0.8\""))?;
        for pair in pairs {
            let pair = pair.as_str().ok_or_else(|| wrong("`correlate` has what is no text"))?;
            asked.correlations.push(Correlation::read(pair)?);
        }
    }
    if let Some(scatter) = document.get("scatter") {
        let table = scatter.as_table_like().ok_or_else(|| wrong("`scatter` is no table"))?;
        keys(table, "", &mut asked.vary)
            .map_err(|key| wrong(&format!("{key} is no text such as \"normal 1 ± 0.02 mm\"")))?;
    }
    Ok((case, set, asked))
}

/// Whether a file is a study; what cannot be read is told where it is read as a case.
fn is_study(path: &Path) -> bool {
    let disk: &dyn Files = &Disk;
    let document = disk.text(path, files::CASE).ok().and_then(|text| text.parse::<toml_edit::DocumentMut>().ok());
    document.is_some_and(|document| document.contains_key("case"))
}

fn whole(item: &Item) -> Option<u64> {
    item.as_integer().and_then(|number| number.try_into().ok())
}

/// All keys below a table, dotted, in their order; or the one that is no text.
fn keys(table: &dyn TableLike, above: &str, all: &mut Vec<(String, String)>) -> Result<(), String> {
    for (key, item) in table.iter() {
        let key = if above.is_empty() { key.to_owned() } else { format!("{above}.{key}") };
        match (item.as_str(), item.as_table_like()) {
            (Some(text), _) => all.push((key, text.to_owned())),
            (_, Some(table)) => keys(table, &key, all)?,
            _ => return Err(key),
        }
    }
    Ok(())
}
