//! The lights that an error bar moves: a light is green only where the whole bar is.

use super::numbers::Of;
use super::verification::Verification;
use crate::assess::{Finding, Light, judgements};
use crate::units::{Digits, Limits, Sense};

/// A light that a bar reaches beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// Row of the verdict.
    pub key: &'static str,
    /// Light with the error bar.
    pub light: Light,
    /// How, in a few words.
    pub clause: String,
    /// In a sentence.
    pub sentence: String,
}

impl Moved {
    /// To amber, of a row with its number, or words.
    fn told(finding: &Finding, number: String, clause: String) -> Self {
        let sentence = format!("{label}: {number}, {clause}", label = finding.label);
        Self { key: finding.key, light: Light::Amber, clause, sentence }
    }

    /// Advice for a row that is amber by its error bar alone.
    pub(super) fn advice(&self) -> String {
        match self.key {
            RUN => "take the worse end as the true one, or refine until all runs end alike",
            _ => "more margin, or a smaller error bar: `stampflow verify` says what it is made of",
        }
        .into()
    }
}

/// The row of the verdict that says how the run ended.
const RUN: &str = "stop";

/// The rows of the verdict whose bar reaches beyond their light: green becomes amber, amber stays and says that it may be
/// red.
pub fn moved(findings: &[Finding], verification: &Verification) -> Vec<Moved> {
    let of_row = |finding: &Finding| {
        let bar = verification.bar(Of::Verdict, finding.key)?.half?;
        let (number, limits) = (finding.quantity.as_ref()?.amount, finding.limits()?);
        let value = number.value;
        let (reached, limit) = reached(value, bar, &limits)?;
        let limit = number.of(limit).to(Digits::Given(3));
        let clause = match reached {
            Light::Red => format!("with its error bar it reaches red at {limit}"),
            _ => format!("with its error bar it reaches the limit of {limit}"),
        };
        let number = number.with_bar(bar);
        (reached > finding.light).then(|| Moved::told(finding, number.into(), clause))
    };
    let run = judgements(findings).find(|finding| finding.key == RUN && finding.light == Light::Green);
    let run = run.and_then(|finding| {
        let other = verification.finer_that_ends_otherwise()?;
        let direction = other.direction?.told(other.times);
        let clause = format!("with {direction} it ends otherwise");
        Some(Moved::told(finding, finding.found(), clause))
    });
    let rows = judgements(findings).filter(|finding| finding.light != Light::Grey).filter_map(of_row);
    run.into_iter().chain(rows).collect()
}

/// The worst light that a bar reaches, and where that begins.
fn reached(value: f64, bar: f64, limits: &Limits) -> Option<(Light, f64)> {
    let is_beyond = |limit: f64| match limits.sense {
        Sense::AtMost => value + bar > limit,
        Sense::AtLeast => value - bar < limit,
    };
    let of = |limit: Option<f64>, light: Light| limit.filter(|limit| is_beyond(*limit)).map(|limit| (light, limit));
    of(limits.red, Light::Red).or(of(limits.amber, Light::Amber))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand.
    #[test]
    fn a_bar_reaches_the_worst_light_that_it_touches() {
        let at_most = Limits { sense: Sense::AtMost, amber: Some(90.0), red: Some(100.0) };
        let at_least = Limits { sense: Sense::AtLeast, amber: Some(8.0), red: None };
        for (value, bar, limits, expected) in [
            (85.0, 4.0, at_most, None),
            (85.0, 6.0, at_most, Some((Light::Amber, 90.0))),
            (85.0, 16.0, at_most, Some((Light::Red, 100.0))),
            (10.0, 1.0, at_least, None),
            (10.0, 3.0, at_least, Some((Light::Amber, 8.0))),
        ] {
            assert_eq!(reached(value, bar, &limits), expected, "{value} ± {bar}");
        }
    }
}
