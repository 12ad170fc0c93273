//! Summary of a stage: one list of lines, printed as text and written as JSON.

mod case;
mod part;
mod solver;
mod text;

pub use case::CaseSummary;

use super::StageView;
use crate::assess::{Kind, sentences};
use crate::case::files::sha256;
use crate::measure::{events, moment_error};
use crate::model::{Extent, Geometry, Mode};
use crate::plot::stop_text as ended;
use crate::solver::solution::{StageSolution, StepRecord, Stop};
use crate::units::{Amount, joined};
use serde::Serialize;

/// Subject of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// The case that was solved.
    Case,
    /// The end of the stage.
    End,
    /// The part, and the load that formed it.
    Part,
    /// The numerical solution.
    Solution,
    /// Warnings.
    Warnings,
}

#[derive(Clone, Debug)]
struct Line {
    group: Group,
    key: &'static str,
    /// Indented where the line belongs to the one above; empty in lines for programs only.
    label: String,
    value: Value,
}

#[derive(Clone, Debug)]
enum Value {
    Number(Amount),
    Count(usize),
    Flag(bool),
    Text(String),
    List(Vec<String>),
    /// Rows with labels, and their JSON.
    Rows(Vec<[String; 2]>, serde_json::Value),
}

/// Lines in the order of printing; displays as aligned text, serialises with units in the keys.
#[derive(Clone, Debug)]
pub struct Summary {
    lines: Vec<Line>,
    /// Group of the lines to come.
    group: Group,
}

