//! Whether the flange would wrinkle: an index, for an axisymmetric run cannot.

use super::nose::NoseEnd;
use super::{Finding, Light, closing, run::Run};
use crate::assess::estimate::{draw_ratio, held_area, siebel_pressure, tensile_strength};
use crate::model::tool_sizes::extent;
use crate::model::{Model, Motion, Role};
use crate::table::Unit;
use crate::units::Amount;

/// Advised pressure over the holder's \[–\]: 1 by the rule; above 2 even a factor of 0.002, the least that the rule is said
/// to be quoted with, would ask for more. A force that was rounded after the rule may miss it by a percent.
const LIMITS: [f64; 2] = [1.01, 2.0];
/// Diameter of a blank less that of the punch, over the thickness, up to which a cup is drawn without a holder \[–\].
const FREE: [f64; 2] = [15.0, 20.0];
/// Room between a fixed holder and the die, in thicknesses, above which waves have a height to grow to \[–\].
const GAP: f64 = 1.2;

/// Siebel's pressure over the least that the holder exerts on the flange's first area, beads' closing force taken off; of a
/// fixed holder its gap. Of the first stage of an axisymmetric draw.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let model = &first.model;
    draw_ratio(model)?;
    if let Some(gap) = closing::open(first) {
        let found = format!("not judged: the holder stands open by {gap}", gap = Amount::thickness(gap));
        let judged = Finding::judged("wrinkling", "Wrinkle index", Light::Grey, found);
        return Some(judged.limit("a holder that is closed on the flange").advice(closing::advice(model)));
    }
    match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Pressed(press)) if !press.is_idle() => pressed(model, press.force.smallest()),
        Some(Motion::Gap(gap)) => Some(fixed(gap / model.blank.thickness)),
        _ => Some(free(model)),
    }
}

/// A wall that hangs free between nose and shoulder, of a punch without a straight one: it may pucker, which no index here
/// says. Of the first stage of an axisymmetric draw.
pub(super) fn wall(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    draw_ratio(&first.model)?;
    if NoseEnd::of(first).is_some_and(NoseEnd::is_upright) {
        return None;
    }
    Some(
        Finding::judged(
            "wall_wrinkles",
            "Wall wrinkles",
            Light::Grey,
            "part of the wall hangs free between punch and die",
        )
        .limit("an axisymmetric run cannot wrinkle, and no rule for it could be read")
        .advice("more holder force, or beads, keep a free wall in tension; a thicker sheet puckers later"),
    )
}

/// Whether flange or wall may wrinkle if the holder lets go of them.
pub(super) fn wants_holding(run: &Run) -> bool {
    wall(run).is_some() || judge(run).is_some_and(|index| index.light > Light::Green)
}

fn pressed(model: &Model, least: f64) -> Option<Finding> {
    let beads: f64 = model.beads.iter().map(|bead| bead.closing * bead.line(model.geometry)).sum();
    let pressure = (least - beads).max(0.0) / held_area(model)?;
    let advised = siebel_pressure(model, tensile_strength(&model.material))?;
    let index = advised / pressure;
    let light = Light::of(index, LIMITS);
    let force = advised * held_area(model)? + beads;
    let found = format!(
        "{index}: {advised} advised over {pressure}; an axisymmetric run itself cannot wrinkle",
        index = Amount::ratio(index),
        advised = Amount::stress(advised),
        pressure = Amount::stress(pressure)
    );
    let limit =
        format!("{limit}, red above {red}", limit = Amount::count(LIMITS[0] as usize), red = Amount::number(LIMITS[1]));
    Some(
        Finding::judged("wrinkling", "Wrinkle index", light, found)
            .against(index.is_finite().then_some(index), Unit::None, limit)
            .at_most(LIMITS[0], LIMITS[1])
            .source("Siebel's holder pressure, after Kugler (2009) in 4ming; red is a declared rule of thumb")
            .advice(format!("a holder force of {force} or more; where the sheet tears too, a thicker sheet, a smaller blank or one more draw", force = Amount::force(force, Unit::N))),
    )
}

fn fixed(gap: f64) -> Finding {
    let found = format!(
        "holder fixed {gap} from the die; an axisymmetric run itself cannot wrinkle",
        gap = Amount::thicknesses(gap)
    );
    Finding::judged("wrinkling", "Wrinkle room", Light::within(gap, GAP), found)
        .against(gap, Unit::None, format!("at most {limit}", limit = Amount::given_thicknesses(GAP)))
        .at_most(GAP, None)
        .advice("a smaller holder gap, or a holder force")
}

/// A blank that nothing holds: how far it stands beyond the punch, in thicknesses.
fn free(model: &Model) -> Finding {
    let beyond = model.tool(Role::Punch).map_or(0.0, |punch| 2.0 * (model.blank.length - extent(punch).1));
    let thicknesses = beyond / model.blank.thickness;
    let found = format!(
        "nothing holds the flange: blank less punch diameter is {ratio}; an axisymmetric run itself cannot wrinkle",
        ratio = Amount::thicknesses(thicknesses)
    );
    let limit = format!(
        "{limit}, red above {red}",
        limit = Amount::given_thicknesses(FREE[0]),
        red = Amount::given_thicknesses(FREE[1])
    );
    Finding::judged("wrinkling", "Wrinkle index", Light::of(thicknesses, FREE), found)
        .against(thicknesses, Unit::None, limit)
        .at_most(FREE[0], FREE[1])
        .advice("give tools.holder a force; `check` says what Siebel's rule advises")
}
