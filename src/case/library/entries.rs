//! The files of the library.

use crate::case::CaseError;
use crate::case::file;
use serde::Deserialize;

/// Name and text of every entry, by name.
pub(super) const TEXTS: [(&str, &str); 10] = [
    ("aa6016-t4", include_str!("aa6016-t4.toml")),
    ("aa6016a-surfalex", include_str!("aa6016a-surfalex.toml")),
    ("aa6022-t4", include_str!("aa6022-t4.toml")),
    ("ap04xr", include_str!("ap04xr.toml")),
    ("chalmers-steel", include_str!("chalmers-steel.toml")),
    ("draw-die-steel", include_str!("draw-die-steel.toml")),
    ("drawing-steel", include_str!("drawing-steel.toml")),
    ("osu-steel", include_str!("osu-steel.toml")),
    ("radioss-steel", include_str!("radioss-steel.toml")),
    ("woo-1968", include_str!("woo-1968.toml")),
];

/// What a file of the library says.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EntryFile {
    pub title: String,
    pub grade: String,
    pub licence: String,
    pub thickness: Option<String>,
    pub stands_for: Option<StandsFor>,
    pub notes: Vec<String>,
    pub material: file::Material,
    /// Measured points.
    pub forming_limit: Option<file::FormingLimit>,
}

/// The grades of standards that a sheet may be taken for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StandsFor {
    /// As standards and mills call them, the usual one first.
    pub grades: Vec<String>,
    /// Why it may: a source, or what is declared.
    pub because: String,
}

/// What the text of an entry says.
pub(super) fn read(name: &str, text: &str) -> Result<EntryFile, CaseError> {
    toml::from_str(text)
        .map_err(|error| CaseError::bare(format!("{name}: {}", error.message()), "mend the library".into()))
}
