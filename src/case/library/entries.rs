//! Files of the library.

use crate::case::CaseError;
use crate::case::file;
use crate::case::thickness_tolerance::Standard;
use crate::material::BackStress;
use crate::material::hardening::HardeningTable;
use crate::model::Mode;
use crate::units::{Dimensioned, Stress};
use serde::Deserialize;
use serde::de::IgnoredAny;

macro_rules! texts {
    ($($name:literal)*) => {
        /// Name and text of every entry, by name.
        pub(super) const TEXTS: [(&str, &str); [$($name),*].len()] =
            [$(($name, include_str!(concat!($name, ".toml")))),*];
    };
}
texts! {
    "aa5754-o" "aa6016-t4" "aa6016a-surfalex" "aa6022-t4" "aisi304l-bar" "ap04xr" "chalmers-steel" "draw-die-steel"
    "drawing-steel" "if-steel" "osu-steel" "radioss-steel" "trip690" "woo-1968"
}

/// File of the library.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EntryFile {
    pub title: String,
    pub grade: String,
    pub licence: String,
    pub thickness: Option<String>,
    pub stands_for: Option<StandsFor>,
    pub scatter: Option<Class>,
    pub notes: Vec<String>,
    /// Points of the fits, for the tests.
    #[serde(default, rename = "measured")]
    _measured: IgnoredAny,
    pub elastoplastic: Option<Shifting>,
    pub material: file::Material,
    /// Measured points.
    pub forming_limit: Option<file::FormingLimit>,
}

/// Back-stresses, and the hardening law that they leave of the yield stress.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Shifting {
    pub kinematic: Vec<BackStress>,
    pub hardening: HardeningTable,
}

impl EntryFile {
    /// Material of the elasto-viscoplastic mode, where it is another one.
    pub fn elastoplastic(&self) -> Option<file::Material> {
        let Shifting { kinematic, hardening } = self.elastoplastic.clone()?;
        let mode = Some(Mode::ElastoViscoplastic);
        Some(file::Material { kinematic, hardening: Some(hardening), mode, ..self.material.clone() })
    }
}

/// Scatter of a class of sheets by its delivery standard: declared, never measured on a coil.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Class {
    strength: Option<[Stress; 2]>,
    /// Standard of its thickness tolerance.
    pub thickness: Option<Standard>,
    /// Source of the range of its strength.
    pub source: String,
}

impl Class {
    /// Least and largest tensile strength that the standard allows \[MPa\].
    pub fn strength(&self) -> Option<[f64; 2]> {
        self.strength.map(|ends| ends.map(Stress::value))
    }

    /// Half of that range over its middle \[–\].
    pub fn strength_share(&self) -> Option<f64> {
        self.strength().map(|[low, high]| (high - low) / (high + low))
    }
}

/// Grades of standards that a sheet may be taken for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StandsFor {
    /// Names of standards and mills, the usual one first.
    pub grades: Vec<String>,
    /// Reason: a source, or a declaration.
    pub because: String,
}

/// Parses the text of an entry.
pub(super) fn read(name: &str, text: &str) -> Result<EntryFile, CaseError> {
    let wrong = |what: &str| CaseError::bare(format!("{name}: {what}"), "mend the library".into());
    toml::from_str(text).map_err(|error: toml::de::Error| wrong(error.message()))
}
