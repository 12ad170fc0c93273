//! How fast iterations converge.
//!
//! ```text
//! e_k = |δȧ_k|/|ȧ|                   the increment of iteration k stands for the error that it took away
//! e_k+1 = C e_k^p                    p = ln(e_k+1/e_k)/ln(e_k/e_k−1)
//! ```
//!
//! Linear convergence has p = 1 and leaves the same share of the error in each iteration, quadratic has p = 2 and doubles the
//! digits that are right.

/// Velocity norm below which an increment is mostly round-off \[–\].
const ROUND_OFF: f64 = 1e-13;
/// Order from which iterations count as faster than linear \[–\]: that of linear ones is found within 0.1 of 1.
const FASTER: f64 = 1.2;
/// Orders that can be \[–\]: below, iterations still slow down; above, contact or flow changed between two of them, as no
/// matrix is better than quadratic.
const POSSIBLE: std::ops::RangeInclusive<f64> = 0.8..=2.5;
/// How far the orders of two triples may be apart, over the larger, where increments are in the asymptotic range \[–\].
const APART: f64 = 0.4;

/// How fast iterations converge at their end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// p of the last three increments \[–\]; `None` where the three before have another, or it is none that can be: these
    /// increments are not yet in the asymptotic range.
    pub order: Option<f64>,
    /// The last increment over the one before \[–\].
    pub left: f64,
}

impl Rate {
    /// Of the last increments of iterations, but for those at round-off; `None` where the last three do not fall or one of
    /// them was not taken whole, which is a `None`.
    pub fn of(increments: &[Option<f64>]) -> Option<Self> {
        let end = increments.iter().rposition(|norm| norm.is_none_or(|norm| norm > ROUND_OFF))? + 1;
        let whole = &increments[..end];
        let last = end.checked_sub(3).and_then(|start| triple(&whole[start..]))?;
        let before = end.checked_sub(4).and_then(|start| triple(&whole[start..end - 1]));
        let agrees = |(before, _): (f64, f64)| {
            let can_be = POSSIBLE.contains(&last.0) && POSSIBLE.contains(&before);
            can_be && (last.0 - before).abs() <= APART * last.0.max(before)
        };
        Some(Self { order: before.is_some_and(agrees).then_some(last.0), left: last.1 })
    }

    /// Whether each iteration does better than to leave the same share of the error.
    pub fn is_faster_than_linear(self) -> bool {
        self.order.is_some_and(|order| order > FASTER)
    }
}

/// Order of three increments that fall, and the last over the one before.
fn triple(increments: &[Option<f64>]) -> Option<(f64, f64)> {
    match *increments {
        [Some(a), Some(b), Some(c)] if a > b && b > c => Some(((c / b).ln() / (b / a).ln(), c / b)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: sequences by their definitions; one that was cut short, and one at round-off, say nothing.
    #[test]
    fn the_order_of_a_sequence_is_found() {
        let quadratic = [0.5_f64, 0.25, 0.0625, 0.003_906_25].map(Some);
        let rate = Rate::of(&quadratic).expect("a rate");
        assert!((rate.order.expect("an order") - 2.0).abs() < 1e-9 && rate.is_faster_than_linear());
        let linear = [1.0, 0.9, 0.81, 0.729].map(Some);
        let rate = Rate::of(&linear).expect("a rate");
        assert!(
            (rate.order.expect("an order") - 1.0).abs() < 1e-9
                && (rate.left - 0.9).abs() < 1e-9
                && !rate.is_faster_than_linear()
        );
        assert_eq!(Rate::of(&[Some(1.0), None, Some(0.1), Some(0.01)]), None);
        assert_eq!(Rate::of(&[Some(1e-4), Some(1e-9), Some(1e-15)]), None);
    }

    /// Trust: the increments of a cup's step, whose contact changes at the end: 0.94 and then 6.6 are no order.
    #[test]
    fn increments_outside_the_asymptotic_range_have_no_order() {
        let cup = [1.09e-3, 2.07e-4, 9.38e-5, 5.87e-5, 3.77e-5, 2.05e-6];
        for increments in [&cup[..], &cup[2..5]] {
            let rate = Rate::of(&increments.iter().copied().map(Some).collect::<Vec<_>>()).expect("three that fall");
            assert!(rate.order.is_none() && rate.left < 1.0 && !rate.is_faster_than_linear(), "{rate:?}");
        }
        let three = Rate::of(&[0.25, 0.0625, 0.003_906_25].map(Some)).expect("three that fall");
        assert_eq!(three.order, None, "three alone agree with anything");
    }
}
