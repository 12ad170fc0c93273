//! Numerical methods that know nothing of forming.

pub mod block_tridiagonal;
mod grid;
pub mod lobatto;
mod piecewise_linear;

pub use grid::Grid;
pub use piecewise_linear::PiecewiseLinear;
