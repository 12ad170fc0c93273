//! How fast iterations converge.
//!
//! ```text
//! e_k = |δȧ_k|/|ȧ|                   the increment of iteration k stands for the error that it took away
//! e_k+1 = C e_k^p                    p = ln(e_k+1/e_k)/ln(e_k/e_k−1)
//! ```
//!
//! Linear convergence has p = 1 and leaves the same share of the error in each iteration, quadratic has p = 2 and doubles the
//! digits that are right.

use super::Iterated;

/// Velocity norm below which an increment is mostly round-off \[–\].
const ROUND_OFF: f64 = 1e-13;
/// Order from which iterations count as faster than linear \[–\]: half way to quadratic.
const FASTER: f64 = 1.5;

/// How fast iterations converge at their end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rate {
    /// p of the last three increments \[–\].
    pub order: f64,
    /// The last increment over the one before \[–\].
    pub left: f64,
}

impl Rate {
    /// Of the last three increments that were taken whole, fall, and are above round-off; `None` where there are none.
    pub fn of(iterated: &[Iterated]) -> Option<Self> {
        let whole = |i: &Iterated| i.velocity_norm.filter(|norm| i.share >= Some(1.0) && *norm > ROUND_OFF);
        let norms: Vec<Option<f64>> = iterated.iter().map(whole).collect();
        norms.windows(3).rev().find_map(|norms| match *norms {
            [Some(a), Some(b), Some(c)] if a > b && b > c => {
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
