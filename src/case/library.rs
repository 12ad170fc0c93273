//! Built-in materials: one file of `library/` each, every number with its source.

use super::file::{self, CaseFile};
use super::files::{Disk, Folder};
use super::sources::{Sheets, Sources, Thickness};
use super::{CaseError, source::Source};
use crate::forming_limit::{Curve, Sheet, uniform_strain};
use crate::material::flow::ROOM_TEMPERATURE;
use crate::material::hardening::HardeningTable;
use crate::material::{BackStress, Material};
use crate::model::Mode;
use crate::units::{Dimensioned, Stress, did_you_mean};
use serde::Deserialize;
use serde::de::{DeserializeOwned, IgnoredAny};
use std::path::Path;

/// Plastic strain of the proof stress \[–\].
const PROOF: f64 = 0.002;

macro_rules! texts {
    ($($name:literal)*) => {
        /// Name and text of every entry, by name.
        const TEXTS: [(&str, &str); [$($name),*].len()] =
            [$(($name, include_str!(concat!("library/", $name, ".toml")))),*];
    };
}
texts! {
    "aa5754-o" "aa6016-t4" "aa6016a-surfalex" "aa6022-t4" "aisi304l-bar" "ap04xr" "chalmers-steel" "draw-die-steel"
    "drawing-steel" "if-steel" "osu-steel" "radioss-steel" "stainless-304" "stainless-430" "trip690" "woo-1968"
}

/// Description of a sheet, its source and its numbers: a file of the library.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Description in one line.
    pub title: String,
    /// Grade of `reference_data/sources.toml`: A, read in the named source; B, read where that is quoted; C, the hardening is
    /// assumed.
    pub grade: String,
    /// Terms of use of the numbers.
    pub licence: String,
    /// Thickness of the sheet that the numbers are of.
    pub thickness: Option<String>,
    /// Grades that it stands for.
    pub stands_for: Option<StandsFor>,
    /// Scatter of its class by a standard.
    #[serde(rename = "scatter")]
    pub class: Option<Class>,
    /// Remarks on the numbers.
    pub notes: Vec<String>,
    /// Points of the fits, for the tests.
    #[serde(default, rename = "measured")]
    _measured: IgnoredAny,
    elastoplastic: Option<Shifting>,
    material: file::Material,
    forming_limit: Option<file::FormingLimit>,
}

/// Back-stresses, and the hardening law that they leave of the yield stress.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Shifting {
    kinematic: Vec<BackStress>,
    hardening: HardeningTable,
}

impl Description {
    /// Author, year and place of the numbers.
    pub fn source(&self) -> &str {
        self.material.source.as_deref().unwrap_or_default()
    }

