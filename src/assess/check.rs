//! What can be said of a case before it is solved: its numbers, rules of thumb, and warnings.

mod details;
mod line;
mod loads;
mod stages;
mod tools;

pub use line::Line;

use super::{Kind, before, sentences};
use crate::assess::estimate;
use crate::case::Case;
use crate::model::{Extent, Geometry, Model, Theory};
use crate::table::Unit;
use crate::units::ZERO_CELSIUS;
use crate::units::{Amount, Digits, joined};
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
    pub warnings: Vec<String>,
    /// Declared assumptions, and what was assumed while reading.
    pub notes: Vec<String>,
}

/// Looks a case over without solving it.
pub fn report(case: &Case) -> Check {
    let model = case.model();
    let mut lines = Vec::new();
    blank(model, &mut lines);
    lines.push(line("material", String::from(model.material.describe()), ""));
    lines.extend(case.sources.material.as_ref().map(|source| line("material source", source.clone(), "")));
    let strength = estimate::tensile_strength(&model.material);
    lines.push(line("tensile strength", Amount::stress(strength), "by the law, at Considère's load maximum"));
    tools::lines(model, &mut lines);
    lines.extend(case.sources.friction.as_ref().map(|source| line("friction source", source.clone(), "")));
    loads::holder(model, strength, &mut lines);
    mesh(model, &mut lines);
    for (i, stage) in case.later().iter().enumerate() {
        lines.push(line(format!("stage {n}", n = i + 2), stage.name.clone(), stages::describe(stage)));
    }
    let compare = case.compare.iter().map(|spec| {
        let against = spec.against.to_string();
        let meaning = match spec.data {
            Some(_) => against.into(),
            None => format!("{against} (not there: drop the CSV in to see the overlay)"),
        };
        line("compare", spec.reference.display().to_string(), meaning)
    });
    lines.extend(compare);
    let findings = before(case);
    let notes = model.notes.iter().cloned().map(String::from).chain(sentences(&findings, Kind::Assumption)).collect();
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
    let (geometry, meaning): (String, _) = match model.geometry {
        Geometry::Axisymmetric => ("axisymmetric".into(), String::new()),
        Geometry::PlaneStrain => ("plane strain".into(), format!("half length, {whole} in all")),
    };
    lines.push(line("geometry", joined([geometry, model.extent().described()], "; "), ""));
    lines.push(line("blank", size_of(model, blank.length, Amount::set), meaning));
    lines.push(line("thickness", Amount::size(blank.thickness), ""));
    let volume = |unit| Amount::new(model.extent().area(blank.length) * blank.thickness, unit, Digits::Significant(3));
    let (volume, meaning): (String, _) = match model.extent() {
        Extent::PerDepth => (volume(Unit::Mm2).into(), "times the depth"),
        _ => (volume(Unit::Mm3).into(), ""),
    };
    lines.push(line("volume", volume, meaning));
    let theory = match blank.theory {
        Theory::Bending => format!("bending, {n} points through the thickness", n = blank.layers),
        Theory::Membrane => "membrane".into(),
        Theory::Selective => format!(
            "bending with {n} points where t/R is above {ratio}, else membrane",
            n = blank.layers,
            ratio = Amount::number(model.settings.bend_ratio)
        ),
    };
    lines.push(line("theory", theory, ""));
    if let Some(heat) = &model.heat {
        let [low, high] =
            [heat.initial.smallest(), heat.initial.largest()].map(|t| Amount::temperature(t - ZERO_CELSIUS));
        let range = if low == high { low.into() } else { format!("{low} to {high}") };
        let stays = if heat.flow.is_some() { "at first" } else { "throughout" };
        lines.push(line("temperature", range, stays));
    }
}

fn mesh(model: &Model, lines: &mut Vec<Line>) {
    lines.push(line("elements", Amount::count(model.blank.elements), ""));
    if let Some(fit) = estimate::coarsest_corner(model) {
        let meaning = format!(
            "at the {tool}'s radius of {radius}: {n} elements per 90°",
            tool = fit.role.name(),
            radius = Amount::drawn(fit.radius),
            n = Amount::new(fit.per_quarter, Unit::None, Digits::Significant(2))
        );
        lines.push(line("element size", Amount::size(fit.size), meaning));
    }
}

impl Check {
    fn text(&self) -> String {
        let mut text = format!("{}\n\n", self.title);
        let labels: Vec<String> = self.lines.iter().map(|line| line.label.to_string()).collect();
        let width = labels.iter().map(|label| label.chars().count()).max().unwrap_or(0);
        for (label, Line { value, meaning, .. }) in labels.iter().zip(&self.lines) {
            let said = joined([value.clone(), meaning.clone()], " ").to_string();
            text += &format!("  {label:<width$}  {said}\n");
        }
        for (heading, entries) in [("notes", &self.notes), ("warnings", &self.warnings)] {
            if !entries.is_empty() {
                text += &format!("\n{}\n", String::from(heading).to_string());
            }
            for entry in entries {
                text += &format!("  - {}\n", entry.to_string());
            }
        }
        text
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())
    }
}
