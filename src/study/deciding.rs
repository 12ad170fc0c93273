//! The numbers that decide: what a designer looks at first, of those that change.

use super::results::{Found, Results};
use crate::study::verify::{Number, Of};

/// In the order in which they are asked for.
const FIRST: [(Of, &str); 12] = [
    (Of::Verdict, "thinning"),
    (Of::Answer, "punch_force"),
    (Of::Answer, "pressure"),
    (Of::Answer, "draw_in"),
    (Of::Verdict, "wrinkling"),
    (Of::Answer, "part_height"),
    (Of::Answer, "holder_force"),
    (Of::Verdict, "forming_limit"),
    (Of::Answer, "ring_opening"),
    (Of::Verdict, "springback"),
    (Of::Part, "thickest"),
    (Of::Verdict, "energy"),
];

/// A number changes where it spans more than this share of its largest.
const LEAST: f64 = 2e-3;

impl Results<'_> {
    /// The places of the numbers that decide and change, as many as are wanted at `most`.
    pub fn deciding(&self, most: usize) -> Vec<usize> {
        let first = FIRST.iter().filter_map(|(of, key)| self.place(*of, key));
        first.filter(|place| self.changes(*place)).take(most).collect()
    }

    /// Whether a number is not the same for all designs that have an answer.
    fn changes(&self, place: usize) -> bool {
        let Some((low, high)) = self.span(place, Found::is_known) else { return false };
        high.abs().max(low.abs()) * LEAST < high - low
    }

    /// The least and the largest of a number among designs that count.
    pub fn span(&self, place: usize, is_counted: impl Fn(&Found) -> bool) -> Option<(f64, f64)> {
        let counted = self.designs().iter().filter(|found| is_counted(found));
        let values = counted.map(|found| found.numbers[place]).filter(|value| value.is_finite());
        let span = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
        (span.0 <= span.1).then_some(span)
    }

    /// A number of the case as it stands.
    pub fn number(&self, place: usize) -> &Number {
        &self.base.outcome.numbers[place]
    }
}
