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

/// How fast iterations converge at their end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// p of the last three increments \[–\].
    pub order: f64,
    /// The last increment over the one before \[–\].
    pub left: f64,
}

impl Rate {
    /// Of the last three increments of iterations that follow one another, fall, and are above round-off; `None` where there
    /// are none. An increment that was not taken whole is `None`.
    pub fn of(increments: &[Option<f64>]) -> Option<Self> {
        increments.windows(3).rev().find_map(|norms| match *norms {
            [Some(a), Some(b), Some(c)] if a > b && b > c && c > ROUND_OFF => {
                Some(Self { order: (c / b).ln() / (b / a).ln(), left: c / b })
            }
            _ => None,
        })
    }

    /// Whether each iteration does better than to leave the same share of the error.
    pub fn is_faster_than_linear(self) -> bool {
        self.order > FASTER
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
        assert!((rate.order - 2.0).abs() < 1e-9 && rate.is_faster_than_linear());
        let linear = [1.0, 0.9, 0.81, 0.729].map(Some);
        let rate = Rate::of(&linear).expect("a rate");
        assert!((rate.order - 1.0).abs() < 1e-9 && (rate.left - 0.9).abs() < 1e-9 && !rate.is_faster_than_linear());
        assert_eq!(Rate::of(&[Some(1.0), None, Some(0.1), Some(0.01)]), None);
        assert_eq!(Rate::of(&[Some(1e-4), Some(1e-9), Some(1e-15)]), None);
    }
}
