//! Sizes that hardly fit a stamping: a unit is wrong, or a diameter stands where a radius is asked for. The limits are
//! declared rules of thumb.

use super::Finding;
use crate::assess::design::LIMITING_RATIO;
use crate::assess::estimate::draw_ratio;
use crate::case::Case;
use crate::model::tool_sizes::{extent, throat};
use crate::model::{Model, Role};
use crate::units::{Amount, significant};
use std::ops::RangeInclusive;

/// Widths of blanks \[mm\].
pub const WIDTHS: RangeInclusive<f64> = 1.0..=3000.0;
/// Thickness of the thinnest foil that is formed \[mm\].
pub const THINNEST: f64 = 0.01;
/// Width of a blank over its thickness \[–\].
pub const SLENDER: f64 = 3000.0;
/// Draw ratio from which on the blank's radius may be its diameter \[–\]: half of it is still drawn, and the whole is beyond
/// what one draw of any sheet reaches.
const TWICE: f64 = 1.2 * LIMITING_RATIO;
/// Gap between punch and die over the thickness that half of the throat would leave \[–\].
const CLEARANCES: RangeInclusive<f64> = 0.9..=3.0;
/// Gap over the thickness from which on the throat may be a diameter \[–\].
const WIDE: f64 = 5.0;

/// Checks of a model's sizes: if one is wrong, nothing else is worth reading.
pub const SIZE_CHECKS: [fn(&Model) -> Option<Finding>; 5] =
    [width, thickness, slender, blank_diameter, throat_diameter];

/// Warnings on the sizes of a case, as sentences.
pub fn size_doubts(case: &Case) -> Vec<String> {
    SIZE_CHECKS.iter().filter_map(|check| check(case.model())).map(|finding| finding.sentence()).collect()
}

/// Width of a blank, both halves of a strip \[mm\].
pub fn across(model: &Model) -> f64 {
    2.0 * model.blank.length
}

/// Width of the blank, compared with those of stampings.
fn width(model: &Model) -> Option<Finding> {
    let across = across(model);
    let limit = format!("{} to {}", Amount::size(*WIDTHS.start()), Amount::size(*WIDTHS.end()));
    let text = "the blank is {} wide, which is odd for a stamping";
    (!WIDTHS.contains(&across)).then(|| {
        let warning = Finding::warning("width", "Width", text).number(Amount::size(across)).limit(limit);
        warning.advice("is the unit of its size right?")
    })
}

/// Thickness, compared with that of foil.
fn thickness(model: &Model) -> Option<Finding> {
    let thickness = model.blank.thickness;
    let limit = format!("{} or more", Amount::size(THINNEST));
    (thickness < THINNEST).then(|| {
        let warning = Finding::warning("thickness", "Thickness", "the sheet is {} thick, thinner than foil");
        warning.number(Amount::size(thickness)).limit(limit).advice("is the unit of its thickness right?")
    })
}

/// Width over thickness.
fn slender(model: &Model) -> Option<Finding> {
    let ratio = across(model) / model.blank.thickness;
    (ratio > SLENDER).then(|| {
        Finding::warning("slenderness", "Width over thickness", "the blank is {} thicknesses wide")
            .number(Amount::number(significant(ratio, 3)))
            .limit(format!("{} at most", Amount::number(SLENDER)))
            .advice("are the units of its size and its thickness right?")
    })
}

/// Radius of a blank that one draw cannot reach, but half of it can.
fn blank_diameter(model: &Model) -> Option<Finding> {
    let ratio = draw_ratio(model).filter(|ratio| (TWICE..=2.0 * LIMITING_RATIO).contains(ratio))?;
    let [radius, half] = [1.0, 0.5].map(|share| Amount::size(share * model.blank.length));
    let text = format!("the blank's radius of {radius} is {{}} times the punch's");
    Some(
        Finding::warning("blank_diameter", "Blank", text)
            .number(Amount::ratio(ratio))
            .limit(format!("{} at most", Amount::number(LIMITING_RATIO)))
            .advice(format!("is {radius} the diameter? Then the radius is {half}")),
    )
}

/// Throat far wider than punch and sheet, where half of it would fit.
fn throat_diameter(model: &Model) -> Option<Finding> {
    let (punch, die) = (model.tool(Role::Punch)?, model.tool(Role::Die)?);
    let (radius, throat, t) = (extent(punch).1, throat(die)?, model.blank.thickness);
    let (gap, of_half) = ((throat - radius) / t, (0.5 * throat - radius) / t);
    let [throat, half] = [1.0, 0.5].map(|share| Amount::size(share * throat));
    (gap > WIDE && CLEARANCES.contains(&of_half)).then(|| {
        let text = format!("between punch and die's throat of {throat} there is room for {{}} sheets");
        Finding::warning("throat_diameter", "Throat", text)
            .number(Amount::number(significant(gap, 3)))
            .limit(format!("{} at most", Amount::number(WIDE)))
            .advice(format!("is {throat} the diameter, or the whole width? Half of it is {half}"))
    })
}
