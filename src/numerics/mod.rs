//! Numerical methods that know nothing of forming.

pub mod block_tridiagonal;
pub mod lobatto;
mod piecewise_linear;

pub use piecewise_linear::PiecewiseLinear;
