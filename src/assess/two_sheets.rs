//! Whether the numbers of the material are of one sheet, and of this thickness.

use super::Finding;
use crate::case::Case;
use crate::table::Unit;
use crate::units::mm;

/// Hardening of one sheet with the r̄ of another.
pub(super) fn mixed(case: &Case) -> Option<Finding> {
    let sheets = case.sources.sheets.as_ref()?;
    let found =
        format!("{} goes with {}: numbers of two sheets, which no sheet has", sheets.hardening, sheets.anisotropy);
    let advice = "take all of one sheet: --material NAME, or drop [material.hardening] and anisotropy beside `name`";
    Some(Finding::warning("two_sheets", "Material", found).advice(advice))
}

/// How far from the thickness that the numbers are of a blank may be rolled without a word \[–\]: more than a mill's tolerance.
const NEAR: f64 = 0.1;

/// A law of a sheet that is thinner or thicker than the blank.
pub(super) fn thickness(case: &Case) -> Option<Finding> {
    let of = case.sources.thickness.as_ref()?;
    let t = case.model().blank.thickness;
    let [low, high] = of.range;
    (t < low * (1.0 - NEAR) || t > high * (1.0 + NEAR)).then(|| {
        let found =
            format!("the numbers of {} are of sheet of {}; this blank is {} mm thick", of.name, of.words(), mm(t));
        Finding::warning("sheet_thickness", "Material", found)
            .against(t, Unit::Mm, of.words())
            .source("the library; how much further is a declared rule of thumb")
            .advice("take the numbers of a coil of this thickness where there are some")
    })
}
