//! Files of the library, and the one that a word means.

use crate::case::CaseError;
use crate::case::file;
use crate::material::BackStress;
use crate::material::hardening::HardeningTable;
use crate::model::Mode;
use crate::units::{Dimensioned, Stress, did_you_mean};
use serde::Deserialize;
use serde::de::{DeserializeOwned, IgnoredAny};
use std::collections::BTreeMap;

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
    elastoplastic: Option<Shifting>,
    pub material: file::Material,
    pub forming_limit: Option<file::FormingLimit>,
}

/// Back-stresses, and the hardening law that they leave of the yield stress.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Shifting {
    kinematic: Vec<BackStress>,
    hardening: HardeningTable,
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
    thickness: Option<String>,
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

    /// Standard of its thickness.
    pub fn thickness(&self) -> Option<ThicknessStandard> {
        let mut standards: BTreeMap<String, _> = read("standards", include_str!("standards.toml")).ok()?;
        standards.remove(self.thickness.as_ref()?)
    }
}

/// Thickness tolerances by a standard.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ThicknessStandard {
    /// Source of its numbers.
    pub source: String,
    least: f64,
    rows: Vec<[f64; 2]>,
}

impl ThicknessStandard {
    /// Tolerance of a thickness to either side \[mm\]; `None` if the standard does not have it.
    pub fn tolerance(&self, thickness: f64) -> Option<f64> {
        let [_, tolerance] = self.rows.iter().find(|[up_to, _]| thickness <= *up_to)?;
        (thickness >= self.least).then_some(*tolerance)
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

pub(super) fn read<T: DeserializeOwned>(name: &str, text: &str) -> Result<T, CaseError> {
    let wrong = |what: &str| CaseError::bare(format!("{name}: {what}"), "mend the library".into());
    toml::from_str(text).map_err(|error: toml::de::Error| wrong(error.message()))
}

pub(super) struct LibrarySheet {
    pub name: &'static str,
    /// Its file, as text and as read.
    pub text: &'static str,
    pub file: EntryFile,
    /// Reason of the choice, if the word is not its name.
    pub note: Option<String>,
}

/// The sheet of a name; else the one that stands for a grade; else the only one whose name or grade begins so.
/// The error is a message and a remedy.
pub(super) fn find(word: &str) -> Result<LibrarySheet, [String; 2]> {
    // `EN AW-6016` is `enaw6016`.
    let plain = |word: &str| -> String {
        word.chars().filter(|c| c.is_alphanumeric() || *c == '.').flat_map(char::to_lowercase).collect()
    };
    let wanted = plain(word);
    let (mut exact, mut begins) = (Vec::new(), Vec::new());
    let texts = TEXTS.iter().position(|(name, _)| *name == word).map_or(&TEXTS[..], |i| &TEXTS[i..=i]);
    for &(name, text) in texts {
        let file: EntryFile = read(name, text).map_err(|error| [error.to_string(), String::new()])?;
        if name == word {
            return Ok(LibrarySheet { name, text, file, note: None });
        }
        let grades = file.stands_for.iter().flat_map(|stands| &stands.grades);
        let known: Vec<String> = grades.map(|grade| plain(grade)).chain([plain(name)]).collect();
        let note = match plain(name).starts_with(&wanted) || file.stands_for.is_none() {
            false => format!("material {word}: {name} stands for it, as `stampflow materials {name}` explains"),
            true => format!("material {word} read as {name}"),
        };
        let is_begin = !wanted.is_empty() && known.iter().any(|known| known.starts_with(&wanted));
        let sheet = LibrarySheet { name, text, file, note: Some(note) };
        if known.contains(&wanted) {
            exact.push(sheet);
        } else if is_begin {
            begins.push(sheet);
        }
    }
    let mut candidates = if exact.is_empty() { begins } else { exact };
    let names: Vec<&str> = candidates.iter().map(|sheet| sheet.name).collect();
    match names[..] {
        [_] => Ok(candidates.remove(0)),
        [] => {
            let names = TEXTS.map(|(name, _)| name);
            let (near, names) = (did_you_mean(word, names.iter().copied()), names.join(", "));
            let help =
                format!("{near}known materials: {names}; `stampflow materials` says which grades they stand for");
            Err([format!("the library has no material \"{word}\""), help])
        }
        _ => Err([format!("\"{word}\" may be {}", names.join(" or ")), "write the whole name".into()]),
    }
}
