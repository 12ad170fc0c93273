//! [`CaseFile`] → [`Model`]: what the keys mean together, checked against each other.

mod blank;
mod collide;
mod compare;
mod counter;
mod fit;
mod forming_limit;
mod friction;
mod heat;
mod limits;
mod lines;
mod loads;
mod material;
mod motion;
mod place;
mod points;
mod press;
mod profile;
mod section;
mod settings;
mod stages;
mod tools;

pub(super) use compare::compare;
pub(super) use material::convert as material;
pub(super) use press::press;

use super::explain::missing;
use super::file::{self, CaseFile};
use super::{CaseError, source::Source};
use crate::law::{Family, LawError, Named};
use crate::model::stage::Stage;
use crate::model::{Geometry, Mode, Model, Theory};
use crate::units::{Length, Positive, Quantity, rounded};
use std::path::Path;

/// What a case means: the model of its first stage and that one's name, the stages after it, and what was assumed.
pub(super) struct Meaning {
    pub model: Model,
    pub first: String,
    pub later: Vec<Stage>,
    pub derived: Vec<String>,
}

/// The meaning of a case; `case` is the path that files are looked up from.
pub(super) fn meaning(file: &CaseFile, source: &Source, case: &Path) -> Result<Meaning, CaseError> {
    limits::of_file(file, source)?;
    let mut derived = Vec::new();
    let geometry = geometry(file);
    let blank = blank::convert(file, geometry, source, &mut derived)?;
    let material = material::convert(&file.material, source)?;
    let mode = file.material.mode.map(|mode| material::mode(mode, &material, "material.mode", source)).transpose()?;
    let mode = mode.unwrap_or_default();
    if mode != Mode::Flow && blank.theory == Theory::Selective {
        let help = "write blank.theory = \"bending\", or mode = \"flow\"";
        return Err(source.error("blank.theory", "an elastic sheet cannot change between bending and membrane", help));
    }
    let sheet = tools::Sheet { geometry, length: blank.length, thickness: blank.thickness };
    let drive = motion::drive(file, blank.length, source)?;
    let folder = case.parent().unwrap_or(Path::new(""));
    let shop = tools::Shop { case: file, sheet, travel: drive.travel, source, folder };
    let tools = tools::convert(&shop, &mut derived)?;
    let sheet = shop.sheet;
    let gas = match &file.gas {
        Some(gas) => loads::gas(gas, &tools, &sheet, source, &mut derived)?,
        None => Vec::new(),
    };
    let heat = match &file.heat {
        Some(heat) => Some(heat::convert(heat, &tools, source, folder)?),
        None => {
            if material.softening.is_some() || material.hardening.temperatures().is_some() {
                derived.push("without [heat] the sheet is at 20 °C throughout".into());
            }
            None
        }
    };
    let forming_limit = match &file.forming_limit {
        Some(limit) => {
            Some(forming_limit::convert(limit, &material, blank.thickness, heat.as_ref(), source, &mut derived)?)
        }
        None => None,
    };
    let model = Model {
        title: file.title.clone(),
        notes: file.notes.clone(),
        geometry,
        material,
        beads: loads::beads(&file.tools.beads, &tools, &sheet, source)?,
        stop: settings::stop(&file.stop, &tools, source)?,
        tools,
        gas,
        heat,
        travel: drive.travel,
        schedule: drive.schedule.clone(),
        speed: drive.speed,
        duration: drive.duration,
        frames: settings::frames(&file.output, &drive, source)?,
        settings: settings::convert(&file.solver, source)?,
        blank,
        mode,
        release: None,
        forming_limit,
    };
    fit::check(&model, source)?;
    limits::of_model(&model, source)?;
    collide::check(&model, source)?;
    let (first, later) = stages::convert(file, &model, source, folder, &mut derived)?;
    Ok(Meaning { model, first, later, derived })
}

fn geometry(file: &CaseFile) -> Geometry {
    match file.geometry {
        file::Geometry::Axisymmetric => Geometry::Axisymmetric,
        file::Geometry::PlaneStrain => Geometry::PlaneStrain,
    }
}

/// A length whose key depends on the geometry; the other geometry's key is an error that says so.
fn by_geometry(
    source: &Source,
    table: &str,
    geometry: Geometry,
    axisymmetric: (&str, Option<Positive<Length>>),
    plane_strain: (&str, Option<Positive<Length>>),
) -> Result<f64, CaseError> {
    let (name, (key, value), (other_name, (other, wrong))) = match geometry {
        Geometry::Axisymmetric => ("axisymmetric", axisymmetric, ("plane strain", plane_strain)),
        Geometry::PlaneStrain => ("plane strain", plane_strain, ("axisymmetric", axisymmetric)),
    };
    match (value, wrong) {
        (_, Some(wrong)) => Err(source.error(
            &format!("{table}.{other}"),
            format!("`{other}` belongs to {other_name} cases, this one is {name}"),
            format!("write {key} = \"{} mm\", or change `geometry`", rounded(wrong.value())),
        )),
        (Some(value), None) => Ok(value.value()),
        (None, None) => Err(missing(source, table, key)),
    }
}

/// The one law of a table that must name exactly one, ready for use.
fn only<F: Family>(named: Named<F>, path: &str, source: &Source) -> Result<F, CaseError> {
    match named.only() {
        Ok(law) => prepared(law, None, path, source),
        Err(given) => Err(not_one(given.len(), path, &F::NAMES.join(", "), source)),
    }
}

/// A law made ready for use.
fn prepared<F: Family>(law: F, young: Option<f64>, path: &str, source: &Source) -> Result<F, CaseError> {
    let name = law.name();
    law.prepared(young).map_err(|error| {
        let message = format!("{name}: {}", error.message);
        blame(LawError { message, ..error }, &format!("{path}.{name}"), source)
    })
}

/// What is wrong with a law, shown at its key.
fn blame(error: LawError, path: &str, source: &Source) -> CaseError {
    source.error(format!("{path}.{}", error.key).trim_end_matches('.'), error.message, error.help)
}

/// Not one law where there must be exactly one.
fn not_one(found: usize, path: &str, names: &str, source: &Source) -> CaseError {
    if found > 0 {
        return source.error(path, format!("[{path}] names more than one law"), "keep one of them");
    }
    source.error(path, format!("[{path}] names no law"), format!("give one of {names}, or drop [{path}]"))
}

/// A whole number within limits.
fn count(source: &Source, path: &str, value: i64, range: std::ops::RangeInclusive<i64>) -> Result<usize, CaseError> {
    if range.contains(&value) {
        return Ok(value as usize);
    }
    let key = path.rsplit('.').next().unwrap_or(path);
    let what = format!("`{key}` must lie between {} and {}, found {value}", range.start(), range.end());
    let help = if value < *range.start() { range.start() } else { range.end() };
    Err(source.error(path, what, format!("the nearest that can be solved: {key} = {help}")))
}
