//! Lines on tools, loads and later stages: sizes, radii, travel, holder, beads, gas, motions.

use super::{Line, line, number, size_of};
use crate::assess::estimate;
use crate::contact::friction::Friction;
use crate::geometry::Piece;
use crate::model::tool_sizes::{embosses, extent, full_mouth, throat, widens};
use crate::model::{Bead, Edge, Face, Gas, Geometry, Mode, Model, Motion, Pressure, Role, Tool, stage::Stage};
use crate::rules::Metal;
use crate::units::{Amount, Digits, Unit, joined};

const MANY: usize = 8;
const FEW: usize = 4;

pub(super) fn lines(model: &Model) -> Vec<Line> {
    let mut lines: Vec<Line> = model.tools.iter().map(|tool| of_tool(model, tool)).collect();
    lines.extend((model.travel > 0.0).then(|| number("travel", Amount::set(model.travel), pace(model))));
    lines.extend(estimate::clearance(model, model.travel).map(|clearance| {
        let over_t = format!("or {}", Amount::thicknesses(clearance / model.blank.thickness));
        number("clearance", Amount::drawn(clearance), over_t)
    }));
    lines.extend(estimate::draw_ratio(model).map(|ratio| {
        let metal = Metal::of(&model.material);
        let meaning = format!("blank over punch; {} is the limit of one draw for {}", metal.ratios[0], metal.name);
        number("draw ratio", Amount::ratio(ratio), meaning)
    }));
    lines.extend(model.beads.iter().map(|bead| of_bead(model, bead)));
    lines.extend(model.gas.iter().map(|gas| of_gas(model, gas)));
    lines
}

/// Name, size, drive, radii and friction of a tool.
pub fn of_tool(model: &Model, tool: &Tool) -> Line {
    let ((low, high), side) = (extent(tool), if tool.role.side() > 0.0 { "die's side" } else { "punch's side" });
    let closed = tool.role == Role::Die && throat(tool).is_none();
    let range = || {
        let ends = [low, high].map(|half| (half > 0.0).then(|| size_of(model, half, Amount::drawn)));
        joined(ends.into_iter().flatten(), " to ")
    };
    let (size, of) = match tool.role {
        Role::Punch | Role::Die if model.blank.is_open() => (range(), "across"),
        Role::Die if closed => ("closed".into(), "by a bottom that reaches the axis"),
        Role::Die => (size_of(model, low, Amount::drawn), "of the throat"),
        Role::Holder => (size_of(model, low, Amount::drawn), "of the inner edge"),
        Role::Punch if embosses(model) || high > model.blank.length => {
            (size_of(model, high, Amount::drawn), "over all")
        }
        Role::Upper(_) | Role::Lower(_) => (range(), side),
        _ => (size_of(model, high, Amount::drawn), "to the wall"),
    };
    let of = if model.geometry == Geometry::PlaneStrain && !closed { format!("half-width {of}") } else { of.into() };
    let widens = tool.role == Role::Punch && !model.blank.is_open() && widens(tool, model.travel);
    let mouth = widens.then(|| size_of(model, full_mouth(model, tool), Amount::drawn));
    let mouth = mouth.map_or_else(String::new, |mouth| format!("{mouth} at the sheet at the full travel"));
    let friction = match &tool.friction {
        Friction::Coulomb(_) => format!("friction {}", Amount::number(tool.friction.largest_coefficient())),
        law => format!("friction {law}"),
    };
    let drive = tool.role.further().map_or_else(String::new, |_| drive(model, tool));
    let meaning = joined([of, drive, mouth, opening(tool), corners(tool, model.blank.thickness), friction], ", ");
    line(model.name_of(tool.role), size, meaning)
}

fn opening(tool: &Tool) -> String {
    let die = Some(&tool.profile).filter(|_| tool.role == Role::Die);
    let angle = |angle: f64| format!("{}°", Amount::number(angle.to_degrees()));
    let cone = die.and_then(|die| die.cone()).map(|cone| format!("cone {}", angle(cone)));
    let arcs = die.map_or(0, |die| die.pieces().iter().filter(|piece| matches!(piece, Piece::Arc(_))).count());
    let entry = cone.or((arcs > MANY).then(|| format!("entry of {arcs} arcs"))).unwrap_or_default();
    let land = die.and_then(|die| die.land());
    let land = land.map(|[land, relief]| format!("land {}, relief {}", Amount::drawn(land), angle(relief)));
    joined([entry, land.unwrap_or_default()], ", ")
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
        _ if model.stop.drawn_through => "at most: it ends when the rim is through the die".into(),
        _ if !model.timed => String::new(),
        None => format!("at {speed}/s"),
        Some(schedule) => {
            let speeds = schedule.points().windows(2).map(|w| (w[1].1 - w[0].1) / (w[1].0 - w[0].0));
            let (slowest, fastest) = (speeds.clone().fold(f64::INFINITY, f64::min), speeds.fold(0.0, f64::max));
            let [slowest, fastest] = [slowest, fastest].map(Amount::size);
            format!("at {speed}/s on average, {slowest}/s to {fastest}/s")
        }
    }
}

