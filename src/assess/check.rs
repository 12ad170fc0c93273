//! Check of a case before it is solved: its numbers, rules of thumb, and warnings.

mod tools;

pub use tools::of_tool;

use super::*;
use crate::model::{Extent, Grading, Theory};
use crate::units::ZERO_CELSIUS;
use std::fmt;

/// Check of a case before it is solved.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
    let strength = estimate::flange_strength(model);
    let source = |label, source: &Option<String>| source.as_ref().map(|source| line(label, source.clone(), ""));
    let mut lines = blank(model);
    lines.push(line("material", model.material.describe(), ""));
    lines.extend(source("material source", &case.sources.material));
    lines.push(number("tensile strength", Amount::stress(strength), "by the law, at Considère's load maximum"));
    lines.extend(tools::lines(model));
    lines.extend(source("friction source", &case.sources.friction));
    lines.extend(tools::holder(model));
    lines.push(number("elements", Amount::count(model.blank.elements as f64), ""));
    lines.extend(estimate::coarsest_corner(model).map(|fit| {
        let (tool, radius, count) = (model.name_of(fit.role), Amount::drawn(fit.radius), Amount::norm(fit.per_quarter));
        let meaning = format!("at the {tool}'s radius of {radius}: {count} elements per 90°");
        number("element size", Amount::size(fit.size), meaning)
    }));
    lines.extend(case.later().iter().enumerate().map(|(i, stage)| tools::stage(i + 2, stage)));
    lines.extend(case.compare.iter().map(|spec| {
        let tolerance = format!("{} %", 100.0 * spec.tolerance);
        let accepted = if spec.quantity.is_curve() { &tolerance } else { "the band of the values" };
        let missing = if spec.data.is_some() { "" } else { " (no data: add the CSV file to see it)" };
        let meaning = format!("{} within {accepted}{missing}", spec.quantity.name());
        line("compare", spec.reference.display().to_string(), meaning)
    }));
    let findings = before(case);
    Check {
        title: model.title.clone(),
        lines,
        details: details(model),
        warnings: sentences(&findings, Kind::Warning),
        notes: model.notes.iter().cloned().chain(sentences(&findings, Kind::Assumption)).collect(),
    }
}

fn blank(model: &Model) -> Vec<Line> {
    let (blank, extent) = (&model.blank, model.extent());
    let (geometry, meaning) = match model.geometry {
        Geometry::Axisymmetric => ("axisymmetric", String::new()),
        Geometry::PlaneStrain => ("plane strain", format!("half length, {} in all", Amount::set(2.0 * blank.length))),
    };
    let (radius, meaning) = match blank.meridian {
        None => (blank.length, meaning),
        Some(_) => (blank.reach() + 0.5 * blank.thickness, format!("outside, {} along it", Amount::set(blank.length))),
    };
    let hole = Some(blank.hole).filter(|_| blank.meridian.is_none() && blank.has_hole());
    let sizes = [Some(radius), hole].into_iter().flatten().map(|half| size_of(model, half, Amount::set));
    let volume = extent.times() * blank.volume(extent.geometry());
    let (unit, times) = if extent == Extent::PerDepth { (Unit::Mm2, "times the depth") } else { (Unit::Mm3, "") };
    let theory = match blank.theory {
        Theory::Bending => format!("bending, {} points through the thickness", blank.layers),
        Theory::Membrane => "membrane".into(),
    };
    let mut lines = vec![
        line("geometry", format!("{geometry}; {}", extent.described()), ""),
        line("blank", joined(sizes, ", hole "), meaning),
        number("thickness", Amount::size(blank.thickness), ""),
        number("volume", Amount::new(volume, unit, Digits::Significant(3)), times),
        line("theory", theory, ""),
    ];
    lines.extend(blank.zones.iter().map(|zone| {
        let [from, to] = zone.within.map(Amount::set);
        let metal = zone.material.as_ref().map_or(String::new(), |metal| metal.hardening.to_string());
        line("zone", format!("{from} to {to}, {} thick", Amount::size(zone.thickness)), metal)
    }));
    lines.extend(model.heat.as_ref().map(|heat| {
        let ends = [heat.initial.smallest(), heat.initial.largest()];
        let [low, high] = ends.map(|kelvin| Amount::temperature(kelvin - ZERO_CELSIUS));
        let range = if low == high { low.into() } else { format!("{low} to {high}") };
        line("temperature", range, if heat.flow.is_some() { "at first" } else { "throughout" })
    }));
    lines
}

