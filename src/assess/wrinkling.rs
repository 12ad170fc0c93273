//! Wrinkling of the flange: an index, because an axisymmetric run cannot wrinkle.

use super::bottom_tearing::NoseEnd;
use super::{Finding, Light, closing, run::Run};
use crate::assess::estimate::{draw_ratio, held_area, siebel_pressure, tensile_strength};
use crate::model::tool_sizes::extent;
use crate::model::{Model, Motion, Role};
use crate::units::{Amount, Unit};

/// Advised pressure over the holder's \[–\]. Above 2 even a factor of 0.002, the least that is quoted for the rule, asks for
/// more; a force that was rounded after the rule may miss it by a percent.
const LIMITS: [f64; 2] = [1.01, 2.0];
/// Diameter of a blank less that of the punch, over the thickness, up to which a cup is drawn without a holder \[–\].
const FREE: [f64; 2] = [15.0, 20.0];
/// Gap between a fixed holder and the die, over the thickness, above which waves can grow \[–\].
const GAP: f64 = 1.2;

/// Siebel's pressure over the least that the holder exerts on the flange's first area, without the force that closes beads;
/// for a fixed holder its gap. For the first stage of an axisymmetric draw.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let model = &first.model;
    draw_ratio(model)?;
    if let Some(gap) = closing::gap_left(first) {
        let text = "not judged: the holder stands open by {}";
        let judged =
            Finding::judged("wrinkling", "Wrinkle index", text).number(Amount::thickness(gap)).light(Light::Grey);
        return Some(judged.limit("a holder that is closed on the flange").advice(closing::advice(model)));
    }
    match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Pressed(press)) if !press.is_idle() => pressed(model, press.force.smallest()),
        Some(Motion::Gap(gap)) => Some(fixed(gap / model.blank.thickness)),
        _ => Some(free(model)),
    }
}

/// Wall that hangs free between nose and shoulder: it may pucker, and no index here says whether.
pub(super) fn wall(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    draw_ratio(&first.model)?;
    if NoseEnd::of(first).is_some_and(NoseEnd::is_upright) {
        return None;
    }
    let text = "part of the wall hangs free between punch and die";
    Finding::judged("wall_wrinkles", "Wall wrinkles", text)
        .light(Light::Grey)
        .limit("an axisymmetric run cannot wrinkle, and no rule for it could be read")
        .advice("more holder force, or beads, keep a free wall in tension; a thicker sheet puckers later")
        .into()
}

pub(super) fn needs_holding(run: &Run) -> bool {
    wall(run).is_some() || judge(run).is_some_and(|index| index.light > Light::Green)
}

fn pressed(model: &Model, least: f64) -> Option<Finding> {
    let beads: f64 = model.beads.iter().map(|bead| bead.closing * bead.line(model.geometry)).sum();
    let pressure = (least - beads).max(0.0) / held_area(model)?;
    let advised = siebel_pressure(model, tensile_strength(&model.material))?;
    let index = advised / pressure;
    let force = Amount::force(advised * held_area(model)? + beads, Unit::N);
    let [wanted, given] = [advised, pressure].map(Amount::stress);
    let text = format!("{{}}: {wanted} advised over {given}; an axisymmetric run itself cannot wrinkle");
    let limit = format!("1, red above {}", Amount::number(LIMITS[1]));
    let judged = Finding::judged("wrinkling", "Wrinkle index", text)
        .number(Amount::ratio(index))
        .at_most(limit, LIMITS[0], LIMITS[1])
        .source("Siebel's holder pressure, after Kugler (2009) in 4ming; red is a declared rule of thumb");
    Some(judged.advice(format!(
        "a holder force of {force} or more; if the sheet tears too, a thicker sheet, a smaller blank or one more draw"
    )))
}

fn fixed(gap: f64) -> Finding {
    let text = "holder fixed {} from the die; an axisymmetric run itself cannot wrinkle";
    Finding::judged("wrinkling", "Wrinkle room", text)
        .number(Amount::thicknesses(gap))
        .at_most(format!("at most {}", Amount::given_thicknesses(GAP)), GAP, None)
        .advice("a smaller holder gap, or a holder force")
}

fn free(model: &Model) -> Finding {
    let beyond = model.tool(Role::Punch).map_or(0.0, |punch| 2.0 * (model.blank.length - extent(punch).1));
    let thicknesses = beyond / model.blank.thickness;
    let [limit, red] = FREE.map(Amount::given_thicknesses);
    let text = "nothing holds the flange: blank less punch diameter is {}; an axisymmetric run itself cannot wrinkle";
    Finding::judged("wrinkling", "Wrinkle index", text)
        .number(Amount::thicknesses(thicknesses))
        .at_most(format!("{limit}, red above {red}"), FREE[0], FREE[1])
        .advice("give tools.holder a force; `check` says what Siebel's rule advises")
}
