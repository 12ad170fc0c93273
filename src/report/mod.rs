//! A solved case on a few pages for people: one [`Document`] of sections, written as HTML or as Markdown, and the same
//! numbers as JSON.
//!
//! Each file of this folder makes one part. The document holds nothing of the clock but the wall time of the solution, so
//! two reports of one case can be compared.

mod document;
mod html;
mod inputs;
mod markdown;
mod results;
mod sketch;
mod solver;
mod title;
mod verdict;

pub use document::{Block, Document, Picture, Row, Section};
pub use html::html;
pub use markdown::{figure_folder, is_figure, markdown};

use crate::assess::check::{self, Check};
use crate::assess::verdict::{Finding, judge};
use crate::case::Case;
use crate::output::{Dimension, Subject, Summary, stage_folder};
use crate::solution::StageSolution;
use crate::units::rounded;
use serde_json::{Value, json};
use std::time::Duration;

/// What a file that is one of our reports contains.
pub const MARKER: &str = concat!(env!("CARGO_PKG_NAME"), " report, version");
/// Program and version.
const PROGRAM: &str = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));

/// A solved case with all that is said of it.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    case: &'a Case,
    overrides: &'a [String],
    passes: &'a [StageSolution],
    wall: Duration,
    check: Check,
    dimensions: Vec<Dimension>,
    findings: Vec<Finding>,
}

impl<'a> Report<'a> {
    /// Looks a run over: `passes` are the stages that were run, `wall` the time that took.
    pub fn of(case: &'a Case, overrides: &'a [String], passes: &'a [StageSolution], wall: Duration) -> Self {
        Self {
            case,
            overrides,
            passes,
            wall,
            check: check::report(case),
            dimensions: sketch::dimensions(case.model()),
            findings: judge(case, passes),
        }
    }

    /// All sections.
    pub fn document(&self) -> Document {
        let mut sections = vec![
            title::section(self),
            verdict::section(&self.findings),
            sketch::section(self.case.model(), &self.dimensions),
            inputs::section(&self.check),
        ];
        sections.extend(results::sections(self));
        sections.extend([inputs::assumptions(&self.check), solver::warnings(self), solver::section(self)]);
        Document { title: self.case.model().title.clone(), sections }
    }

    /// Every number of the document, with those behind its pictures that a summary has.
    pub fn json(&self) -> Value {
        let dimension = |d: &Dimension| json!({"label": d.label, "value": rounded(d.value), "unit": d.unit.symbol()});
        let stages = self.subjects().map(|subject| json!(Summary::of(&subject)));
        json!({
            "case": self.case.name,
            "complete": self.is_complete(),
            "program": PROGRAM,
            "check": self.check,
            "dimensions": self.dimensions.iter().map(dimension).collect::<Vec<_>>(),
            "verdict": self.findings,
            "stages": stages.collect::<Vec<_>>(),
        })
    }

    /// Whether every stage came to its end.
    pub fn is_complete(&self) -> bool {
        self.case.is_completed_by(self.passes)
    }

    /// What outputs are made from, stage by stage.
    fn subjects(&self) -> impl Iterator<Item = Subject<'_>> {
        self.passes.iter().map(|pass| Subject {
            name: &self.case.name,
            case_text: &self.case.text,
            overrides: self.overrides,
            derived: &self.case.derived,
            model: &pass.model,
            run: &pass,
            wall: self.wall,
        })
    }

    /// `1-draw: ` before the headings of a stage; nothing where there is one only.
    fn stage(&self, i: usize) -> String {
        match self.case.stage_names().nth(i) {
            Some(name) if !self.case.later().is_empty() => format!("{}: ", stage_folder(i, name)),
            _ => String::new(),
        }
    }
}
