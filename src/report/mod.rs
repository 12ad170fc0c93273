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
use crate::assess::{self, Finding, Kind};
use crate::case::Solution;
use crate::output::{Dimension, StageView, Summary};
use crate::units::rounded;
use serde_json::{Value, json};

/// What a file that is one of our reports contains.
pub const MARKER: &str = concat!(env!("CARGO_PKG_NAME"), " report, version");
/// Program and version.
const PROGRAM: &str = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));

/// A solved case with all that is said of it.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    solution: &'a Solution,
    /// Every stage that was run, and its summary.
    stages: Vec<(StageView<'a>, Summary)>,
    check: Check,
    dimensions: Vec<Dimension>,
    findings: Vec<Finding>,
}

impl<'a> Report<'a> {
    /// Looks a solution over.
    pub fn of(solution: &'a Solution) -> Self {
        let (before, after) = (assess::before(&solution.case), assess::after(&solution.case, &solution.stages));
        let assumed: Vec<_> = before.iter().filter(|f| f.kind == Kind::Assumption).cloned().collect();
        let views = solution.views_telling(&assumed).into_iter().map(StageView::without_captions);
        Self {
            solution,
            stages: views.map(|view| (view.clone(), Summary::of(&view))).collect(),
            check: check::report(&solution.case),
            dimensions: sketch::dimensions(solution.case.model()),
            findings: before.into_iter().chain(after).collect(),
        }
    }

    /// All sections.
    pub fn document(&self) -> Document {
        let model = self.solution.case.model();
        let mut sections = vec![
            title::section(self),
            verdict::section(&self.findings),
            sketch::section(model, &self.dimensions),
            inputs::section(&self.check),
        ];
        sections.extend(results::sections(self));
        sections.extend([inputs::assumptions(&self.check), solver::warnings(self), solver::section(self)]);
        Document { title: model.title.clone(), sections }
    }

    /// Every number of the document, with those behind its pictures that a summary has.
    pub fn json(&self) -> Value {
        let dimension = |d: &Dimension| json!({"label": d.label, "value": rounded(d.value), "unit": d.unit.symbol()});
        json!({
            "case": self.solution.case.name,
            "complete": self.solution.is_complete(),
            "program": PROGRAM,
            "check": self.check,
            "dimensions": self.dimensions.iter().map(dimension).collect::<Vec<_>>(),
            "verdict": assess::judgements(&self.findings).collect::<Vec<_>>(),
            "stages": self.stages.iter().map(|(_, summary)| summary).collect::<Vec<_>>(),
        })
    }

    /// `1-draw: ` before the headings of a stage; nothing where there is one only.
    fn stage(&self, i: usize) -> String {
        self.solution.case.stage_label(i).map_or_else(String::new, |label| format!("{label}: "))
    }
}
