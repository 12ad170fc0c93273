//! What a report is written from.

use super::program::PROGRAM;
use super::sizes;
use crate::assess::check::{self, Check};
use crate::assess::{self, Answer, Finding, Kind};
use crate::case::{Solution, TitleBlock};
use crate::results::{Dimension, StageView, Summary};
use crate::study::verify::{self, Told, Verification};
use crate::study::versus::Versus;
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
    pub(super) answer: Answer,
    pub(super) title_block: TitleBlock,
    /// How far the numbers can be trusted, where that was looked at.
    pub(super) verification: Option<&'a Verification>,
    /// Other runs beside it, where there are some.
    pub(super) versus: Option<&'a Versus>,
}

impl<'a> Report<'a> {
    /// Looks a solution over, without error bars.
    pub fn of(solution: &'a Solution) -> Self {
        Self::verified(solution, None)
    }

    /// Looks a solution over, with error bars where it was verified.
    pub fn verified(solution: &'a Solution, verification: Option<&'a Verification>) -> Self {
        Self::found(solution, verification, verify::answered(solution, verification))
    }

    /// The same where the verdict has been [given](verify::answered) already: it may have taken a second solution.
    pub fn found(
        solution: &'a Solution,
        verification: Option<&'a Verification>,
        (answer, after): (Answer, Vec<Finding>),
    ) -> Self {
        let before = assess::before(&solution.case);
        let assumed: Vec<_> = before.iter().filter(|f| f.kind == Kind::Assumption).cloned().collect();
        let mut views = solution.views_telling(&assumed);
        StageView::verify(&mut views, &solution.stages, verification);
        let views = views.into_iter().map(StageView::without_captions);
        Self {
            solution,
            stages: views.map(|view| (view.clone(), Summary::of(&view))).collect(),
            check: check::report(&solution.case),
            dimensions: sizes::dimensions(solution.case.model(), None),
            findings: before.into_iter().chain(after).collect(),
            answer,
            title_block: solution.case.title_block.clone(),
            verification,
            versus: None,
        }
    }

    /// With what is given of the title block in place of what the case says.
    pub fn titled(self, given: TitleBlock) -> Self {
        Self { title_block: self.title_block.clone().replaced_by(given), ..self }
    }

    /// With other runs and measurements beside it.
    pub fn against(self, versus: &'a Versus) -> Self {
        Self { versus: Some(versus), ..self }
    }

    /// Every number of the document, with those behind its pictures that a summary has.
    pub fn json(&self) -> Value {
        let dimension = |d: &Dimension| json!({"label": d.name(), "value": rounded(d.amount.value), "unit": d.amount.unit.symbol()});
        let mut answer = json!(self.answer);
        for (value, number) in answer["numbers"].as_array_mut().into_iter().flatten().zip(&self.answer.numbers) {
            value["told"] = number.amount.to_string().into();
        }
        json!({
            "case": self.solution.case.name,
            "complete": self.solution.is_complete(),
            "program": PROGRAM,
            "title_block": self.title_block.entries().map(|(name, value)| (name.to_owned(), value.into())).collect::<Map<_, _>>(),
            "answer": answer,
            "error_bars": self.verification.map(Told::from),
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
