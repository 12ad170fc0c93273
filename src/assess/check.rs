//! What can be said of a case before it is solved: its numbers in solver units, rules of thumb, and warnings.

mod details;
mod stages;

use super::{Kind, before, sentences};
use crate::case::Case;
use crate::message::Message;
use crate::model::{Extent, Face, Geometry, Model, Motion, Pressure, Role, Theory, Tool};
use crate::rules::design::LIMITING_RATIO;
use crate::rules::estimate;
use crate::rules::tool_sizes::{across, extent, mouth, throat, widens};
use crate::units::mm;
use crate::units::{ZERO_CELSIUS, rounded};
use serde::Serialize;
use std::fmt;

/// One line of the report.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Line {
    /// What is said.
    pub label: String,
    /// The number or word itself.
    pub value: String,
    /// Unit, and what it means or where it comes from.
    pub meaning: String,
}

/// A case looked over before it is solved.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Check {
    /// The case's title.
    pub title: String,
    /// The case in numbers, in the order of telling.
    pub lines: Vec<Line>,
    /// What a report adds, so that the run can be judged and repeated: constants of the sheet, mesh and settings.
    pub details: Vec<Line>,
    /// What should be known before the result is trusted; the case can be solved all the same.
    pub warnings: Vec<Message>,
    /// Declared assumptions, and what was assumed while reading.
    pub notes: Vec<Message>,
}

/// Looks a case over without solving it.
pub fn report(case: &Case) -> Check {
    let model = case.model();
    let mut lines = Vec::new();
    blank(model, &mut lines);
    lines.push(line("material", model.material.describe(), ""));
    lines.extend(case.sources.material.as_ref().map(|source| line("material source", source, "")));
    let strength = estimate::tensile_strength(&model.material.hardening);
    lines.push(line("tensile strength", format!("{strength:.0}"), "MPa, from the law at Considère's load maximum"));
    tools(model, &mut lines);
    lines.extend(case.sources.friction.as_ref().map(|source| line("friction source", source, "")));
    holder(model, strength, &mut lines);
    mesh(model, &mut lines);
    for (i, stage) in case.later().iter().enumerate() {
        lines.push(line(format!("stage {}", i + 2), &stage.name, stages::describe(stage)));
    }
    let compare = case.compare.iter().map(|spec| {
        let there = if spec.data.is_some() { "" } else { " (not there: drop the CSV in to see the overlay)" };
        line("compare", spec.reference.display().to_string(), format!("{}{there}", spec.against))
    });
    lines.extend(compare);
    let findings = before(case);
    let notes = model.notes.iter().cloned().map(Message::from).chain(sentences(&findings, Kind::Assumption)).collect();
    Check {
        title: model.title.clone(),
        lines,
        details: details::lines(case),
        warnings: sentences(&findings, Kind::Warning),
        notes,
    }
}

fn line(label: impl Into<String>, value: impl Into<String>, meaning: impl Into<String>) -> Line {
    Line { label: label.into(), value: value.into(), meaning: meaning.into() }
}

fn blank(model: &Model, lines: &mut Vec<Line>) {
    let blank = &model.blank;
    let (geometry, size) = match model.geometry {
        Geometry::Axisymmetric => ("axisymmetric", format!("mm radius, {} mm diameter", mm(2.0 * blank.length))),
        Geometry::PlaneStrain => ("plane strain", format!("mm half length, {} mm in all", mm(2.0 * blank.length))),
    };
    lines.push(line("geometry", geometry, model.extent().described()));
    lines.push(line("blank", mm(blank.length), size));
    lines.push(line("thickness", mm(blank.thickness), "mm"));
    let volume = model.extent().area(blank.length) * blank.thickness;
    let unit = if model.extent() == Extent::PerDepth { "mm³ per mm of depth" } else { "mm³" };
    lines.push(line("volume", format!("{volume:.0}"), unit));
    let theory = match blank.theory {
        Theory::Bending => format!("bending, {} points through the thickness", blank.layers),
        Theory::Membrane => "membrane".into(),
        Theory::Selective => {
            format!(
                "bending with {} points where t/R is above {}, else membrane",
                blank.layers, model.settings.bend_ratio
            )
        }
    };
    lines.push(line("theory", theory, ""));
    if let Some(heat) = &model.heat {
        let [low, high] = [heat.initial.smallest(), heat.initial.largest()].map(|t| rounded(t - ZERO_CELSIUS));
        let range = if low == high { format!("{low}") } else { format!("{low} to {high}") };
        let stays = if heat.flow.is_some() { "°C at first" } else { "°C throughout" };
        lines.push(line("temperature", range, stays));
    }
}

