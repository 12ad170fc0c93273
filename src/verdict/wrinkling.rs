//! Whether the flange would wrinkle: an index, for an axisymmetric run cannot.

use super::{DECLARED, Finding, Light};
use crate::case::check::estimate::{draw_ratio, held_area, siebel_pressure, tensile_strength};
use crate::model::{Geometry, Model, Motion, Role};
use crate::solver::Pass;
use crate::table::Unit;

/// Advised pressure over the holder's \[–\]: 1 by the rule; above 2 even a factor of 0.002, the least that the rule is said
/// to be quoted with, would ask for more.
/// A force that was rounded after the rule may miss it by a percent.
const LIMITS: [f64; 2] = [1.01, 2.0];
/// Room between a fixed holder and the die, in thicknesses, above which waves have a height to grow to \[–\].
const GAP: f64 = 1.2;

/// Siebel's pressure over the least that the holder exerts on the flange's first area, beads' closing force taken off; of a
/// fixed holder its gap. Of the first stage of an axisymmetric draw.
pub(super) fn judge(passes: &[Pass]) -> Option<Finding> {
    let model = &passes.first()?.model;
    draw_ratio(model).filter(|_| model.geometry == Geometry::Axisymmetric)?;
    match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Pressed(press)) if !press.is_idle() => pressed(model, press.force.smallest()),
        Some(Motion::Gap(gap)) => Some(fixed(gap / model.blank.thickness)),
        _ => Some(free()),
    }
}

fn pressed(model: &Model, least: f64) -> Option<Finding> {
    let beads: f64 = model.beads.iter().map(|bead| bead.closing * bead.line(model.geometry)).sum();
    let pressure = (least - beads).max(0.0) / held_area(model)?;
    let advised = siebel_pressure(model, tensile_strength(&model.material.hardening))?;
    let index = advised / pressure;
    let light = Light::of(index, LIMITS);
    let force = 1e-3 * (advised * held_area(model)? + beads);
    Some(Finding {
        key: "wrinkling",
        label: "Wrinkle index",
        light,
        value: index.is_finite().then_some(index),
        unit: Unit::None,
        found: format!(
            "{index:.2}: {advised:.2} MPa advised over {pressure:.2} MPa; an axisymmetric run itself cannot wrinkle"
        ),
        limit: format!("{:.0}, refused above {}", LIMITS[0], LIMITS[1]),
        source: "Siebel's holder pressure, after Kugler (2009) in 4ming; red is a declared rule of thumb",
        advice: light.advice(format!("a holder force of {force:.1} kN or more; a thicker sheet or a smaller blank")),
    })
}

fn fixed(gap: f64) -> Finding {
    let light = Light::within(gap, GAP);
    Finding {
        key: "wrinkling",
        label: "Wrinkle room",
        light,
        value: Some(gap),
        unit: Unit::None,
        found: format!("holder fixed at {gap:.2} thicknesses; an axisymmetric run itself cannot wrinkle"),
        limit: format!("at most {GAP} thicknesses"),
        source: DECLARED,
        advice: light.advice("a smaller holder gap, or a holder force"),
    }
}

fn free() -> Finding {
    Finding {
        key: "wrinkling",
        label: "Wrinkle index",
        light: Light::Amber,
        value: None,
        unit: Unit::None,
        found: "nothing holds the flange; an axisymmetric run itself cannot wrinkle".into(),
        limit: "a flange that is drawn in is held".into(),
        source: DECLARED,
        advice: "give tools.holder a force; `check` says what Siebel's rule advises".into(),
    }
}