impl Summary {
    /// Sums up a stage.
    pub fn of(view: &StageView) -> Self {
        let (model, run) = (view.model(), view.stage);
        let last = run.steps.last().copied().unwrap_or_else(|| as_begun(run));
        let largest = |value| largest(run, value);

        let mut summary = Self { lines: Vec::new(), group: Group::Case };
        summary.text("case", "Case", view.name.clone());
        summary.text("title", "Title", view.model().title.clone());
        summary.text("section", "Section", section_of(model.extent()));
        summary.group = Group::Part;
        summary.text("hardening", "Hardening", model.material.describe());
        summary.group = Group::End;
        let is_full = run.stop == Stop::FullTravel;
        let ended = if is_full { format!("{} reached", ended(run)) } else { run.stop.to_string() };
        summary.text("stop", "Ended", ended);
        summary.group = Group::Part;
        summary.push("complete", "", Value::Flag(run.stop.is_complete()));
        summary.load(model, run, &last);
        summary.push("events", "Events", Value::events(&events(run), model.extent().force_unit()));
        summary.part(model, run, &last);
        if let Some(opening) = view.ring_opening() {
            summary.number("ring_opening", "Opening of a slit ring", Amount::place(opening));
        }
        if let Some(assessment) = view.forming_limit() {
            summary.forming_limit(model, assessment);
        }
        if run.paths.stride() > 1 {
            let kept = format!("kept of every {n}th step and of the last", n = run.paths.stride());
            summary.text("strain_paths", "Strain paths", kept);
        }
        summary.number("draw_in", "Draw-in of the edge", Amount::place(last.draw_in));
        summary.balance(model, run, &last);
        let bent = run.frames.last().filter(|_| model.mode != Mode::Flow && model.release.is_none());
        if let Some(error) = bent.and_then(moment_error) {
            summary.group = Group::Solution;
            let label = "Bending moment missed by the layers, estimated";
            summary.number("moment_error", label, Amount::share(error.share));
        }
        summary.group = Group::Part;
        summary.condition(model, run, &last);
        summary.group = Group::Solution;
        let deepest = Amount::share(largest(|s| s.penetration));
        summary.number("penetration", "Tools in the sheet, of its thickness", deepest);
        summary.group = Group::Part;
        let ironing = largest(|s| s.ironing);
        if ironing > 0.0 {
            let unit = model.extent().force_unit();
            let force = |value| Amount::force(largest(value), unit);
            summary.number("ironing", "Ironing: reduction of the thickness", Amount::share(ironing));
            summary.number("ironing_force", "Largest ironing force of the die", force(|s| s.ironing_force));
            summary.number("ironing_friction", "Largest friction in it", force(|s| s.ironing_friction));
            let pressure = Amount::stress(largest(|s| s.ironing_pressure));
            summary.number("ironing_pressure", "Largest ironing pressure", pressure);
        }
        summary.number("sharpest_bend", "Smallest bending radius", Amount::thicknesses(bend_radius(run)));
        summary.holder(model, run);
        summary.group = Group::Solution;
        summary.solver(model, run, &last);
        if let Some(wall) = view.wall {
            summary.number("wall_time", "Wall time", Amount::time(wall.as_secs_f64()));
        }
        summary.text("program", "", concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION")).to_owned());
        summary.text("case_sha256", "", sha256([view.case_text]));
        summary.group = Group::Case;
        summary.list("overrides", "Set on the command line", view.overrides.to_vec());
        summary.list("derived", "Assumed while reading", sentences(&view.findings, Kind::Assumption));
        summary.group = Group::Warnings;
        summary.list("warnings", "Warnings", sentences(&view.findings, Kind::Warning));
        summary.group = Group::Case;
        summary.list("notes", "Declared assumptions", view.model().notes.clone());
        for line in &mut summary.lines {
            if let Value::Number(amount) = &mut line.value {
                let bar = view.half(*amount);
                *amount = bar.map_or(*amount, |bar| amount.with_bar(bar));
            }
        }
        summary
    }

    fn push(&mut self, key: &'static str, label: &str, value: Value) {
        self.lines.push(Line { group: self.group, key, label: label.to_owned(), value });
    }

    fn number(&mut self, key: &'static str, label: &str, value: Amount) {
        self.push(key, label, Value::Number(value));
    }

    fn count(&mut self, key: &'static str, label: &str, value: usize) {
        self.push(key, label, Value::Count(value));
    }

    fn text(&mut self, key: &'static str, label: &str, value: impl Into<String>) {
        self.push(key, label, Value::Text(value.into()));
    }

    fn list(&mut self, key: &'static str, label: &str, values: Vec<String>) {
        self.push(key, label, Value::List(values));
    }
}

/// Record of a stage without a step: the sheet at its start, or the blank.
fn as_begun(run: &StageSolution) -> StepRecord {
    let blank = &run.model.blank;
    let (elements, nodes) =
        run.start.as_ref().map_or((&[][..], &[][..]), |start| (&start.elements[..], &start.nodes[..]));
    let thinnest = elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness));
    StepRecord {
        thinnest: thinnest.map_or(blank.thickness, |element| element.thickness),
        thinnest_s0: thinnest.map_or(0.0, |element| element.s0),
        draw_in: nodes.last().map_or(0.0, |node| blank.length - node.r),
        pole_height: nodes.first().map_or(0.0, |node| node.z),
        ..StepRecord::default()
    }
}

/// Largest value over the steps, or 0.
fn largest(run: &StageSolution, value: fn(&StepRecord) -> f64) -> f64 {
    run.steps.iter().map(value).fold(0.0, f64::max)
}

/// Smallest bending radius of the run over the thickness \[–\]; 0 when the sheet stayed flat.
fn bend_radius(run: &StageSolution) -> f64 {
    let sharpest = largest(run, |s| s.sharpest_bend);
    if sharpest > 0.0 { 1.0 / sharpest } else { 0.0 }
}

/// Text of `summary.json`.
pub(super) fn json(view: &StageView) -> Option<String> {
    #[derive(Serialize)]
    struct Written<'a> {
        #[serde(flatten)]
        summary: Summary,
        /// Verdict on the whole case.
        #[serde(skip_serializing_if = "Option::is_none")]
        verdict: Option<&'a serde_json::Value>,
    }
    let written = Written { summary: Summary::of(view), verdict: view.verdict.as_ref() };
    serde_json::to_string_pretty(&written).ok().map(|text| text + "\n")
}

/// Geometry, and the extent that forces refer to.
pub fn section_of(extent: Extent) -> String {
    let section = match extent.geometry() {
        Geometry::Axisymmetric => "axisymmetric",
        Geometry::PlaneStrain => "plane strain",
    };
    joined([section.into(), extent.described()], "; ")
}
