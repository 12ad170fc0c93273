//! What presses and pulls the sheet, in lines: holder, beads, gas.

use super::line::{Line, line, size_of};
use crate::assess::estimate;
use crate::model::{Bead, Face, Gas, Model, Motion, Pressure, Role};
use crate::table::Unit;
use crate::units::{Amount, Digits, joined};

pub(super) fn holder(model: &Model, strength: f64, lines: &mut Vec<Line>) {
    let unit = model.extent().force_unit();
    let force = match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Gap(gap)) => {
            let ratio = Amount::thicknesses(gap / model.blank.thickness);
            lines.push(line("holder gap", Amount::size(*gap), format!("to the die, {ratio}: fixed")));
            return;
        }
        Some(Motion::Pressed(press)) => press,
        _ => return,
    };
    let [least, most] = [force.force.smallest(), force.force.largest()].map(|force| Amount::force(force, unit));
    let text = if least == most { most.into() } else { format!("{least} to {most}") };
    let meaning = match force.stiffness {
        0.0 if least == most => String::new(),
        0.0 => "over the travel".into(),
        c => format!(
            "on the flat sheet, and {stiffness} more per mm that it is lifted",
            stiffness = Amount::force(c, unit)
        ),
    };
    lines.push(line("holder force", text, meaning));
    let (Some(area), Some(pressure)) = (estimate::held_area(model), estimate::holder_pressure(model)) else { return };
    lines.push(line("holder pressure", Amount::stress(pressure), "on the initial area between holder and die's flat"));
    if let Some(siebel) = estimate::siebel_pressure(model, strength) {
        let meaning = format!(
            "by Siebel's rule, 0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m, as Kugler, Umformtechnik (2009), has it: {force}",
            force = Amount::force(siebel * area, unit)
        );
        lines.push(line("advised pressure", Amount::stress(siebel), meaning));
    }
}

pub(super) fn bead(model: &Model, bead: &Bead) -> Line {
    let meaning = format!(
        "restraining {restraining}, closing {closing}",
        restraining = Amount::force(bead.restraining, Unit::NPerMm),
        closing = Amount::force(bead.closing, Unit::NPerMm)
    );
    line("bead", size_of(model, bead.at, Amount::drawn), meaning)
}

pub(super) fn gas(model: &Model, gas: &Gas) -> Line {
    let (within, time) = (Amount::size(gas.within), Amount::time(model.duration));
    let place = match gas.face {
        Face::Lower => format!("on the lower face within {within}, for {time}"),
        Face::Upper => format!("on the upper face within {within}, for {time}"),
    };
    let control = match &gas.pressure {
        Pressure::OverTime(history) => {
            let meaning = format!("at most {place}");
            return line("gas pressure", Amount::given_stress(history.largest()), meaning);
        }
        Pressure::Rate(control) => control,
    };
    let norm = format!("held by the pressure (norm with q = {q})", q = Amount::number(control.exponent));
    let most = control
        .max_pressure
        .is_finite()
        .then(|| format!("{pressure} at most", pressure = Amount::given_stress(control.max_pressure)));
    let rise = control
        .max_rise
        .is_finite()
        .then(|| format!("{rise}/s at most", rise = Amount::given_stress(control.max_rise)));
    let limits = joined([Some(norm), most, rise].into_iter().flatten(), ", ");
    let rate = Amount::new(control.target, Unit::PerSecond, Digits::Significant(3));
    line("strain rate", rate, joined([limits, place], " "))
}
