//! Whether the friction is known or guessed.

use super::{DECLARED, Finding, Light};
use crate::case::Case;
use crate::table::Unit;
use std::ops::RangeInclusive;

/// How a note begins that says of itself that it is an assumption.
const ASSUMED: &str = "declared";
/// Coefficients of lubricated sheet on tools \[–\].
const USUAL: RangeInclusive<f64> = 0.01..=0.3;

/// Amber unless a note of the case says where the friction was measured or read, and the coefficients are sheet metal's.
pub(super) fn judge(case: &Case) -> Option<Finding> {
    let coefficients = || case.model().tools.iter().map(|tool| tool.friction.largest_coefficient());
    let most = coefficients().reduce(f64::max)?;
    let mut naming = case.model().notes.iter().filter(|note| note.contains("friction"));
    let known = naming.clone().any(|note| !note.trim_start().starts_with(ASSUMED) && is_sourced(note));
    let usual = coefficients().all(|mu| USUAL.contains(&mu));
    let said = if !usual {
        "outside what sheet on tools has"
    } else if known {
        "a note says where it comes from"
    } else if naming.next().is_some() {
        "a declared assumption"
    } else {
        "no note says where it comes from"
    };
    let light = if known && usual { Light::Green } else { Light::Amber };
    Some(Finding {
        key: "friction",
        label: "Friction",
        light,
        value: Some(most),
        unit: Unit::None,
        found: format!("{most} at most, {said}"),
        limit: format!("a measured or cited number, {} to {}", USUAL.start(), USUAL.end()),
        source: DECLARED,
        advice: light.advice(
            "run it with 0.02 more and less (--set) to see what hangs on it; write in `notes` where it was measured, or author \
             and year",
        ),
    })
}

/// Whether a note says that its number was measured, or names a year as citations do.
fn is_sourced(note: &str) -> bool {
    let year = |word: &str| matches!(word.parse(), Ok(1900..=2100));
    note.contains("measured") || note.split(|c: char| !c.is_ascii_digit()).any(year)
}
