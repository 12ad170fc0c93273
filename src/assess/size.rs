//! Sizes that hardly fit a stamping: a wrong unit, or a diameter as a radius. The limits are declared rules of thumb.

use super::*;
use crate::assess::estimate::draw_ratio;
use crate::model::tool_sizes::throat;
use crate::rules::{self, LIMITING_RATIO};
use std::ops::RangeInclusive;

/// Thicknesses of sheets \[mm\].
pub const THICKNESSES: RangeInclusive<f64> = 0.2..=6.0;
/// Width of a blank over its thickness \[–\].
const SLENDER: f64 = 3000.0;
/// Draw ratio from which on the blank's radius may be its diameter \[–\]: beyond what one draw of any sheet reaches.
const TWICE: f64 = 1.2 * LIMITING_RATIO;
/// Gap between punch and die over the thickness that half of the throat would leave \[–\].
const CLEARANCES: RangeInclusive<f64> = 0.9..=3.0;
/// Gap over the thickness from which on the throat may be a diameter \[–\].
const WIDE: f64 = 5.0;

/// Checks of a model's sizes, and of an earlier run's metal: if one is wrong, nothing else is worth reading.
pub const SIZE_CHECKS: [fn(&Model) -> Option<Finding>; 6] =
    [width, thickness, slender, blank_diameter, throat_diameter, material::earlier];

/// Warnings on the sizes of a case, as sentences.
pub fn size_doubts(case: &Case) -> Vec<String> {
    SIZE_CHECKS.iter().filter_map(|check| check(case.model())).map(|finding| finding.sentence()).collect()
}

/// Width of a blank, both halves of a strip \[mm\].
pub fn across(model: &Model) -> f64 {
    2.0 * model.blank.reach()
}

fn width(model: &Model) -> Option<Finding> {
    let warning = Finding::warning("width", "Width", "the blank is {} wide, which is odd for a stamping");
    within(warning, across(model), rules::WIDTHS).advice("is the unit of its size right?").if_beyond()
}

fn within(warning: Finding, size: f64, range: RangeInclusive<f64>) -> Finding {
    let warning = warning.number(Amount::size(size));
    if size > *range.end() { warning.at_most(*range.end(), None) } else { warning.at_least(*range.start(), None) }
}

fn thickness(model: &Model) -> Option<Finding> {
    let warning = Finding::warning("thickness", "Thickness", "the sheet is {} thick, which is odd for a stamping");
    within(warning, model.blank.thickness, THICKNESSES).advice("is the unit of its thickness right?").if_beyond()
}

fn slender(model: &Model) -> Option<Finding> {
    let ratio = Amount::number(significant(across(model) / model.blank.thickness, 3));
    let warning = Finding::warning("slenderness", "Width over thickness", "the blank is {} thicknesses wide");
    let warning = warning.number(ratio).at_most(SLENDER, None);
    warning.advice("are the units of its size and its thickness right?").if_beyond()
}

fn blank_diameter(model: &Model) -> Option<Finding> {
    let ratio = draw_ratio(model).filter(|ratio| (TWICE..=2.0 * LIMITING_RATIO).contains(ratio))?;
    let [radius, half] = [1.0, 0.5].map(|share| Amount::size(share * model.blank.length));
    let text = format!("the blank's radius of {radius} is {{}} times the punch's");
    let warning = Finding::warning("blank_diameter", "Blank", text).number(Amount::ratio(ratio));
    Some(warning.at_most(LIMITING_RATIO, None).advice(format!("is {radius} the diameter? Then the radius is {half}")))
}

fn throat_diameter(model: &Model) -> Option<Finding> {
    let (punch, die) = (model.tool(Role::Punch)?, model.tool(Role::Die)?);
    let (radius, throat, t) = (extent(punch).1, throat(die)?, model.blank.thickness);
    let gap = Amount::number(significant((throat - radius) / t, 3));
    let may_be = CLEARANCES.contains(&((0.5 * throat - radius) / t));
    let [throat, half] = [1.0, 0.5].map(|share| Amount::size(share * throat));
    let text = format!("between punch and die's throat of {throat} there is room for {{}} sheets");
    let warning = Finding::warning("throat_diameter", "Throat", text).number(gap).at_most(WIDE, None);
    let warning = warning.advice(format!("is {throat} the diameter, or the whole width? Half of it is {half}"));
    warning.if_beyond().filter(|_| may_be)
}
