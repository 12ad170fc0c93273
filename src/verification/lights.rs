//! The lights that an error bar moves: a light is green only where the whole bar is.

use super::numbers::Of;
use super::verify::Verification;
use crate::assess::{Finding, Light, Limits, Sense, judgements};
use crate::message::{Amount, Digits, Message, message};

/// A light that a bar reaches beyond.
#[derive(Clone, Debug, PartialEq)]
pub struct Moved {
    /// Of the row of the verdict.
    pub key: &'static str,
    /// What the light is with the bar.
    pub light: Light,
    /// In a sentence.
    pub sentence: Message,
}

/// The rows of the verdict whose bar reaches beyond their light: green becomes amber, amber stays and says that it may be
/// red.
pub fn moved(findings: &[Finding], verification: &Verification) -> Vec<Moved> {
    let of_row = |finding: &Finding| {
        let bar = verification.bar(Of::Verdict, finding.key)?.half?;
        let (value, limits) = (finding.value?, finding.limits?);
        let (reached, limit) = reached(value, bar, &limits)?;
        let told = Amount::new(value, finding.unit, Digits::Significant(3)).with_bar(bar);
        let limit = Amount::new(limit, finding.unit, Digits::Given(3));
        let sentence = match (finding.light, reached) {
            (Light::Green, Light::Amber) => message!(
                "{label}: green by itself, but its error bar, {value}, reaches amber at {limit}",
                label = finding.label,
                value = told,
                limit = limit
            ),
            (Light::Green | Light::Amber, Light::Red) => message!(
                "{label}: its error bar, {value}, reaches red at {limit}",
                label = finding.label,
                value = told,
                limit = limit
            ),
            _ => return None,
        };
        Some(Moved { key: finding.key, light: Light::Amber, sentence })
    };
    judgements(findings).filter(|finding| finding.light != Light::Grey).filter_map(of_row).collect()
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
