//! Lines on loads and later stages: holder, beads, gas, motions.

use super::line::{Line, line, number, size_of};
use crate::assess::estimate;
use crate::model::stage::Stage;
use crate::model::{Bead, Face, Gas, Mode, Model, Motion, Pressure, Role};
use crate::units::{Amount, Digits, Unit, joined};

pub(super) fn holder(model: &Model, strength: f64) -> Vec<Line> {
    let unit = model.extent().force_unit();
    let press = match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Gap(gap)) => {
            let ratio = Amount::thicknesses(gap / model.blank.thickness);
            return vec![number("holder gap", Amount::size(*gap), format!("to the die, {ratio}: fixed"))];
        }
        Some(Motion::Pressed(press)) => press,
        _ => return Vec::new(),
    };
    let [least, most] = [press.force.smallest(), press.force.largest()].map(|force| Amount::force(force, unit));
    let text = if least == most { most.to_string() } else { format!("{least} to {most}") };
    let meaning = match press.stiffness {
        0.0 if least == most => String::new(),
        0.0 => "over the travel".into(),
        c => format!("on the flat sheet, and {} more per mm that it is lifted", Amount::force(c, unit)),
    };
    let mut lines = vec![line("holder force", text, meaning)];
    let (Some(area), Some(pressure)) = (estimate::held_area(model), estimate::holder_pressure(model)) else {
        return lines;
    };
    let on = "on the initial area between holder and die's flat";
    lines.push(number("holder pressure", Amount::stress(pressure), on));
    lines.extend(estimate::siebel_pressure(model, strength).map(|siebel| {
        let force = Amount::force(siebel * area, unit);
        let rule = "by Siebel's rule, 0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m (Kugler, Umformtechnik, 2009)";
        number("advised pressure", Amount::stress(siebel), format!("{rule}: {force}"))
    }));
    lines
}

pub(super) fn bead(model: &Model, bead: &Bead) -> Line {
    let [restraining, closing] = [bead.restraining, bead.closing].map(|force| Amount::force(force, Unit::NPerMm));
    line("bead", size_of(model, bead.at, Amount::drawn), format!("restraining {restraining}, closing {closing}"))
}

pub(super) fn gas(model: &Model, gas: &Gas) -> Line {
    let (within, time) = (Amount::size(gas.within), Amount::time(model.duration));
    let face = match gas.face {
        Face::Lower => "lower",
        Face::Upper => "upper",
    };
    let place = format!("on the {face} face within {within}, for {time}");
    let control = match &gas.pressure {
        Pressure::OverTime(history) => {
            return number("gas pressure", Amount::given_stress(history.largest()), format!("at most {place}"));
        }
        Pressure::Rate(control) => control,
    };
    let norm = format!("held by the pressure (norm with q = {})", Amount::number(control.exponent));
    let finite = |value: f64| value.is_finite().then(|| Amount::given_stress(value));
    let most = finite(control.max_pressure).map(|most| format!("{most} at most"));
    let rise = finite(control.max_rise).map(|rise| format!("{rise}/s at most"));
    let limits = joined([Some(norm), most, rise].into_iter().flatten(), ", ");
    let rate = Amount::new(control.target, Unit::PerSecond, Digits::Significant(3));
    number("strain rate", rate, format!("{limits} {place}"))
}

pub(super) fn stage(n: usize, stage: &Stage) -> Line {
    let Stage { model, begin, .. } = stage;
    let mut does = Vec::new();
    does.extend(begin.trim.map(|half| format!("cut at {}", size_of(model, half, Amount::set))));
    does.extend(begin.anneal.then(|| "annealed".into()));
    for tool in &model.tools {
        let name = tool.role.name();
        let name = if begin.meets.contains(&tool.role) { format!("new {name}") } else { name.into() };
        does.push(match &tool.motion {
            Motion::Path(by) if by.x == 0.0 => format!("{name} goes {}", Amount::size(by.y)),
            Motion::Path(by) => format!("{name} goes {} and {} aside", Amount::size(by.y), Amount::size(by.x)),
            Motion::Pressed(press) => {
                let force = Amount::force(press.force.at(model.travel), model.extent().force_unit());
                format!("{name} presses with {force} at the end")
            }
            Motion::Fixed | Motion::Gap(_) | Motion::Travel => format!("{name} stands"),
        });
    }
    does.extend(model.release.map(|_| "tools taken away".into()));
    does.push(match model.mode {
        Mode::Flow => String::new(),
        Mode::ElastoViscoplastic => "elasto-viscoplastic".into(),
        Mode::Elastic => "elastic".into(),
    });
    does.extend(model.timed.then(|| Amount::time(model.duration).to_string()));
    line(format!("stage {n}"), stage.name.as_str(), joined(does, "; "))
}
