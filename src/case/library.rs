//! The built-in materials: one file of `library/` each, every number with its source.

mod class;
mod entries;
mod lookup;
mod measured;
mod strength;

pub use class::Class;
pub use entries::StandsFor;
pub use measured::{Fit, Measured, Point, Rates};

use super::file::{Anisotropy, CaseFile, FormingLimit};
use super::files::Folder;
use super::sources::{Sheets, Taken, Thickness};
use super::{CaseError, build, source::Source};
use crate::forming_limit::{Curve, Hill, Kind, Sheet, uniform_strain};
use crate::material::Material;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::Mode;
use entries::{EntryFile, TEXTS, read};
use lookup::Found;

/// A material of the library.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name in a case.
    pub name: &'static str,
    /// One line that says what sheet it is.
    pub title: String,
    /// Author, year and place of the numbers.
    pub source: String,
    /// Grade of `reference_data/sources.toml`: A, read in the named source; B, read where that is quoted; C, the hardening is
    /// assumed.
    pub grade: String,
    /// Under which terms the numbers may be used.
    pub licence: String,
    /// Thickness of the sheet that the numbers are of.
    pub thickness: Option<String>,
    /// The grades that it stands for, where there are any.
    pub stands_for: Option<StandsFor>,
    /// Scatter of its class by a standard.
    pub class: Option<Class>,
    /// Remarks on the numbers.
    pub notes: Vec<String>,
    /// Points that the laws are fitted to.
    pub measured: Option<Measured>,
    /// The material as a case would have it.
    pub material: Material,
    /// Material of the elasto-viscoplastic mode, if it has back-stresses there.
    pub elastoplastic: Option<Material>,
    /// Its measured forming limit; `None` where there is none.
    pub measured_limit: Option<Curve>,
    /// Its `[material]` table, to paste into a case.
    pub text: &'static str,
}

impl Entry {
    /// Uniform strain of the hardening law, n of a power law; `None` where the law has no load maximum \[–\].
    pub fn n(&self) -> Option<f64> {
        uniform_strain(&self.sheet()).ok()
    }

    /// The forming limit by Hill and Swift, computed from the law. `None` where the law
    /// has no load maximum.
    pub fn forming_limit(&self) -> Option<Curve> {
        Kind::Hill(Hill { n: None }).curve(&self.sheet()).ok()
    }

    /// The sheet at room temperature.
    pub fn sheet(&self) -> Sheet<'_> {
        Sheet { material: &self.material, thickness: 1.0, temperature: ROOM_TEMPERATURE }
    }
}

/// Every material, by name.
///
/// # Errors
/// Never with the shipped library, whose entries are tested.
pub fn materials() -> Result<Vec<Entry>, CaseError> {
    TEXTS.iter().map(|(name, text)| entry(name, text)).collect()
}

/// The names of all materials.
pub fn names() -> impl Iterator<Item = &'static str> {
    TEXTS.iter().map(|(name, _)| *name)
}

/// The material of a name, of a grade that it stands for, or whose name alone begins so.
///
/// # Errors
/// When there is none or more than one; the error proposes the nearest.
pub fn material(name: &str) -> Result<Entry, CaseError> {
    let Found { name, text, .. } = lookup::find(name)?;
    entry(name, text)
}

/// Fills what a case leaves open of the material that it names.
pub(super) fn complete(file: &mut CaseFile, source: &Source) -> Result<Taken, CaseError> {
    let Some(written) = file.material.name.clone() else { return Ok(Taken::default()) };
    let Found { name, file: found, note, .. } =
        lookup::find(&written).map_err(|unknown| source.error("material.name", unknown.what, unknown.help))?;
    let elastoplastic = found.elastoplastic();
    let EntryFile { material: known, thickness, forming_limit, .. } = found;
    let origin = known.source.clone().unwrap_or_default();
    let from = format!("material {name}: {origin}");
    note.into_iter().chain([from]).chain(measured_limit(name, forming_limit, file)).for_each(|note| source.note(note));
    let own = &mut file.material;
    let own_hardening = source.has("material.hardening");
    let mut replaced = Vec::new();
    let mut keep = |key: &'static str, given: bool| replaced.extend(given.then_some(key));
    keep("young and poisson", own.young.is_some() || own.poisson.is_some());
    keep("anisotropy", own.anisotropy.is_some());
    keep("yield_condition", own.yield_condition.is_some());
    keep("rate", own.rate.is_some());
    keep("softening", own.softening.is_some());
    keep("hardening", own_hardening);
    let sheets = Sheets::of(name, own_hardening, own, &known);
    if own.young.is_none() && own.poisson.is_none() {
        (own.young, own.poisson) = (known.young, known.poisson);
    }
    own.anisotropy = own.anisotropy.or(known.anisotropy);
    own.yield_condition = own.yield_condition.or(known.yield_condition);
    own.rate = own.rate.or(known.rate);
    own.softening = own.softening.or(known.softening);
    if !own_hardening {
        let shifts = own.mode == Some(Mode::ElastoViscoplastic) && own.kinematic.is_empty();
        if let Some(shifting) = elastoplastic.filter(|_| shifts) {
            (own.kinematic, own.hardening) = (shifting.kinematic, shifting.hardening);
            source.note(format!(
                "material {name}: with its back-stresses, and the hardening that they leave of its yield stress"
            ));
        } else {
            own.hardening = known.hardening;
        }
        own.fitted_up_to = own.fitted_up_to.or(known.fitted_up_to);
        own.source.get_or_insert(origin);
    }
    if !replaced.is_empty() {
        source.note(format!(
            "material {name}: {keys} as this case has it, not as its source",
            keys = replaced.join(", ")
        ));
    }
    // Of another law the sheet's thickness says nothing.
    let thickness = thickness.filter(|_| !own_hardening).and_then(|words| Thickness::read(name, &words));
    Ok(Taken { sheets, thickness })
}

/// Puts the measured points of a sheet of the library where a case asks for them, and says so.
fn measured_limit(name: &str, known: Option<FormingLimit>, file: &mut CaseFile) -> Option<String> {
    let asked = file.forming_limit.as_mut().filter(|own| own.measured == Some(true) && own.points.is_none())?;
    let FormingLimit { points, strain, .. } = known?;
    (asked.points, asked.strain, asked.measured) = (points, asked.strain.or(strain), None);
    Some(format!("forming limit: the measured points of {name}"))
}

fn entry(name: &'static str, text: &'static str) -> Result<Entry, CaseError> {
    let file = read(name, text)?;
    let written = Source::parse(name, text, Folder::default())?;
    let material = build::material(&file.material, &written)?;
    let elastoplastic = file.elastoplastic().map(|shifting| build::material(&shifting, &written)).transpose()?;
    let EntryFile {
        title,
        grade,
        licence,
        thickness,
        stands_for,
        scatter,
        mut notes,
        measured,
        material: said,
        forming_limit,
        ..
    } = file;
    let source = said.source.unwrap_or_default();
    let r_values = said.anisotropy.and_then(Anisotropy::directions);
    notes.extend(r_values.map(|r| build::mean_of(r).to_string()));
    let sheet = Sheet { material: &material, thickness: 1.0, temperature: ROOM_TEMPERATURE };
    let measured_limit = forming_limit.map(|limit| build::measured(&limit, &sheet, &written)).transpose()?;
    let table = text.find("[material").map_or("", |at| &text[at..]);
    Ok(Entry {
        name,
        title,
        source,
        grade,
        licence,
        thickness,
        stands_for,
        class: scatter,
        notes,
        measured,
        material,
        elastoplastic,
        measured_limit,
        text: table,
    })
}