    /// Material of the elasto-viscoplastic mode, where it is another one.
    fn elastoplastic(&self) -> Option<file::Material> {
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
    /// Source of the range of its strength.
    pub source: String,
}

impl Class {
    /// Least and largest tensile strength that the standard allows \[MPa\].
    pub fn strength(&self) -> Option<[f64; 2]> {
        self.strength.map(|ends| ends.map(Stress::value))
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

fn read<T: DeserializeOwned>(name: &str, text: &str) -> Result<T, CaseError> {
    let wrong = |what: &str| CaseError::bare(format!("{name}: {what}"), "mend the library".into());
    toml::from_str(text).map_err(|error: toml::de::Error| wrong(error.message()))
}

struct LibrarySheet {
    name: &'static str,
    /// Its file, as text and as read.
    text: &'static str,
    file: Description,
    /// Reason of the choice, if the word is not its name.
    note: Option<String>,
}

/// The sheet of a name; else the one that stands for a grade; else the only one whose name or grade begins so.
/// The error is a message and a remedy.
fn find(word: &str) -> Result<LibrarySheet, [String; 2]> {
    // `EN AW-6016` is `enaw6016`.
    let plain = |word: &str| -> String {
        word.chars().filter(|c| c.is_alphanumeric() || *c == '.').flat_map(char::to_lowercase).collect()
    };
    let wanted = plain(word);
    let (mut exact, mut begins) = (Vec::new(), Vec::new());
    let texts = TEXTS.iter().position(|(name, _)| *name == word).map_or(&TEXTS[..], |i| &TEXTS[i..=i]);
    for &(name, text) in texts {
        let file: Description = read(name, text).map_err(|error| [error.to_string(), String::new()])?;
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

/// Material of the library.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name in a case.
    pub name: &'static str,
    /// Its file.
    pub about: Description,
    /// Material of a case.
    pub material: Material,
    /// Material of the elasto-viscoplastic mode, if it has back-stresses there.
    pub elastoplastic: Option<Material>,
    /// Measured forming limit.
    pub measured_limit: Option<Curve>,
    /// `[material]` table, to paste into a case.
    pub text: &'static str,
}

impl Entry {
    /// Uniform strain of the hardening law, n of a power law; `None` if the law has no load maximum \[–\].
    pub fn n(&self) -> Option<f64> {
        uniform_strain(&Sheet { material: &self.material, thickness: 1.0, temperature: ROOM_TEMPERATURE }).ok()
    }

    /// Proof stress: the law's stress at 0.2 % of plastic strain \[MPa\].
    pub fn proof_stress(&self) -> f64 {
        self.material.hardening.at(PROOF).stress
    }

    /// Tensile strength: force over the initial section at Considère's load maximum \[MPa\]; `None` if the law has none.
    pub fn tensile_strength(&self) -> Option<f64> {
        let strain = self.n()?;
        Some(self.material.hardening.at(strain).stress * (-strain).exp())
    }

    /// Uniform elongation, the change of length over the initial one at Considère's load maximum \[–\]; `None` if the law
    /// has none.
    pub fn uniform_elongation(&self) -> Option<f64> {
        Some(self.n()?.exp_m1())
    }
}

/// Returns every material, by name.
///
/// # Errors
/// Never with the shipped library, whose entries are tested.
pub fn materials() -> Result<Vec<Entry>, CaseError> {
    TEXTS.iter().map(|(name, text)| entry(name, text)).collect()
}

/// Returns the names of all materials.
pub fn names() -> impl Iterator<Item = &'static str> {
    TEXTS.iter().map(|(name, _)| *name)
}

/// Returns the material of a name, of a grade that it stands for, or whose name alone begins so.
/// Fails when there is none or more than one; the error proposes the nearest.
pub fn material(name: &str) -> Result<Entry, CaseError> {
    let sheet = find(name).map_err(|[what, help]| CaseError::bare(what, help))?;
    entry(sheet.name, sheet.text)
}

/// Fills the keys that a case leaves open of the material that it names.
pub(super) fn complete(file: &mut CaseFile, source: &Source) -> Result<Sources, CaseError> {
    let Some(written) = file.material.name.clone() else { return Ok(Sources::default()) };
    let known = find(&written).map_err(|[what, help]| source.error("material.name", what, help))?;
    let (name, elastoplastic) = (known.name, known.file.elastoplastic());
    let Description { material: sheet, thickness, forming_limit, .. } = known.file;
    let origin = sheet.source.clone().unwrap_or_default();
    known.note.into_iter().chain([format!("material {name}: {origin}")]).for_each(|note| source.note(note));
    let keys = ["young", "poisson", "anisotropy", "yield_condition", "rate", "softening", "hardening"];
    let replaced = source.written("material", &keys);
    let own_hardening = replaced.contains(&"hardening");
    let is_wanted = match &file.forming_limit {
        Some(own) => own.measured == Some(true) && own.points.is_none(),
        None => !own_hardening,
    };
    if let Some(measured) = forming_limit.filter(|_| is_wanted) {
        let own = file.forming_limit.take().unwrap_or_else(|| measured.clone());
        let strain = own.strain.or(measured.strain);
        file.forming_limit = Some(file::FormingLimit { points: measured.points, strain, measured: None, ..own });
        source.note(format!("forming limit: the measured points of {name}"));
    }
    let own = &mut file.material;
    let sheets = Sheets::new(name, own_hardening, own, &sheet);
    if own.young.is_none() && own.poisson.is_none() {
        (own.young, own.poisson) = (sheet.young, sheet.poisson);
    }
    own.anisotropy = own.anisotropy.or(sheet.anisotropy);
    // The model of voids is made for Hill's condition.
    own.yield_condition = own.yield_condition.or(sheet.yield_condition.filter(|_| own.voids.is_none()));
    own.rate = own.rate.or(sheet.rate);
    own.softening = own.softening.or(sheet.softening);
    if own.fracture.is_none() {
        (own.fracture, own.fracture_source) = (sheet.fracture, sheet.fracture_source.clone());
    }
    if !own_hardening {
        let shifts = own.mode == Some(Mode::ElastoViscoplastic) && own.kinematic.is_empty();
        let law = if let Some(shifting) = elastoplastic.filter(|_| shifts) {
            source.note(format!("material {name}: with its back-stresses, and the hardening without them"));
            shifting
        } else {
            file::Material { kinematic: own.kinematic.clone(), ..sheet }
        };
        (own.kinematic, own.hardening) = (law.kinematic, law.hardening);
        own.fitted_up_to = own.fitted_up_to.or(law.fitted_up_to);
        own.source.get_or_insert(origin);
    }
    if !replaced.is_empty() {
        source.note(format!("material {name}: {} as this case has it, not as its source", replaced.join(", ")));
    }
    // The sheet's thickness belongs to its own law only.
    let thickness = thickness.filter(|_| !own_hardening).and_then(|range| Thickness::parse(name, &range));
    Ok(Sources { sheets, thickness, ..Sources::default() })
}

fn entry(name: &'static str, text: &'static str) -> Result<Entry, CaseError> {
    let mut about: Description = read(name, text)?;
    let source = Source::parse(name, text, Folder { files: &Disk, path: Path::new("") })?;
    let material = about.material.model(&source)?;
    let elastoplastic = about.elastoplastic().map(|shifting| shifting.model(&source)).transpose()?;
    let limit = about.forming_limit.as_ref().map(|limit| limit.curve(&material, 1.0, None, &source));
    let measured_limit = limit.transpose()?.flatten();
    about.material.r_values(&source);
    about.notes.extend(source.take_notes());
    let text = text.find("[material").map_or("", |at| &text[at..]);
    Ok(Entry { name, about, material, elastoplastic, measured_limit, text })
}
