//! Rate of convergence of a sequence of increments.
//!
//! ```text
//! e_k = |δȧ_k|/|ȧ|                   the increment of iteration k stands for the error that it removed
//! e_k+1 = C e_k^p                    p = ln(e_k+1/e_k)/ln(e_k/e_k−1): 1 linear, 2 quadratic
//! ```

/// Velocity norm below which an increment is mostly round-off \[–\].
const ROUND_OFF: f64 = 1e-13;
/// Plausible orders \[–\]: beyond them contact or flow changed between two iterations.
const POSSIBLE: std::ops::RangeInclusive<f64> = 0.8..=2.5;
/// Largest relative difference of two successive orders in the asymptotic range \[–\].
const APART: f64 = 0.4;

/// Rate of convergence at the end of a pass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConvergenceRate {
    /// Order p of the last three increments \[–\]; `None` outside the asymptotic range.
    pub order: Option<f64>,
    /// Ratio of the last increment to the one before \[–\].
    pub left: f64,
}

impl ConvergenceRate {
    /// Rate of the last increments above round-off; `None` unless the last three fall and were taken whole (`Some`).
    pub fn new(increments: &[Option<f64>]) -> Option<Self> {
        let end = increments.iter().rposition(|norm| norm.is_none_or(|norm| norm > ROUND_OFF))? + 1;
        let whole = &increments[..end];
        let last = end.checked_sub(3).and_then(|start| triple(&whole[start..]))?;
        let before = end.checked_sub(4).and_then(|start| triple(&whole[start..end - 1]));
        let agrees = |(before, _): (f64, f64)| {
            let possible = POSSIBLE.contains(&last.0) && POSSIBLE.contains(&before);
            possible && (last.0 - before).abs() <= APART * last.0.max(before)
        };
        Some(Self { order: before.is_some_and(agrees).then_some(last.0), left: last.1 })
    }
}

/// Order of three falling increments, and the last over the one before.
fn triple(increments: &[Option<f64>]) -> Option<(f64, f64)> {
    match *increments {
        [Some(a), Some(b), Some(c)] if a > b && b > c => Some(((c / b).ln() / (b / a).ln(), c / b)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: sequences by their definitions, and the increments of a step whose contact changes at the end.
    #[test]
    fn the_order_of_a_sequence_is_found() {
        let rate = |increments: &[f64]| ConvergenceRate::new(&increments.iter().copied().map(Some).collect::<Vec<_>>());
        let [quadratic, linear] =
            [[0.5, 0.25, 0.0625, 0.003_906_25], [1.0, 0.9, 0.81, 0.729]].map(|e| rate(&e).expect("a rate"));
        assert!((quadratic.order.expect("an order") - 2.0).abs() < 1e-9);
        assert!((linear.order.expect("an order") - 1.0).abs() < 1e-9 && (linear.left - 0.9).abs() < 1e-9);
        assert_eq!(rate(&[1e-4, 1e-9, 1e-15]), None);
        assert_eq!(ConvergenceRate::new(&[Some(1.0), None, Some(0.1), Some(0.01)]), None);
        let changes = rate(&[1.09e-3, 2.07e-4, 9.38e-5, 5.87e-5, 3.77e-5, 2.05e-6]).expect("a rate");
        assert!(changes.order.is_none() && changes.left < 1.0);
    }
}
