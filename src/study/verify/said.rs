//! Sentences on runs of a verification.

use super::direction::Direction;
use super::numbers::Number;
use super::outcome::Outcome;
use crate::solver::state::nonlocal_average::NEIGHBOURHOOD;
use crate::units::{Amount, joined};

/// Shortest elements, over the thickness, that a shell resolves \[–\]: its normal stays straight, which stress needs about a
/// thickness for (Saint-Venant).
const SHELL_LENGTH: f64 = 1.0;

pub(super) fn not_everywhere(direction: Direction) -> String {
    format!("not found in every run ({direction})", direction = direction.label())
}

pub(super) fn jumps(number: &Number, [from, to]: [f64; 2], finer: String) -> String {
    let at = |value: f64| {
        let mut amount = number.amount;
        amount.value = value;
        amount
    };
    format!("jumps from {from} to {to} with {finer}", from = at(from), to = at(to))
}

pub(super) fn ends_differ() -> String {
    "other runs end otherwise".into()
}

pub(super) fn unmoved() -> String {
    "no refinement moves it".into()
}

pub(super) fn interrupted() -> String {
    "interrupted by the user".into()
}

pub(super) fn no_finer(direction: Direction) -> String {
    format!("no run with finer {direction} came to its end", direction = direction.label())
}

pub(super) fn lost(outcome: &Outcome) -> Option<String> {
    let direction = outcome.direction?;
    Some(format!(
        "with {finer} the run does not count: {why}",
        finer = direction.told(outcome.times),
        why = outcome.end.why
    ))
}

pub(super) fn ended_otherwise(base: &Outcome, outcome: &Outcome) -> Option<String> {
    let direction = outcome.direction?;
    Some(format!(
        "with {finer} the run ends otherwise: {why}; as it is: {own}",
        finer = direction.told(outcome.times),
        why = outcome.end.why,
        own = base.end.why
    ))
}

pub(super) fn left_out((direction, times): (Direction, f64), seconds: f64) -> String {
    format!(
        "left out, for it would take some {time}: {finer}",
        time = Amount::time(seconds),
        finer = direction.told(times)
    )
}

pub(super) fn below_shell_length(base: &Outcome, outcomes: &[Outcome]) -> Option<String> {
    let is_short = |outcome: &&Outcome| outcome.shortest < SHELL_LENGTH;
    outcomes.iter().find(|outcome| outcome.times > 1.0 && is_short(outcome))?;
    let shortest = outcomes.iter().filter(is_short).map(|outcome| outcome.shortest).reduce(f64::min)?;
    let from = if is_short(&base) { "as it is".into() } else { String::new() };
    let levels = outcomes.iter().filter(is_short).filter(|o| o.direction == Some(Direction::Elements));
    let levels = levels.map(|outcome| Direction::Elements.told(outcome.times));
    Some(format!(
        "elements are shorter than the sheet is thick, down to {shortest}: {levels}. A shell resolves nothing shorter, and the \
         solver gives each the mean section of {length}",
        shortest = Amount::thicknesses(shortest),
        levels = joined([from].into_iter().chain(levels), ", "),
        length = Amount::given_thicknesses(NEIGHBOURHOOD)
    ))
}
