//! Sources of reference curves: `sources.toml` in their folder, one table per file name.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// The file of a folder that names the sources of the others.
pub const SOURCES: &str = "sources.toml";

/// Kinds of reference as a reader is told them, the hardest proof first.
pub const KINDS: [&str; 5] = ["experiment", "producer", "benchmark", "cross-check", "closed form"];

/// Provenance of one reference file.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Source {
    /// Author, title, year, figure.
    pub citation: String,
    /// One of [`KINDS`], a benchmark and a cross-check with "numerical" before it, a producer's rule; or what else it is.
    pub kind: String,
    /// A: read in the named source; B: one source and an arithmetic check; C: assumption.
    pub grade: String,
    /// How far the values themselves may be off, in words.
    pub scatter: Option<String>,
}

impl Source {
    /// The source of a reference file, of those that the text of a `sources.toml` names; `None` where it is not among them.
    ///
    /// # Errors
    /// When the text is not one table per file with citation, kind, grade and, if known, scatter.
    pub fn of(file: &str, sources: &str) -> Result<Option<Self>, toml::de::Error> {
        toml::from_str(sources).map(|mut sources: BTreeMap<String, Self>| sources.remove(file))
    }

    /// The kind in short: of a benchmark and a cross-check, which are numerical here, without that word; the rule of a producer
    /// by the producer.
    pub fn kind(&self) -> String {
        let short = self.kind.strip_prefix("numerical ").unwrap_or(&self.kind);
        let short = short.strip_suffix("'s rule").unwrap_or(short);
        KINDS.iter().find(|known| **known == short).map_or_else(|| short.to_owned(), |known| (*known).into())
    }
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
