//! Bisection: the bracket of a value at which a condition changes.

/// Halves the bracket from `low`, where `is_below` holds, to `high`, where it does not, `halvings` times; the bracket
/// that is left, in the same order.
///
/// Each halving costs one call; 50 of them use up the digits of a bracket of order one. The order of the ends is free:
/// `low` may be the larger number.
pub fn bisect(low: f64, high: f64, halvings: usize, mut is_below: impl FnMut(f64) -> bool) -> [f64; 2] {
    let (mut low, mut high) = (low, high);
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        if is_below(middle) { low = middle } else { high = middle }
    }
    [low, high]
}
