//! Numerical methods that know nothing of forming.

mod bisection;
pub mod block_tridiagonal;
mod grid;
pub mod least_squares;
pub mod lobatto;
pub mod midpoint_rule;
mod piecewise_linear;
mod power;

pub use bisection::bisect;
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
