//! Built-in materials: one file of `library/` each, every number with its source.

mod entries;

pub use entries::{Class, StandsFor, ThicknessStandard};

use super::file::{self, CaseFile};
use super::files::{Disk, Folder};
use super::sources::{Sheets, Sources, Thickness};
use super::{CaseError, source::Source};
use crate::forming_limit::{Curve, Hill, Kind, Sheet, uniform_strain};
use crate::material::Material;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::Mode;
use entries::{EntryFile, TEXTS, find, read};
use std::path::Path;

/// Plastic strain of the proof stress \[–\].
const PROOF: f64 = 0.002;

/// Material of the library.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name in a case.
    pub name: &'static str,
    /// Description in one line.
    pub title: String,
    /// Author, year and place of the numbers.
    pub source: String,
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
    pub class: Option<Class>,
    /// Remarks on the numbers.
    pub notes: Vec<String>,
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
        uniform_strain(&self.sheet()).ok()
    }

    /// Forming limit by Hill and Swift, computed from the law; `None` if the law has no load maximum.
    pub fn forming_limit(&self) -> Option<Curve> {
        Kind::Hill(Hill { n: None }).curve(&self.sheet()).ok()
    }

    /// Sheet at room temperature.
    pub fn sheet(&self) -> Sheet<'_> {
        Sheet { material: &self.material, thickness: 1.0, temperature: ROOM_TEMPERATURE }
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
///
/// # Errors
/// When there is none or more than one; the error proposes the nearest.
pub fn material(name: &str) -> Result<Entry, CaseError> {
    let sheet = find(name).map_err(|[what, help]| CaseError::bare(what, help))?;
    entry(sheet.name, sheet.text)
}

/// Fills the keys that a case leaves open of the material that it names.
pub(super) fn complete(file: &mut CaseFile, source: &Source) -> Result<Sources, CaseError> {
    let Some(written) = file.material.name.clone() else { return Ok(Sources::default()) };
    let known = find(&written).map_err(|[what, help]| source.error("material.name", what, help))?;
    let (name, elastoplastic) = (known.name, known.file.elastoplastic());
    let EntryFile { material: sheet, thickness, forming_limit, .. } = known.file;
    let origin = sheet.source.clone().unwrap_or_default();
    known.note.into_iter().chain([format!("material {name}: {origin}")]).for_each(|note| source.note(note));
    let limit = file.forming_limit.as_mut().filter(|own| own.measured == Some(true) && own.points.is_none());
    if let Some((limit, measured)) = limit.zip(forming_limit) {
        (limit.points, limit.strain, limit.measured) = (measured.points, limit.strain.or(measured.strain), None);
        source.note(format!("forming limit: the measured points of {name}"));
    }
    let own = &mut file.material;
    let keys = ["young", "poisson", "anisotropy", "yield_condition", "rate", "softening", "hardening"];
    let replaced = source.written("material", &keys);
    let own_hardening = replaced.contains(&"hardening");
    let sheets = Sheets::new(name, own_hardening, own, &sheet);
    if own.young.is_none() && own.poisson.is_none() {
        (own.young, own.poisson) = (sheet.young, sheet.poisson);
    }
    own.anisotropy = own.anisotropy.or(sheet.anisotropy);
    own.yield_condition = own.yield_condition.or(sheet.yield_condition);
    own.rate = own.rate.or(sheet.rate);
    own.softening = own.softening.or(sheet.softening);
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
    let file: EntryFile = read(name, text)?;
    let source = Source::parse(name, text, Folder { files: &Disk, path: Path::new("") })?;
    let material = file.material.model(&source)?;
    let elastoplastic = file.elastoplastic().map(|shifting| shifting.model(&source)).transpose()?;
    let EntryFile { title, grade, licence, thickness, stands_for, scatter, mut notes, .. } = file;
    let measured_limit = file.forming_limit.map(|limit| limit.curve(&material, 1.0, None, &source)).transpose()?;
    file.material.r_values(&source);
    notes.extend(source.take_notes());
    Ok(Entry {
        name,
        title,
        source: file.material.source.unwrap_or_default(),
        grade,
        licence,
        thickness,
        stands_for,
        class: scatter,
        notes,
        material,
        elastoplastic,
        measured_limit,
        text: text.find("[material").map_or("", |at| &text[at..]),
    })
}
