//! Lines on the tools: sizes, radii, travel.

use super::line::{Line, line, number, size_of};
use super::loads;
use crate::assess::{design::LIMITING_RATIO, estimate};
use crate::contact::friction::Friction;
use crate::model::tool_sizes::{extent, mouth, throat, widens};
use crate::model::{Geometry, Model, Role, Tool};
use crate::units::{Amount, joined};

/// Number of radii above which only their range is given.
const FEW: usize = 4;

pub(super) fn lines(model: &Model) -> Vec<Line> {
    let mut lines: Vec<Line> = model.tools.iter().map(|tool| of_tool(model, tool)).collect();
    lines.extend((model.travel > 0.0).then(|| number("travel", Amount::set(model.travel), pace(model))));
    lines.extend(model.beads.iter().map(|bead| loads::bead(model, bead)));
    lines.extend(model.gas.iter().map(|gas| loads::gas(model, gas)));
    lines.extend(estimate::clearance(model).map(|clearance| {
        let over_t = format!("or {}", Amount::thicknesses(clearance / model.blank.thickness));
        number("clearance", Amount::drawn(clearance), over_t)
    }));
    lines.extend(estimate::draw_ratio(model).map(|ratio| {
        let limit = Amount::number(LIMITING_RATIO);
        let meaning = format!("blank over punch; about {limit} is the limit of one draw for mild steel");
        number("draw ratio", Amount::ratio(ratio), meaning)
    }));
    lines
}

fn of_tool(model: &Model, tool: &Tool) -> Line {
    let (low, high) = extent(tool);
    let closed = tool.role == Role::Die && throat(tool).is_none();
    let (size, of) = match tool.role {
        Role::Punch => (size_of(model, high, Amount::drawn), "to the wall"),
        Role::Die if closed => ("closed".into(), "by a bottom that reaches the axis"),
        Role::Die => (size_of(model, low, Amount::drawn), "of the throat"),
        Role::Holder => (size_of(model, low, Amount::drawn), "of the inner edge"),
    };
    let of = match model.geometry {
        Geometry::PlaneStrain if !closed => format!("half-width {of}"),
        _ => of.into(),
    };
    let widens = tool.role == Role::Punch && widens(tool, model.travel);
    let mouth = widens.then(|| size_of(model, mouth(tool, model.travel), Amount::drawn));
    let mouth = mouth.map_or_else(String::new, |mouth| format!("{mouth} at the sheet at the full travel"));
    let friction = match &tool.friction {
        Friction::Coulomb(_) => format!("friction {}", Amount::number(tool.friction.largest_coefficient())),
        law => format!("friction {law}"),
    };
    let meaning = joined([of, mouth, corners(tool, model.blank.thickness), friction], ", ");
    line(tool.role.name(), size, meaning)
}

fn corners(tool: &Tool, thickness: f64) -> String {
    let text = |radius: f64| format!("R {} ({})", Amount::drawn(radius), Amount::thicknesses(radius / thickness));
    let mut radii: Vec<f64> = tool.profile.corners().map(|arc| arc.radius).collect();
    if radii.len() > FEW {
        radii.sort_by(f64::total_cmp);
        let [smallest, largest] = [radii[0], radii[radii.len() - 1]].map(text);
        return format!("{} arcs, {smallest} to {largest}", radii.len());
    }
    joined(radii.into_iter().map(text), ", ")
}

fn pace(model: &Model) -> String {
    let speed = Amount::size(model.speed);
    match &model.schedule {
        _ if !model.timed => String::new(),
        None => format!("at {speed}/s"),
        Some(schedule) => {
            let pairs = schedule.points().windows(2);
            let speeds: Vec<f64> = pairs.map(|w| (w[1].1 - w[0].1) / (w[1].0 - w[0].0)).collect();
            let [slowest, fastest] = [(f64::INFINITY, f64::min as fn(f64, f64) -> f64), (0.0, f64::max)]
                .map(|(start, of)| Amount::size(speeds.iter().copied().fold(start, of)));
            format!("at {speed}/s on average, {slowest}/s to {fastest}/s")
        }
    }
}
