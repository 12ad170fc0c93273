//! Pictures of searches.

use crate::plot::Chart;
use crate::study::Span;
use crate::study::search::{Answer, Best, Condition, Named, Quest};

/// Numbers of a search over its key.
pub fn plot(_: &Quest, _: &Answer) -> Option<Chart> {
    None
}

/// Number to be optimised over each key.
pub fn plot_best(_: &[Span], _: &Named, _: Option<&Condition>, _: &Best) -> Option<Chart> {
    None
}
