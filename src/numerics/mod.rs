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
