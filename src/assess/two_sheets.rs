//! Whether the numbers of the material are of one sheet, and of this thickness.

use super::Finding;
use crate::case::Case;
use crate::table::Unit;
use crate::units::Amount;

/// Hardening of one sheet with the r̄ of another.
pub(super) fn mixed(case: &Case) -> Option<Finding> {
    let sheets = case.sources.sheets.as_ref()?;
    let library = String::from(sheets.library.clone());
    let own = match sheets.case.clone() {
        Some(source) => format!("this case ({source})"),
        None => "this case".to_owned(),
    };
    let (hardening, anisotropy) = if sheets.own_hardening { (own, library) } else { (library, own) };
    let found = format!(
        "the hardening of {hardening} goes with r̄ = {r} of {anisotropy}: numbers of two sheets, which no sheet has",
        r = Amount::number(sheets.anisotropy)
    );
    let advice = "take all of one sheet: --material NAME, or [material] with `name` alone".to_owned();
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
        let range = match of.range.map(Amount::size) {
            [one, other] if one == other => format!("{one}"),
            [low, high] => format!("{low} to {high}"),
        };
        let found = format!(
            "the numbers of {material} are of sheet of {range}; this blank is {thickness} thick",
            material = of.name,
            thickness = Amount::size(t)
        );
        Finding::warning("sheet_thickness", "Material", found)
            .against(t, Unit::Mm, range)
            .source("the library; how far from it is a declared rule of thumb")
            .advice("take the numbers of a coil of this thickness where there are some")
    })
}