pub(super) fn holder(model: &Model) -> Vec<Line> {
    let force = |force: f64| Amount::given_force(force, model.extent().force_unit());
    let press = match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Gap(gap)) => {
            let ratio = Amount::thicknesses(gap / model.blank.thickness);
            return vec![number("holder gap", Amount::size(*gap), format!("to the die, {ratio}: fixed"))];
        }
        Some(Motion::Pressed(press)) => press,
        _ => return Vec::new(),
    };
    let [least, most] = [press.force.smallest(), press.force.largest()].map(force);
    let text = if least == most { most.to_string() } else { format!("{least} to {most}") };
    let meaning = match press.stiffness {
        _ if model.blank.edge == Edge::Clamped => "of no effect on the edge, which is clamped".into(),
        0.0 if least == most => String::new(),
        0.0 => "over the travel".into(),
        stiffness => format!("on the flat sheet, and {} more per mm that it is lifted", force(stiffness)),
    };
    let mut lines = vec![line("holder force", text, meaning)];
    let Some((area, pressure)) = estimate::held_area(model).zip(estimate::holder_pressure(model)) else { return lines };
    let on = "on the initial area between holder and die's flat";
    lines.push(number("holder pressure", Amount::stress(pressure), on));
    lines.extend(estimate::siebel_pressure(model).map(|siebel| {
        let rule = "against wrinkles, by Siebel's rule, 0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m (Kugler 2009)";
        number("least pressure", Amount::stress(siebel), format!("{rule}: {}", force(siebel * area)))
    }));
    lines
}

fn of_bead(model: &Model, bead: &Bead) -> Line {
    let [restraining, closing] =
        [bead.restraining.largest(), bead.closing].map(|force| Amount::given_force(force, Unit::NPerMm));
    line("bead", size_of(model, bead.at, Amount::drawn), format!("restraining up to {restraining}, closing {closing}"))
}

fn of_gas(model: &Model, gas: &Gas) -> Line {
    let (within, time) = (Amount::size(gas.within), Amount::time(model.duration));
    let lower = gas.face == Face::Lower;
    let place = match model.blank.is_open() {
        true => format!("{} the tube, for {time}", if lower { "inside" } else { "outside" }),
        false => format!("on the {} face within {within}, for {time}", if lower { "lower" } else { "upper" }),
    };
    let control = match &gas.pressure {
        Pressure::OverTime(history) => {
            return number("pressure", Amount::given_stress(history.largest()), format!("at most {place}"));
        }
        Pressure::Rate(control) => control,
    };
    let norm = format!("held by the pressure (norm with q = {})", Amount::number(control.exponent));
    let at_most = |value: f64, per: &str| match value.is_finite() {
        true => format!("{}{per} at most", Amount::given_stress(value)),
        false => String::new(),
    };
    let limits = joined([norm, at_most(control.max_pressure, ""), at_most(control.max_rise, "/s")], ", ");
    let rate = Amount::new(control.target, Unit::PerSecond, Digits::Significant(3));
    number("strain rate", rate, format!("{limits} {place}"))
}

fn drive(model: &Model, tool: &Tool) -> String {
    let most = if model.stop.drawn_through { " at most" } else { "" };
    match &tool.motion {
        Motion::Path(by) if by.x == 0.0 => format!("goes {}{most}", Amount::size(by.y)),
        Motion::Path(by) => format!("goes {} and {} aside", Amount::size(by.y), Amount::size(by.x)),
        Motion::Travel => "goes with the punch".into(),
        Motion::Course(course) => format!("goes {} by its path", Amount::size(course.at(model.travel))),
        Motion::Pressed(press) => {
            let force = Amount::given_force(press.force.at(model.travel), model.extent().force_unit());
            let more = Amount::given_force(press.stiffness, model.extent().force_unit());
            match press.stiffness {
                0.0 if press.force.smallest() == press.force.largest() => format!("presses with {force}"),
                0.0 => format!("presses with {force} at the end"),
                _ => format!("presses with {force} at first, and {more} more per mm"),
            }
        }
        Motion::Fixed | Motion::Gap(_) => "stands".into(),
    }
}

pub(super) fn stage(n: usize, stage: &Stage) -> Line {
    let Stage { model, begin, .. } = stage;
    let mut does = Vec::new();
    does.extend(begin.trim.map(|half| format!("cut at {}", size_of(model, half, Amount::set))));
    does.extend(begin.turn_over.then(|| "turned over".into()));
    does.extend(begin.anneal.then(|| "annealed".into()));
    for tool in &model.tools {
        let new = if begin.meets.contains(&tool.role) { "new " } else { "" };
        does.push(format!("{new}{} {}", model.name_of(tool.role), drive(model, tool)));
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
