//! Sources of the numbers of a case.

use super::*;
use crate::units::parse;

/// Sources of the numbers of a case: how they were measured, or author and year; the run does not depend on them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sources {
    /// Sheet of the library that the case names.
    pub sheet: Option<String>,
    /// Source of the friction of all tools.
    pub friction: Option<String>,
    /// Source of the material's numbers.
    pub material: Option<String>,
    /// Source of the constants of ductile fracture.
    pub fracture: Option<String>,
    /// Sheets of hardening and r̄, if they are two.
    pub sheets: Option<Sheets>,
    /// Thickness of the sheet that the material's numbers are of.
    pub thickness: Option<Thickness>,
}

/// A material whose hardening and r̄ are of two sheets, one of them the library's.
#[derive(Clone, Debug, PartialEq)]
pub struct Sheets {
    /// The sheet of the library.
    pub library: String,
    /// Source of the case's own numbers.
    pub case: Option<String>,
    /// True if the hardening is the case's and r̄ the library's; else the reverse.
    pub own_hardening: bool,
    /// r̄ \[–\].
    pub anisotropy: f64,
}

impl Sheets {
    pub(super) fn new(name: &str, own_hardening: bool, own: &file::Material, known: &file::Material) -> Option<Self> {
        let r_value = if own_hardening { known.anisotropy } else { own.anisotropy };
        let anisotropy = r_value.map_or(1.0, file::Anisotropy::mean);
        let (library, case) = (name.to_owned(), own.source.clone());
        (own_hardening != own.anisotropy.is_some()).then_some(Self { library, case, own_hardening, anisotropy })
    }
}

/// Thickness of the sheet that a material of the library is of.
#[derive(Clone, Debug, PartialEq)]
pub struct Thickness {
    /// The material's name.
    pub name: String,
    /// Smallest and largest \[mm\].
    pub range: [f64; 2],
}

impl Thickness {
    /// Reads `0.8 mm` or `0.67 to 0.712 mm`.
    pub(super) fn parse(name: &str, range: &str) -> Option<Self> {
        let (low, high) = range.split_once(" to ").unwrap_or((range, range));
        let unit = high.trim().rsplit_once(' ')?.1;
        let low = if low.contains(unit) { low.to_owned() } else { format!("{low} {unit}") };
        Some(Self { name: name.to_owned(), range: [parse(&low).ok()?.value, parse(high).ok()?.value] })
    }
}

fn keys(overrides: &[String]) -> impl Iterator<Item = &str> {
    overrides.iter().filter_map(|written| written.split_once('=')).map(|(path, _)| path.trim())
}

pub(super) fn limit_of_another_sheet(file: &CaseFile, overrides: &[String]) -> Option<String> {
    let measured = file.forming_limit.as_ref().is_some_and(|limit| limit.points.is_some());
    let stays = measured && !keys(overrides).any(|path| path.starts_with("forming_limit"));
    let other = keys(overrides).any(|path| path == "material" || path == "material.name");
    (stays && other).then(|| "the points of [forming_limit] are still those of the sheet before".into())
}

pub(super) fn forget_replaced(file: &mut CaseFile, overrides: &[String]) {
    let forget = |source: &mut Option<String>, path: &str, is_of: fn(&str) -> bool| {
        if keys(overrides).any(is_of) && !keys(overrides).any(|key| key == path) {
            *source = None;
        }
    };
    forget(&mut file.friction.source, "friction.source", |path| path.split('.').any(|key| key == "friction"));
    forget(&mut file.material.source, "material.source", |path| {
        path.split('.').next() == Some("material") && !path.starts_with("material.fracture")
    });
    forget(&mut file.material.fracture_source, "material.fracture_source", |path| {
        path.starts_with("material.fracture.")
    });
}

pub(super) fn sources(file: &CaseFile, taken: Sources, source: &Source) -> Result<Sources> {
    let (friction, material) = (file.friction.source.clone(), file.material.source.clone());
    let fracture = file.material.fracture_source.clone();
    let of_material = [(&material, "material.source"), (&fracture, "material.fracture_source")];
    for (given, path) in [(&friction, "friction.source")].into_iter().chain(of_material) {
        let help = "write how it was measured, or author and year; leave it out where the numbers are assumed";
        let says = given.as_ref().is_none_or(|text| !text.trim().is_empty());
        source.require(says, path, "`source` says nothing", help)?;
    }
    Ok(Sources { sheet: file.material.name.clone(), friction, material, fracture, ..taken })
}
