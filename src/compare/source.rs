//! Where reference curves come from: `sources.toml` in their folder, one table per file name.

use super::CompareError;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;
use std::path::Path;

/// Provenance of one reference file.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Author, title, year, figure.
    pub citation: String,
    /// Experiment, closed form, numerical benchmark, ...
    pub kind: String,
    /// A: read in the named source; B: one source and an arithmetic check; C: assumption.
    pub grade: String,
    /// How far the values themselves may be off, in words.
    pub scatter: Option<String>,
}

/// The source of a reference file; `None` when its folder does not tell.
pub(super) fn of(reference: &Path) -> Result<Option<Source>, CompareError> {
    let path = reference.with_file_name("sources.toml");
    let text = match std::fs::read_to_string(&path) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(source) => return Err(CompareError::Read { path, source }),
    };
    let mut sources: BTreeMap<String, Source> =
        toml::from_str(&text).map_err(|source| CompareError::Sources { path, source })?;
    Ok(reference.file_name().and_then(|name| sources.remove(name.to_string_lossy().as_ref())))
}

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({}, grade {}", self.citation.trim_end_matches('.'), self.kind, self.grade)?;
        if let Some(scatter) = &self.scatter {
            write!(f, ", scatter {scatter}")?;
        }
        f.write_str(")")
    }
}
