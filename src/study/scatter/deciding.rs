//! The numbers of a scatter that decide.

use super::found::{Found, Spread};
use crate::assess::Light;
use std::cmp::Ordering;

/// Numbers at most.
const MOST: usize = 4;

/// The row of the verdict that judges what was given, not what came of it.
const GIVEN: &str = "friction";

/// The numbers that decide: those that are red most often, then those nearest to their limits.
pub fn deciding(found: &Found) -> Vec<&Spread> {
    let share = |spread: &Spread, light: Light| {
        let own =
            found.events.iter().find(|event| Some(event.key.as_str()) == spread.number.row && event.light == light);
        own.map_or(0.0, |event| event.chance.value)
    };
    let is_judged =
        |spread: &&Spread| spread.number.limits.is_some() && spread.number.row != Some(GIVEN) && varies(spread);
    let mut judged: Vec<&Spread> = found.numbers.iter().filter(is_judged).collect();
    judged.sort_by(|a, b| {
        let key = |spread| (share(spread, Light::Red), share(spread, Light::Amber), nearness(spread));
        key(b).partial_cmp(&key(a)).unwrap_or(Ordering::Equal)
    });
    judged.truncate(MOST);
    judged
}

fn varies(spread: &Spread) -> bool {
    spread.quantiles().is_some_and(|[low, _, high]| high - low > 1e-9 * high.abs().max(low.abs()))
}

/// Minus the distance of the median from the nearest limit, over the width of the values.
fn nearness(spread: &Spread) -> f64 {
    let Some([low, median, high]) = spread.quantiles() else { return f64::NEG_INFINITY };
    let limits = spread.number.limits.iter().flat_map(|limits| [limits.amber, limits.red]).flatten();
    -limits.map(|limit| (limit - median).abs() / (high - low)).fold(f64::INFINITY, f64::min)
}