fn details(model: &Model) -> Vec<Line> {
    let (material, settings, blank) = (&model.material, &model.settings, &model.blank);
    let [mode, springs] = match model.mode {
        Mode::Flow => ["flow", "rigid and viscoplastic: no elasticity, no spring-back"],
        Mode::ElastoViscoplastic => ["elasto-viscoplastic", "with elasticity: the sheet springs back"],
        Mode::Elastic => ["elastic", "no yielding"],
    };
    let elasticity = material.elastic.map(|elastic| {
        let young = Amount::new(elastic.young, Unit::MPa, Digits::Significant(3));
        number("Young's modulus", young, format!("Poisson's ratio {}", Amount::number(elastic.poisson)))
    });
    let condition = match (&material.gtn, material.yield_criterion) {
        (Some(gtn), _) => gtn.to_string(),
        (None, YieldCriterion::Hill48(_)) => "Hill 1948".into(),
        (None, YieldCriterion::Hosford(_)) => "Hosford".into(),
    };
    let [rate, times] = match material.rate {
        Some(law) => [law.to_string(), "times the yield stress".into()],
        None => ["none".into(), "the yield stress does not depend on the strain rate".into()],
    };
    let size = Amount::size(blank.length / blank.elements as f64);
    let spread = match blank.grading {
        Grading::Uniform => format!("elements, each {size} wide"),
        Grading::Radii | Grading::Divided { .. } => format!("elements, {size} on average, finer at the tools' radii"),
    };
    let [matrix, norm] = settings.corrector();
    let contact = ["penalty", "augmented Lagrangian"][settings.contact as usize];
    let [largest, first, gap] =
        [settings.max_step, settings.first_step, settings.contact_smoothing].map(Amount::given_share);
    let (tolerance, most) = (Amount::norm(settings.tolerance), settings.max_iterations);
    let stiffness = Amount::new(settings.contact_stiffness, Unit::MPa, Digits::Given(6));
    let steps = format!("of the travel at most, {first} at first; at most {} strain a step", settings.strain_step);
    let lines = [
        Some(line("mode", mode, springs)),
        elasticity.or_else(|| Some(line("elasticity", "none given", "the flow law needs none"))),
        Some(line("yield condition", condition, format!("r̄ = {}", Amount::number(material.yield_criterion.ratio())))),
        Some(line("rate law", rate, times)),
        material.thermal.map(|law| line("softening by heat", law.to_string(), "times the yield stress")),
        Some(line("forming limit", model.forming_limit.as_ref().map_or("none", |curve| curve.name), "")),
        Some(number("mesh", Amount::count(blank.elements as f64), spread)),
        Some(line("corrector", matrix, format!("{norm} norm below {tolerance}, at most {most} iterations a step"))),
        Some(number("steps", largest, steps)),
        Some(line("contact", contact, format!("{stiffness} over the thickness, sets in over {gap} of it"))),
        Some(number("cut-off strain", Amount::norm(settings.cutoff_strain), "of 1 % of the travel: rigid below")),
        Some(number("slip speed", Amount::number(settings.slip_speed), "of the punch's speed: 71 % of full friction")),
    ];
    lines.into_iter().flatten().collect()
}

const DETAILS: [&str; 6] = ["volume", "theory", "material source", "friction source", "elements", "compare"];
const APPENDED: [&str; 5] = ["thickness", "clearance", "draw ratio", "holder pressure", "least pressure"];
const ROWS: usize = 24;
const COLUMNS: usize = 60;

impl Check {
    fn rows(&self, is_full: bool) -> Vec<(&str, String)> {
        let mut rows: Vec<(&str, String)> = Vec::new();
        for Line { label, value, meaning, .. } in &self.lines {
            let text = joined([value.clone(), meaning.clone()], " ");
            let appended = rows.last().map(|(_, row)| format!("{row}, {label} {value}"));
            let appended = appended.filter(|row| APPENDED.contains(&label.as_str()) && row.chars().count() <= COLUMNS);
            match (rows.last_mut(), appended) {
                _ if is_full => rows.push((label, text)),
                (Some((_, row)), Some(appended)) => *row = appended,
                _ if DETAILS.contains(&label.as_str()) => {}
                _ => rows.push((label, shortened(&text, COLUMNS))),
            }
        }
        rows
    }

    fn notes(&self, is_full: bool, rows: usize) -> Vec<String> {
        let headings = if self.warnings.is_empty() { 6 } else { 8 };
        let room = ROWS.saturating_sub(rows + headings + 2 * self.warnings.len()).max(1);
        let room = if self.notes.len() > room { (room - 1).max(1) } else { room };
        let left = self.notes.len().saturating_sub(room);
        if is_full {
            return self.notes.clone();
        }
        let notes = self.notes.iter().take(room).map(|n| shortened(n.trim_start_matches("declared: "), COLUMNS + 14));
        notes.chain((left > 0).then(|| format!("{left} more: --verbose prints all"))).collect()
    }
}

fn shortened(text: &str, most: usize) -> String {
    let Some((end, _)) = text.char_indices().nth(most - 1) else { return text.to_owned() };
    format!("{} …", text[..end].rfind(' ').map_or(&text[..end], |end| &text[..end]).trim_end_matches([',', ';', ':']))
}

/// Brief text of one screen; with `{:#}` everything.
impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}\n", self.title)?;
        let rows = self.rows(f.alternate());
        let width = rows.iter().map(|(label, _)| label.chars().count()).max().unwrap_or(0);
        rows.iter().try_for_each(|(label, text)| writeln!(f, "  {label:<width$}  {text}"))?;
        for (heading, entries) in [("assumed", &self.notes(f.alternate(), rows.len())), ("warnings", &self.warnings)] {
            if !entries.is_empty() {
                writeln!(f, "\n{heading}")?;
            }
            entries.iter().try_for_each(|entry| writeln!(f, "  - {entry}"))?;
        }
        Ok(())
    }
}

/// Label, value and meaning.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Line {
    /// Name of the value.
    pub label: String,
    /// Number with its unit, or word.
    pub value: String,
    /// Meaning or origin; may be empty.
    pub meaning: String,
    /// Value in its unit; `None` for words.
    pub number: Option<f64>,
    /// Unit of the number; else empty.
    pub unit: &'static str,
}

fn line(label: impl Into<String>, value: impl Into<String>, meaning: impl Into<String>) -> Line {
    Line { label: label.into(), value: value.into(), meaning: meaning.into(), number: None, unit: "" }
}

fn number(label: &str, amount: Amount, meaning: impl Into<String>) -> Line {
    Line { number: Some(amount.value), unit: amount.unit.spelled(), ..line(label, amount, meaning) }
}

/// Distance from the axis or symmetry plane \[mm\] as shops give it: for round parts the diameter.
fn size_of(model: &Model, half: f64, amount: fn(f64) -> Amount) -> String {
    let is_round = model.geometry == Geometry::Axisymmetric;
    if is_round { format!("Ø {}", amount(2.0 * half)) } else { amount(half).to_string() }
}
