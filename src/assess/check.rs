//! What can be said of a case before it is solved: its numbers, rules of thumb, and warnings.

mod details;
mod line;
mod loads;
mod stages;
mod tools;

pub use line::Line;

use super::{Kind, before, sentences};
use crate::case::Case;
use crate::message::{Amount, Digits, Form, Message, NO_BREAK, message};
use crate::model::{Extent, Geometry, Model, Theory};
use crate::rules::estimate;
use crate::table::Unit;
use crate::units::ZERO_CELSIUS;
use line::{line, size_of};
use std::fmt;

/// A case looked over before it is solved.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
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
    lines.push(line("material", Message::Formula(model.material.describe()), ""));
    lines.extend(case.sources.material.as_ref().map(|source| line("material source", source.clone(), "")));
    let strength = estimate::tensile_strength(&model.material);
    lines.push(line("tensile strength", Amount::stress(strength), "by the law, at Considère's load maximum"));
    tools::lines(model, &mut lines);
    lines.extend(case.sources.friction.as_ref().map(|source| line("friction source", source.clone(), "")));
    loads::holder(model, strength, &mut lines);
    mesh(model, &mut lines);
    for (i, stage) in case.later().iter().enumerate() {
        lines.push(line(message!("stage {n}", n = i + 2), stage.name.clone(), stages::describe(stage)));
    }
    let compare = case.compare.iter().map(|spec| {
        let against = spec.against.to_string();
        let meaning = match spec.data {
            Some(_) => against.into(),
            None => message!("{against} (not there: drop the CSV in to see the overlay)", against = against),
        };
        line("compare", spec.reference.display().to_string(), meaning)
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

fn blank(model: &Model, lines: &mut Vec<Line>) {
    let blank = &model.blank;
    let whole = Amount::set(2.0 * blank.length);
    let (geometry, meaning): (Message, _) = match model.geometry {
        Geometry::Axisymmetric => ("axisymmetric".into(), Message::default()),
        Geometry::PlaneStrain => ("plane strain".into(), message!("half length, {whole} in all", whole = whole)),
    };
    lines.push(line("geometry", Message::joined([geometry, model.extent().described()], "; "), ""));
    lines.push(line("blank", size_of(model, blank.length, Amount::set), meaning));
    lines.push(line("thickness", Amount::size(blank.thickness), ""));
    let volume = |unit| Amount::new(model.extent().area(blank.length) * blank.thickness, unit, Digits::Significant(3));
    let (volume, meaning): (Message, _) = match model.extent() {
        Extent::PerDepth => (volume(Unit::Mm2).into(), "times the depth"),
        _ => (volume(Unit::Mm3).into(), ""),
    };
    lines.push(line("volume", volume, meaning));
    let theory = match blank.theory {
        Theory::Bending => message!("bending, {n} points through the thickness", n = blank.layers),
        Theory::Membrane => "membrane".into(),
        Theory::Selective => message!(
            "bending with {n} points where t/R is above {ratio}, else membrane",
            n = blank.layers,
            ratio = Amount::number(model.settings.bend_ratio)
        ),
    };
    lines.push(line("theory", theory, ""));
    if let Some(heat) = &model.heat {
        let [low, high] =
            [heat.initial.smallest(), heat.initial.largest()].map(|t| Amount::temperature(t - ZERO_CELSIUS));
        let range = if low == high { low.into() } else { message!("{low} to {high}", low = low, high = high) };
        let stays = if heat.flow.is_some() { "at first" } else { "throughout" };
        lines.push(line("temperature", range, stays));
    }
}

fn mesh(model: &Model, lines: &mut Vec<Line>) {
    lines.push(line("elements", Amount::count(model.blank.elements), ""));
    if let Some(fit) = estimate::coarsest_corner(model) {
        let meaning = message!(
            "at the {tool}'s radius of {radius}: {n} elements per 90°",
            tool = fit.role.name(),
            radius = Amount::drawn(fit.radius),
            n = Amount::new(fit.per_quarter, Unit::None, Digits::Significant(2))
        );
        lines.push(line("element size", Amount::size(fit.size), meaning));
    }
}

impl Check {
    /// As aligned text; a number and its unit are kept together by no-break spaces.
    pub fn told(&self, form: Form) -> String {
        let mut text = format!("{}\n\n", self.title);
        let labels: Vec<String> = self.lines.iter().map(|line| line.label.told(form)).collect();
        let width = labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
        for (label, Line { value, meaning, .. }) in labels.iter().zip(&self.lines) {
            let said = Message::joined([value.clone(), meaning.clone()], " ").told(form);
            text += &format!("  {label:<width$}  {said}\n");
        }
        for (heading, entries) in [("notes", &self.notes), ("warnings", &self.warnings)] {
            if !entries.is_empty() {
                text += &format!("\n{}\n", Message::from(heading).told(form));
            }
            for entry in entries {
                text += &format!("  - {}\n", entry.told(form));
            }
        }
        text
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(Form::default()).replace(NO_BREAK, " "))
    }
}
