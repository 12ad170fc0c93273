//! What is told of the runs of a verification: whatever is no small error.

use super::direction::Direction;
use super::numbers::Number;
use super::outcome::Outcome;
use crate::message::{Amount, Message, message};
use crate::solver::state::neighbourhood::NEIGHBOURHOOD;

/// Shortest elements, over the thickness, that a shell resolves \[–\]: its normal stays straight, which stress needs about a
/// thickness for (Saint-Venant).
const SHELL_LENGTH: f64 = 1.0;

/// Of a number that some run of a direction has not.
pub(super) fn not_everywhere(direction: Direction) -> Message {
    message!("not found in every run ({direction})", direction = direction.label())
}

/// Of a number that jumps from one level to the next.
pub(super) fn jumps(number: &Number, [from, to]: [f64; 2], finer: Message) -> Message {
    let at = |value: f64| {
        let mut amount = number.amount;
        amount.value = value;
        amount
    };
    message!("jumps from {from} to {to} with {finer}", from = at(from), to = at(to), finer = finer)
}

/// Of the number where runs end otherwise.
pub(super) fn ends_differ() -> Message {
    "other runs end otherwise".into()
}

/// Of a number that no refinement moves.
pub(super) fn unmoved() -> Message {
    "no refinement moves it".into()
}

/// Of runs that the user ended.
pub(super) fn interrupted() -> Message {
    "interrupted by the user".into()
}

/// Of a direction in which no finer run came to its end.
pub(super) fn no_finer(direction: Direction) -> Message {
    message!("no run with finer {direction} came to its end", direction = direction.label())
}

/// Of a run that the numerics ended.
pub(super) fn lost(outcome: &Outcome) -> Option<Message> {
    let direction = outcome.direction?;
    Some(message!(
        "with {finer} the run does not count: {why}",
        finer = direction.told(outcome.times),
        why = outcome.end.why.clone()
    ))
}

/// Of a run that ended otherwise.
pub(super) fn ended_otherwise(base: &Outcome, outcome: &Outcome) -> Option<Message> {
    let direction = outcome.direction?;
    Some(message!(
        "with {finer} the run ends otherwise: {why}; as it is: {own}",
        finer = direction.told(outcome.times),
        why = outcome.end.why.clone(),
        own = base.end.why.clone()
    ))
}

/// Of a run that would take too long.
pub(super) fn left_out((direction, times): (Direction, f64), seconds: f64) -> Message {
    message!(
        "left out, for it would take some {time}: {finer}",
        time = Amount::time(seconds),
        finer = direction.told(times)
    )
}

/// Of finer runs whose elements are shorter than what a shell resolves, the run as it is among them where it has such.
pub(super) fn below_shell_length(base: &Outcome, outcomes: &[Outcome]) -> Option<Message> {
    let is_short = |outcome: &&Outcome| outcome.shortest < SHELL_LENGTH;
    outcomes.iter().find(|outcome| outcome.times > 1.0 && is_short(outcome))?;
    let shortest = outcomes.iter().filter(is_short).map(|outcome| outcome.shortest).reduce(f64::min)?;
    let from = if is_short(&base) { "as it is".into() } else { Message::default() };
    let levels = outcomes.iter().filter(is_short).filter(|o| o.direction == Some(Direction::Elements));
    let levels = levels.map(|outcome| Direction::Elements.told(outcome.times));
    Some(message!(
        "elements are shorter than the sheet is thick, down to {shortest}: {levels}. A shell resolves nothing shorter, and the \
         solver gives each the mean section of {length}",
        shortest = Amount::thicknesses(shortest),
        levels = Message::joined([from].into_iter().chain(levels), ", "),
        length = Amount::given_thicknesses(NEIGHBOURHOOD)
    ))
}
