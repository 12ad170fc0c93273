//! Numerical methods that know nothing of forming.

pub mod block_tridiagonal;
mod grid;
pub mod least_squares;
mod piecewise_linear;
mod power;
pub mod quadrature;
#[cfg(feature = "app")]
pub mod statistics;

pub use grid::Grid;
pub use piecewise_linear::{PiecewiseLinear, interpolated};
pub use power::Power;

/// Value of a function and its derivative.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ValueAndSlope {
    /// f(x).
    pub value: f64,
    /// df/dx.
    pub slope: f64,
}

/// Running sums, beginning with 0.
pub fn running_sums(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sums = vec![0.0];
    values.for_each(|value| sums.push(sums[sums.len() - 1] + value));
    sums
}

/// Halves the bracket from `low`, where `is_below` holds, to `high`, where it does not; `low` may be the larger number.
///
/// 50 halvings use up the digits of a bracket of order one.
pub fn bisect(low: f64, high: f64, halvings: usize, mut is_below: impl FnMut(f64) -> bool) -> [f64; 2] {
    let (mut low, mut high) = (low, high);
    for _ in 0..halvings {
        let middle = 0.5 * (low + high);
        if is_below(middle) { low = middle } else { high = middle }
    }
    [low, high]
}
