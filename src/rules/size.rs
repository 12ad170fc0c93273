//! Sizes that hardly fit a stamping: a unit is wrong, or a diameter stands where a radius is asked for. The limits are
//! declared rules of thumb.

use crate::model::tool_sizes::{extent, throat};
use crate::model::{Model, Role};
use crate::rules::design::LIMITING_RATIO;
use crate::rules::estimate::draw_ratio;
use crate::units::Amount;
use crate::units::{Unit, significant};
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

/// A size in doubt.
#[derive(Clone, Debug, PartialEq)]
pub struct Doubt {
    /// The number \[mm, or – for a ratio\].
    pub value: f64,
    /// Its unit.
    pub unit: Unit,
    /// What is odd.
    pub found: String,
    /// What would not be.
    pub limit: String,
    /// What to look at.
    pub advice: String,
}

/// What is doubted of a model.
pub const DOUBTS: [fn(&Model) -> Option<Doubt>; 5] = [width, thickness, slender, blank_diameter, throat_diameter];

/// Width of a blank, both halves of a strip \[mm\].
pub fn across(model: &Model) -> f64 {
    2.0 * model.blank.length
}

/// A blank that is wider or narrower than stampings are.
pub fn width(model: &Model) -> Option<Doubt> {
    let across = across(model);
    let found = format!("the blank is {width} wide, which is odd for a stamping", width = Amount::size(across));
    let (least, most) = (Amount::size(*WIDTHS.start()), Amount::size(*WIDTHS.end()));
    (!WIDTHS.contains(&across)).then(|| Doubt {
        value: across,
        unit: Unit::Mm,
        found,
        limit: format!("{least} to {most}"),
        advice: "is the unit of its size right?".into(),
    })
}

/// A sheet that is thinner than foil.
pub fn thickness(model: &Model) -> Option<Doubt> {
    let thickness = model.blank.thickness;
    (thickness < THINNEST).then(|| Doubt {
        value: thickness,
        unit: Unit::Mm,
        found: format!("the sheet is {thickness} thick, thinner than foil", thickness = Amount::size(thickness)),
        limit: format!("{least} or more", least = Amount::size(THINNEST)),
        advice: "is the unit of its thickness right?".into(),
    })
}

/// A blank that is very wide for its thickness.
pub fn slender(model: &Model) -> Option<Doubt> {
    let ratio = across(model) / model.blank.thickness;
    (ratio > SLENDER).then(|| Doubt {
        value: ratio,
        unit: Unit::None,
        found: format!("the blank is {ratio} thicknesses wide", ratio = Amount::number(significant(ratio, 3))),
        limit: format!("{most} at most", most = Amount::number(SLENDER)),
        advice: "are the units of its size and its thickness right?".into(),
    })
}

/// A blank's radius that one draw cannot reach, but half of it can.
pub fn blank_diameter(model: &Model) -> Option<Doubt> {
    let ratio = draw_ratio(model).filter(|ratio| (TWICE..=2.0 * LIMITING_RATIO).contains(ratio))?;
    let radius = model.blank.length;
    Some(Doubt {
        value: ratio,
        unit: Unit::None,
        found: format!(
            "the blank's radius of {radius} is {ratio} times the punch's",
            radius = Amount::size(radius),
            ratio = Amount::ratio(ratio)
        ),
        limit: format!("{most} at most", most = Amount::number(LIMITING_RATIO)),
        advice: format!(
            "is {radius} the diameter? Then the radius is {half}",
            radius = Amount::size(radius),
            half = Amount::size(0.5 * radius)
        ),
    })
}

/// A throat that leaves far more than the sheet's thickness beside the punch, where half of it would fit.
pub fn throat_diameter(model: &Model) -> Option<Doubt> {
    let (punch, die) = (model.tool(Role::Punch)?, model.tool(Role::Die)?);
    let (radius, throat, t) = (extent(punch).1, throat(die)?, model.blank.thickness);
    let (gap, of_half) = ((throat - radius) / t, (0.5 * throat - radius) / t);
    (gap > WIDE && CLEARANCES.contains(&of_half)).then(|| Doubt {
        value: gap,
        unit: Unit::None,
        found: format!(
            "between punch and die's throat of {throat} there is room for {gap} sheets",
            throat = Amount::size(throat),
            gap = Amount::number(significant(gap, 3))
        ),
        limit: format!("{most} at most", most = Amount::number(WIDE)),
        advice: format!(
            "is {throat} the diameter, or the whole width? Half of it is {half}",
            throat = Amount::size(throat),
            half = Amount::size(0.5 * throat)
        ),
    })
}
