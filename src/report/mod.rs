//! Report on a solved case: one HTML page for people, and the same numbers as JSON.
//!
//! Printed it has three pages: the answer; sections, stages, thickness and forming limit; inputs and sources. Details are
//! folded. Of the clock it holds its date and the wall time alone, so that two reports can be compared.

mod front;
mod page;
mod part;
mod results;
mod sections;
mod sizes;

pub use sizes::dimensions;

use crate::assess::check::{self, Check};
use crate::assess::{self, Answer, Finding, Kind, Light, error_bars::ErrorBars, first_clause, judgements, tears_at};
use crate::case::{Solution, TitleBlock};
use crate::model::{Model, Role, Tool, tool_sizes::extent};
use crate::plot::{Captions, Chart, Dimension, StageView, axis::capitalised, dimensioned};
use crate::results::{Summary, summary::Group};
use crate::solver::solution::Frame;
use crate::study::compare::SideBySide;
use crate::units::{Amount, joined, rounded};
use maud::{Markup, html};
use page::{Row, Section, figure, figure_in_column, list, table, word};
use results::plot;
use serde_json::{Map, Value, json};
use time::OffsetDateTime;

/// Given date, or today in UTC: by `SOURCE_DATE_EPOCH` where it is set (<https://reproducible-builds.org>).
pub fn date(given: Option<String>) -> Option<String> {
    let now = || OffsetDateTime::from_unix_timestamp(std::env::var("SOURCE_DATE_EPOCH").ok()?.parse().ok()?).ok();
    let today = || now().unwrap_or_else(OffsetDateTime::now_utc).date().to_string();
    given.or_else(|| Some(today())).filter(|date| date != "none")
}

const PROGRAM: &str = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));

/// Solved case with everything that its report says.
#[derive(Clone, Debug)]
pub struct Report<'a> {
    solution: &'a Solution,
    stages: Vec<(StageView<'a>, Summary)>,
    check: Check,
    dimensions: Vec<Dimension>,
    findings: Vec<Finding>,
    answer: Answer,
    title_block: TitleBlock,
    bars: Option<&'a ErrorBars>,
    versus: Option<&'a SideBySide>,
}

impl<'a> Report<'a> {
    /// Prepares a report on a verdict from [`answered`](assess::error_bars::answered), which may have taken a second solution.
    pub fn answered(solution: &'a Solution, bars: Option<&'a ErrorBars>, verdict: (Answer, Vec<Finding>)) -> Self {
        let (before, (answer, after)) = (assess::before(&solution.case), verdict);
        let assumed: Vec<_> = before.iter().filter(|f| f.kind == Kind::Assumption).cloned().collect();
        let mut views = solution.views_with(&assumed);
        views.iter_mut().for_each(|view| view.bars = bars.map_or_else(Vec::new, ErrorBars::amounts));
        views.iter_mut().for_each(|view| view.pictures.captions = Captions::Own);
        let stages = views.into_iter().map(|view: StageView<'a>| (view.clone(), Summary::of(&view))).collect();
        let (check, dimensions) = (check::report(&solution.case), sizes::dimensions(solution.case.model(), None));
        let findings = before.into_iter().chain(after).collect();
        let title_block = solution.case.title_block.clone();
        Self { solution, stages, check, dimensions, findings, answer, title_block, bars, versus: None }
    }

    /// Replaces the date of the title block.
    pub fn dated(mut self, date: Option<String>) -> Self {
        self.title_block.date = date;
        self
    }

    /// Adds a comparison with other runs and measurements.
    pub fn against(self, versus: &'a SideBySide) -> Self {
        Self { versus: Some(versus), ..self }
    }

    /// Every number of the page, with those of the summaries behind its pictures.
    pub fn json(&self) -> Value {
        let dimension =
            |d: &Dimension| json!({"label": d.name, "value": rounded(d.amount.value), "unit": d.amount.unit.symbol()});
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
            "error_bars": self.bars,
            "check": self.check,
            "draw_ratios": part::ratios(self),
            "dimensions": self.dimensions.iter().map(dimension).collect::<Vec<_>>(),
            "verdict": judgements(&self.findings).collect::<Vec<_>>(),
            "stages": self.stages.iter().map(|(_, summary)| summary).collect::<Vec<_>>(),
        })
    }

    /// `1-draw: ` before the headings of a stage; empty if there is one only.
    fn stage(&self, i: usize) -> String {
        self.solution.case.stage_label(i).map_or_else(String::new, |label| format!("{label}: "))
    }
}