fn tools(model: &Model, lines: &mut Vec<Line>) {
    for tool in &model.tools {
        let (low, high) = extent(tool);
        let bottom = tool.role == Role::Die && throat(tool).is_none();
        let size = match tool.role {
            Role::Punch => mm(high),
            Role::Die if bottom => "closed".into(),
            Role::Die | Role::Holder => mm(low),
        };
        let corners = corners(tool, model.blank.thickness);
        let width = across(model.geometry);
        let what = match tool.role {
            Role::Punch if widens(tool, model.travel) => {
                format!("mm {width} to the wall, {} at the sheet at the full travel", mm(mouth(tool, model.travel)))
            }
            Role::Punch => format!("mm {width} to the wall"),
            Role::Die if bottom => "by a bottom that reaches the axis".to_owned(),
            Role::Die => format!("mm {width} of the throat"),
            Role::Holder => format!("mm {width} of the inner edge"),
        };
        lines.push(line(tool.role.name(), size, format!("{what}{corners}, friction {}", tool.friction)));
    }
    if model.travel > 0.0 {
        let changes = model.schedule.as_ref().map_or(String::new(), |schedule| {
            let points = schedule.points();
            let speeds = || points.windows(2).map(|w| (w[1].1 - w[0].1) / (w[1].0 - w[0].0));
            let (slowest, fastest) = (speeds().fold(f64::INFINITY, f64::min), speeds().fold(0.0, f64::max));
            format!(" on average, {} to {} mm/s", rounded(slowest), rounded(fastest))
        });
        let pace = if model.timed { format!(" at {} mm/s{changes}", rounded(model.speed)) } else { String::new() };
        lines.push(line("travel", mm(model.travel), format!("mm{pace}")));
    }
    for bead in &model.beads {
        let meaning = format!("mm from the axis, restraining {} N/mm, closing {} N/mm", bead.restraining, bead.closing);
        lines.push(line("bead", mm(bead.at), meaning));
    }
    for gas in &model.gas {
        let face = if gas.face == Face::Lower { "lower" } else { "upper" };
        let place = format!("on the {face} face within {} mm, for {} s", mm(gas.within), model.duration);
        lines.push(match &gas.pressure {
            Pressure::OverTime(history) => {
                line("gas pressure", format!("{}", history.largest()), format!("MPa at most {place}"))
            }
            Pressure::Rate(control) => {
                let mut norm = format!("1/s held by the pressure (norm with q = {})", control.exponent);
                if control.max_pressure.is_finite() {
                    norm += &format!(", {} MPa at most", rounded(control.max_pressure));
                }
                if control.max_rise.is_finite() {
                    norm += &format!(", {} MPa/s at most", rounded(control.max_rise));
                }
                line("strain rate", format!("{}", control.target), format!("{norm} {place}"))
            }
        });
    }
    if let Some(clearance) = estimate::clearance(model) {
        let over_t = clearance / model.blank.thickness;
        lines.push(line("clearance", mm(clearance), format!("mm, {over_t:.2} thicknesses")));
    }
    if let Some(ratio) = estimate::draw_ratio(model) {
        lines.push(line(
            "draw ratio",
            format!("{ratio:.3}"),
            format!("blank over punch; about {LIMITING_RATIO} is the limit of one draw"),
        ));
    }
}

/// The radii over which the sheet is bent; of many, which round a curve off, the smallest and the largest.
fn corners(tool: &Tool, thickness: f64) -> String {
    let written = |radius: f64| format!("R {} ({:.1} t)", mm(radius), radius / thickness);
    let mut radii: Vec<f64> = tool.profile.corners().map(|arc| arc.radius).collect();
    if radii.len() > 4 {
        radii.sort_by(f64::total_cmp);
        let (smallest, largest) = (radii[0], radii[radii.len() - 1]);
        return format!(", {} arcs, {} to {}", radii.len(), written(smallest), written(largest));
    }
    radii.into_iter().map(|radius| format!(", {}", written(radius))).collect()
}

fn holder(model: &Model, strength: f64, lines: &mut Vec<Line>) {
    let unit = model.extent().force_unit().symbol();
    let force = match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Gap(gap)) => {
            let meaning = format!("mm to the die, {:.3} thicknesses: fixed", gap / model.blank.thickness);
            lines.push(line("holder gap", mm(*gap), meaning));
            return;
        }
        Some(Motion::Pressed(press)) => press,
        _ => return,
    };
    let (least, most) = (force.force.smallest(), force.force.largest());
    let text = if least == most { format!("{most:.0}") } else { format!("{least:.0} to {most:.0}") };
    let meaning = match force.stiffness {
        0.0 if least == most => unit.to_owned(),
        0.0 => format!("{unit} over the travel"),
        c => format!("{unit} on the flat sheet, and {c:.0} {unit} more per mm that it is lifted"),
    };
    lines.push(line("holder force", text, meaning));
    let (Some(area), Some(pressure)) = (estimate::held_area(model), estimate::holder_pressure(model)) else { return };
    let meaning = "MPa on the initial area between holder and die's flat";
    lines.push(line("holder pressure", format!("{pressure:.3}"), meaning));
    if let Some(siebel) = estimate::siebel_pressure(model, strength) {
        let meaning =
            "MPa by Siebel's rule, 0.0025 [(β − 1)² + 0.5 d/(100 t)] R_m, as Kugler, Umformtechnik (2009), has it";
        lines.push(line("advised pressure", format!("{siebel:.3}"), format!("{meaning}: {:.0} N", siebel * area)));
    }
}

fn mesh(model: &Model, lines: &mut Vec<Line>) {
    lines.push(line("elements", model.blank.elements.to_string(), ""));
    if let Some(fit) = estimate::coarsest_corner(model) {
        let meaning = format!(
            "mm at the {}'s radius of {} mm: {:.1} elements per 90°",
            fit.role.name(),
            mm(fit.radius),
            fit.per_quarter
        );
        lines.push(line("element size", mm(fit.size), meaning));
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.title)?;
        for Line { label, value, meaning } in &self.lines {
            writeln!(f, "  {label:<18}{}", format!("{value} {meaning}").trim_end())?;
        }
        for (heading, entries) in [("notes", &self.notes), ("warnings", &self.warnings)] {
            if !entries.is_empty() {
                writeln!(f, "\n{heading}")?;
            }
            for entry in entries {
                writeln!(f, "  - {entry}")?;
            }
        }
        Ok(())
    }
}
