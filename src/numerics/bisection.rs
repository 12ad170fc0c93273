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

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: √2 to the last digits, from either side; a bracket is 2^−n of the first.
    #[test]
    fn a_root_is_bracketed_from_either_side() {
        let [low, high] = bisect(1.0, 2.0, 50, |x| x * x < 2.0);
        assert!(low * low < 2.0 && high * high >= 2.0 && high - low <= 2f64.powi(-50));
        let [above, below] = bisect(2.0, 1.0, 10, |x| x * x >= 2.0);
        assert!((above - below - 2f64.powi(-10)).abs() < 1e-15 && below < 2f64.sqrt() && above >= 2f64.sqrt());
    }
}
