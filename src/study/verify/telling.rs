//! A verification as it is told with the answer that it is of: bars on the numbers, lights that they move, sentences.

use super::bar::Bar;
use super::direction::Direction;
use super::lights::moved;
use super::numbers::{Number, Of};
use super::verification::Verification;
use crate::assess::{self, Answer, Finding};
use crate::case::Solution;
use crate::units::{Amount, Digits, joined};
use crate::units::{ErrorBar, Quantity, rounded};
use serde::Serialize;

/// Two numbers of one unit nearer to each other than that, over their size, are one and the same \[–\]: round-off of a
/// change to percent and back.
const SAME: f64 = 1e-12;

/// The answer to a solved case and what is found on it, with error bars where it was verified: the one way in which both
/// come to whoever tells them.
pub fn answered(solution: &Solution, verification: Option<&Verification>) -> (Answer, Vec<Finding>) {
    let Solution { case, stages, .. } = solution;
    let mut findings = assess::after(case, stages);
    if let Some(verification) = verification {
        findings = verification.weigh(findings);
    }
    let mut answer = Answer::of(case, stages, &findings);
    if let Some(verification) = verification {
        answer.numbers = answer.numbers.into_iter().map(|number| verification.barred(number)).collect();
    }
    (answer, findings)
}

/// Error bars of all numbers, for files.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Told {
    /// Source of the bars.
    pub method: String,
    /// Runs beside the one as it is.
    pub runs: usize,
    /// See [`Verification::sentences`].
    pub told: Vec<String>,
    /// Numbers of the part and the press; the verdict has its own.
    pub numbers: Vec<ToldNumber>,
}

/// A number with its bar, for programs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ToldNumber {
    /// Name: `thinnest`.
    pub key: &'static str,
    /// In `unit`.
    pub value: f64,
    /// How far it can be trusted.
    #[serde(flatten)]
    pub bar: ErrorBar,
    /// Unit as at the end of a header.
    pub unit: &'static str,
    /// Number and bar, with its unit, for people.
    pub told: String,
    /// Contributions to the bar.
    pub made_of: String,
}

impl From<&Bar> for ToldNumber {
    fn from(bar: &Bar) -> Self {
        let Number { key, amount, .. } = bar.number;
        let (value, unit) = (rounded(amount.value), amount.unit.spelled());
        Self { key, value, bar: bar.told(), unit, told: bar.amount().into(), made_of: bar.made_of() }
    }
}

impl From<&Verification> for Told {
    fn from(verification: &Verification) -> Self {
        let runs = verification.outcomes.len() - 1;
        let numbers = verification.bars.iter().filter(|bar| bar.number.of != Of::Verdict).map(ToldNumber::from);
        Self { method: verification.method(), runs, told: verification.sentences(), numbers: numbers.collect() }
    }
}

impl Verification {
    /// Findings with their bars: a light is green only where the whole bar is.
    pub fn weigh(&self, findings: Vec<Finding>) -> Vec<Finding> {
        let moved = moved(&findings, self);
        let weighed = findings.into_iter().map(|finding| {
            let mut finding = self.told(finding);
            if let Some(moved) = moved.iter().find(|moved| moved.key == finding.key) {
                finding.text = format!("{}: {}", moved.clause, finding.text);
                if finding.light < moved.light {
                    finding.advice = moved.advice();
                }
                finding.light = finding.light.max(moved.light);
            }
            finding
        });
        weighed.collect()
    }

    /// A finding whose number is told with its bar, and every other with no digit beyond its own.
    fn told(&self, finding: Finding) -> Finding {
        let error = match self.bar(Of::Verdict, finding.key) {
            Some(bar) => bar.told(),
            None => ErrorBar::Missing("not estimated: it judges the solution, not the part".into()),
        };
        Finding { quantity: finding.quantity.map(|number| number.with_error(error)), ..finding }
    }

    /// A number of the answer with its bar, and what is said about it with no digit beyond its own.
    fn barred(&self, number: Quantity) -> Quantity {
        let bar = match self.bar(Of::Answer, number.key) {
            Some(bar) => bar.told(),
            None => ErrorBar::Missing("given, not computed".into()),
        };
        number.with_error(bar)
    }

    /// Half the bar of the number that an amount tells, in its unit.
    pub fn half(&self, amount: Amount) -> Option<f64> {
        let is_computed = matches!(amount.digits, Digits::Decimals(_) | Digits::Significant(_));
        let own = |bar: &&Bar| is_same(bar.number.amount, amount) && bar.moves().is_some();
        self.bars.iter().filter(|_| is_computed && amount.value != 0.0).find(own)?.moves()
    }

    /// Source of the bars in a few words.
    pub fn method(&self) -> String {
        let runs = self.outcomes.len() - 1;
        match self.outcomes.iter().any(|run| run.direction == Some(Direction::Together)) {
            _ if runs == 0 => "no error bars".into(),
            true => "error bars estimated from one coarser run".into(),
            false => format!("error bars from {runs} finer runs"),
        }
    }

    /// What is told below the answer's numbers: what their bars are from and say, which of them have none and why, and
    /// whatever is no small error.
    pub fn sentences(&self) -> Vec<String> {
        let mut why_none: Vec<(&str, Vec<String>)> = Vec::new();
        let answers = || self.bars.iter().filter(|bar| bar.number.of == Of::Answer);
        for bar in answers().filter(|bar| bar.half.is_none()) {
            match why_none.iter_mut().find(|(why, _)| *why == bar.why) {
                Some((_, labels)) => labels.push(bar.number.label.into()),
                None => why_none.push((&bar.why, vec![bar.number.label.into()])),
            }
        }
        if answers().all(|bar| bar.half.is_none()) && why_none.len() <= 1 {
            // A run without a step has no numbers either.
            let why = why_none.first().map_or(self.outcomes[0].end.why.as_str(), |(why, _)| why);
            let none = format!("no error bars: {why}");
            return [none].into_iter().chain(self.told.iter().filter(|told| told.as_str() != why).cloned()).collect();
        }
        let method = format!(
            "{method}: what mesh, steps and contact leave open; laws and friction are no part of them",
            method = self.method()
        );
        let without = why_none
            .into_iter()
            .map(|(why, labels)| format!("{labels}: no error bar, {why}", labels = joined(labels, ", ")));
        [method].into_iter().chain(without).chain(self.told.iter().cloned()).collect()
    }
}

fn is_same(one: Amount, other: Amount) -> bool {
    one.unit == other.unit && (one.value - other.value).abs() <= SAME * one.value.abs()
}
