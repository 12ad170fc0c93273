//! Verdict with error bars: bars on its numbers, lights that they move, sentences on their origin.

use super::{Direction, Number, Origin, Verification};
use crate::assess::{self, Answer, Finding, Kind, Light};
use crate::case::Solution;
use crate::units::{Amount, Digits, ErrorBar, Limits, Quantity, Sense, joined};
use serde::ser::{Serialize, SerializeStruct, Serializer};

/// Relative difference below which two numbers are one: round-off of a change to percent and back \[–\].
const SAME: f64 = 1e-12;

/// Row of the verdict on the end of the run.
const RUN: &str = "stop";

/// Answer to a solved case with its findings; with error bars if it was verified.
pub fn answered(solution: &Solution, verification: Option<&Verification>) -> (Answer, Vec<Finding>) {
    let Solution { case, stages, .. } = solution;
    let mut findings = assess::after(case, stages);
    if let Some(verification) = verification {
        findings = verification.weigh(findings);
    }
    let mut answer = Answer::of(case, stages, &findings);
    if let Some(verification) = verification {
        let error = |key| verification.error(Origin::Answer, key, "given, not computed");
        let barred = |number: Quantity| {
            let error = error(number.key);
            number.with_error(error)
        };
        answer.numbers = answer.numbers.into_iter().map(barred).collect();
    }
    (answer, findings)
}

impl Verification {
    /// Findings with their bars: a light is green only if the whole bar is.
    pub fn weigh(&self, findings: Vec<Finding>) -> Vec<Finding> {
        let weighed = findings.into_iter().map(|finding| {
            let clause = self.clause(&finding);
            let error = self.error(Origin::Verdict, finding.key, "not estimated: it judges the solution, not the part");
            let mut finding = Finding { quantity: finding.quantity.map(|number| number.with_error(error)), ..finding };
            if let Some(clause) = clause {
                finding.text = format!("{clause}: {}", finding.text);
                if finding.light < Light::Amber {
                    let refine = "take the worse end as the true one, or refine until all runs end alike";
                    let margin = "more margin, or a smaller error bar: `stampflow verify` says what it is made of";
                    finding.advice = if finding.key == RUN { refine } else { margin }.to_owned();
                }
                finding.light = finding.light.max(Light::Amber);
            }
            finding
        });
        weighed.collect()
    }

    /// Sentences on lights that a bar moves.
    pub fn moved(&self, findings: &[Finding]) -> Vec<String> {
        let moved = findings.iter().filter_map(|finding| {
            let clause = self.clause(finding)?;
            let bar = self.number(Origin::Verdict, finding.key).and_then(Number::half);
            let number =
                finding.quantity.as_ref().zip(bar).map(|(number, bar)| number.amount.with_bar(bar).to_string());
            Some(format!("{}: {}, {clause}", finding.label, number.unwrap_or_else(|| finding.found())))
        });
        moved.collect()
    }

    /// Clause on a row of the verdict whose bar reaches a worse light.
    fn clause(&self, finding: &Finding) -> Option<String> {
        if finding.kind != Kind::Judgement || finding.light == Light::Grey {
            return None;
        }
        if finding.key == RUN {
            let other = self.finer_that_ends_otherwise().filter(|_| finding.light == Light::Green)?;
            return Some(format!("with {} it ends otherwise", other.direction?.text(other.times)));
        }
        let bar = self.number(Origin::Verdict, finding.key)?.half()?;
        let amount = finding.quantity.as_ref()?.amount;
        let (reached, limit) = reached(amount.value, bar, &finding.limits()?)?;
        let limit = amount.of(limit).to(Digits::Given(3));
        let at = if reached == Light::Red { "red at" } else { "the limit of" };
        (reached > finding.light).then(|| format!("with its error bar it reaches {at} {limit}"))
    }

    /// Error bar of a number, or the reason why a number that is not listed has none.
    fn error(&self, origin: Origin, key: &str, why_none: &str) -> ErrorBar {
        let known = self.number(origin, key).map(|number| number.quantity.error.clone());
        known.unwrap_or_else(|| ErrorBar::Missing(why_none.to_owned()))
    }

    /// Half the error bar of the computed number that an amount is, in its unit.
    pub fn half(&self, amount: Amount) -> Option<f64> {
        let is_computed = matches!(amount.digits, Digits::Decimals(_) | Digits::Significant(_));
        let is_same = |own: &Amount| {
            own.unit == amount.unit && (own.value - amount.value).abs() <= SAME * own.value.abs() && own.bar().is_some()
        };
        let numbers = self.numbers.iter().filter(|_| is_computed && amount.value != 0.0);
        numbers.map(|number| number.quantity.amount).find(is_same)?.bar()
    }

    /// Origin of the bars in a few words.
    pub fn method(&self) -> String {
        let runs = self.outcomes.len() - 1;
        match self.outcomes.iter().any(|run| run.direction == Some(Direction::Together)) {
            _ if runs == 0 => "no error bars".into(),
            true => "error bars estimated from one coarser run".into(),
            false => format!("error bars from {runs} finer runs"),
        }
    }

    /// Sentences below the answer's numbers: origin of the bars, numbers without one and why, and all notes.
    pub fn sentences(&self) -> Vec<String> {
        let mut without: Vec<(&str, Vec<String>)> = Vec::new();
        let mut has_bars = false;
        for number in self.numbers.iter().filter(|number| number.origin == Origin::Answer) {
            let label = number.quantity.label.to_owned();
            match &number.quantity.error {
                ErrorBar::Missing(why) => match without.iter_mut().find(|(known, _)| known == why) {
                    Some((_, labels)) => labels.push(label),
                    None => without.push((why, vec![label])),
                },
                _ => has_bars = true,
            }
        }
        if !has_bars && without.len() <= 1 {
            // A run without a step has no numbers either.
            let why = without.first().map_or(self.outcomes[0].end.why.as_str(), |(why, _)| why);
            let notes = self.notes.iter().filter(|note| note.as_str() != why).cloned();
            return [format!("no error bars: {why}")].into_iter().chain(notes).collect();
        }
        let method = self.method();
        let method =
            format!("{method}: what mesh, steps and contact leave open; laws and friction are no part of them");
        let without = without.into_iter().map(|(why, labels)| format!("{}: no error bar, {why}", joined(labels, ", ")));
        [method].into_iter().chain(without).chain(self.notes.iter().cloned()).collect()
    }
}

/// JSON of the bars: method, number of further runs, sentences, and the numbers of the part and the press.
impl Serialize for Verification {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let numbers: Vec<_> = self.numbers.iter().filter(|number| number.origin != Origin::Verdict).collect();
        let mut value = serializer.serialize_struct("Verification", 4)?;
        value.serialize_field("method", &self.method())?;
        value.serialize_field("runs", &(self.outcomes.len() - 1))?;
        value.serialize_field("told", &self.sentences())?;
        value.serialize_field("numbers", &numbers)?;
        value.end()
    }
}

/// Worst light that a bar reaches, and its limit.
fn reached(value: f64, bar: f64, limits: &Limits) -> Option<(Light, f64)> {
    let is_beyond = |limit: &f64| match limits.sense {
        Sense::AtMost => value + bar > *limit,
        Sense::AtLeast => value - bar < *limit,
    };
    let red = limits.red.filter(is_beyond).map(|limit| (Light::Red, limit));
    red.or(limits.amber.filter(is_beyond).map(|limit| (Light::Amber, limit)))
}
