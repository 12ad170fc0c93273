//! What a report is written from.

use super::answers::Answers;
use super::document::KeyNumber;
use super::program::PROGRAM;
use super::{answers, sizes, title};
use crate::assess::check::{self, Check};
use crate::assess::{self, Finding, Kind};
use crate::case::{Solution, TitleBlock};
use crate::message::Form;
use crate::output::{Dimension, StageView, Summary};
use crate::units::rounded;
use serde_json::{Map, Value, json};

/// A solved case with all that is said of it.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    pub(super) solution: &'a Solution,
    /// Every stage that was run, and its summary.
    pub(super) stages: Vec<(StageView<'a>, Summary)>,
    pub(super) check: Check,
    pub(super) dimensions: Vec<Dimension>,
    pub(super) findings: Vec<Finding>,
    pub(super) answers: Answers,
    pub(super) title_block: TitleBlock,
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
            dimensions: sizes::dimensions(solution.case.model(), None),
            findings: before.into_iter().chain(after).collect(),
            answers: Answers::of(solution),
            title_block: solution.case.title_block.clone(),
        }
    }

    /// With what is given of the title block in place of what the case says.
    pub fn titled(self, given: TitleBlock) -> Self {
        Self { title_block: self.title_block.clone().replaced_by(given), ..self }
    }

    /// Every number of the document, with those behind its pictures that a summary has.
    pub fn json(&self) -> Value {
        let dimension = |d: &Dimension| json!({"label": d.name(), "value": rounded(d.value), "unit": d.unit.symbol()});
        let answer = |n: &KeyNumber| json!({"label": n.label, "value": n.value, "detail": n.detail});
        json!({
            "case": self.solution.case.name,
            "complete": self.solution.is_complete(),
            "program": PROGRAM,
            "title_block": title::block(self).into_iter().map(|[name, value]| (name, value.into())).collect::<Map<_, _>>(),
            "answers": answers::told(&self.answers, Form::default()).iter().map(answer).collect::<Vec<_>>(),
            "check": self.check,
            "dimensions": self.dimensions.iter().map(dimension).collect::<Vec<_>>(),
            "verdict": assess::judgements(&self.findings).collect::<Vec<_>>(),
            "stages": self.stages.iter().map(|(_, summary)| summary).collect::<Vec<_>>(),
        })
    }

    /// `1-draw: ` before the headings of a stage; nothing where there is one only.
    pub(super) fn stage(&self, i: usize) -> String {
        self.solution.case.stage_label(i).map_or_else(String::new, |label| format!("{label}: "))
    }
}
