//! Check of a case before it is solved: its numbers, rules of thumb, and warnings.

mod line;
mod loads;
mod settings;
mod tools;

pub use line::Line;

use super::{Kind, before, estimate, sentences};
use crate::case::Case;
use crate::model::{Extent, Geometry, Model, Theory};
use crate::units::{Amount, Digits, Unit, ZERO_CELSIUS, joined};
use line::{line, number, size_of};
use std::fmt;

/// Check of a case before it is solved.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Check {
    /// Title of the case.
    pub title: String,
    /// The case in numbers.
    pub lines: Vec<Line>,
    /// Constants of the sheet, mesh and settings, from which the run can be repeated.
    pub details: Vec<Line>,
    /// Doubts; the case can be solved all the same.
    pub warnings: Vec<String>,
    /// Assumptions, declared or made while reading.
    pub notes: Vec<String>,
}

/// Checks a case without solving it.
pub fn report(case: &Case) -> Check {
    let model = case.model();
    let strength = estimate::tensile_strength(&model.material);
    let source = |label, source: &Option<String>| source.as_ref().map(|source| line(label, source.clone(), ""));
    let mut lines = blank(model);
    lines.push(line("material", model.material.describe(), ""));
    lines.extend(source("material source", &case.sources.material));
    lines.push(number("tensile strength", Amount::stress(strength), "by the law, at Considère's load maximum"));
    lines.extend(tools::lines(model));
    lines.extend(source("friction source", &case.sources.friction));
    lines.extend(loads::holder(model, strength));
    lines.push(number("elements", Amount::count(model.blank.elements as f64), ""));
    lines.extend(estimate::coarsest_corner(model).map(|fit| {
        let (tool, radius) = (fit.role.name(), Amount::drawn(fit.radius));
        let per_quarter = Amount::new(fit.per_quarter, Unit::None, Digits::Significant(2));
        let meaning = format!("at the {tool}'s radius of {radius}: {per_quarter} elements per 90°");
        number("element size", Amount::size(fit.size), meaning)
    }));
    lines.extend(case.later().iter().enumerate().map(|(i, stage)| loads::stage(i + 2, stage)));
    lines.extend(case.compare.iter().map(|spec| {
        let missing = if spec.data.is_some() { "" } else { " (no data: add the CSV file to see it)" };
        line("compare", spec.reference.display().to_string(), format!("{}{missing}", spec.against))
    }));
    let findings = before(case);
    Check {
        title: model.title.clone(),
        lines,
        details: settings::lines(case),
        warnings: sentences(&findings, Kind::Warning),
        notes: model.notes.iter().cloned().chain(sentences(&findings, Kind::Assumption)).collect(),
    }
}

fn blank(model: &Model) -> Vec<Line> {
    let blank = &model.blank;
    let (geometry, meaning): (String, _) = match model.geometry {
        Geometry::Axisymmetric => ("axisymmetric".into(), String::new()),
        Geometry::PlaneStrain => {
            ("plane strain".into(), format!("half length, {} in all", Amount::set(2.0 * blank.length)))
        }
    };
    let volume = |unit| Amount::new(model.extent().area(blank.length) * blank.thickness, unit, Digits::Significant(3));
    let points = blank.layers;
    let theory = match blank.theory {
        Theory::Bending => format!("bending, {points} points through the thickness"),
        Theory::Membrane => "membrane".into(),
        Theory::Selective => {
            let ratio = Amount::number(model.settings.bend_ratio);
            format!("bending with {points} points where t/R is above {ratio}, else membrane")
        }
    };
    let mut lines = vec![
        line("geometry", joined([geometry, model.extent().described()], "; "), ""),
        line("blank", size_of(model, blank.length, Amount::set), meaning),
        number("thickness", Amount::size(blank.thickness), ""),
        match model.extent() {
            Extent::PerDepth => number("volume", volume(Unit::Mm2), "times the depth"),
            _ => number("volume", volume(Unit::Mm3), ""),
        },
        line("theory", theory, ""),
    ];
    lines.extend(model.heat.as_ref().map(|heat| {
        let ends = [heat.initial.smallest(), heat.initial.largest()];
        let [low, high] = ends.map(|kelvin| Amount::temperature(kelvin - ZERO_CELSIUS));
        let range = if low == high { low.into() } else { format!("{low} to {high}") };
        line("temperature", range, if heat.flow.is_some() { "at first" } else { "throughout" })
    }));
    lines
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.title)?;
        let width = self.lines.iter().map(|line| line.label.chars().count()).max().unwrap_or(0);
        for Line { label, value, meaning, .. } in &self.lines {
            writeln!(f, "  {label:<width$}  {}", joined([value.clone(), meaning.clone()], " "))?;
        }
        for (heading, entries) in [("notes", &self.notes), ("warnings", &self.warnings)] {
            if !entries.is_empty() {
                writeln!(f, "\n{heading}")?;
            }
            entries.iter().try_for_each(|entry| writeln!(f, "  - {entry}"))?;
        }
        Ok(())
    }
}
