//! Numerical methods that know nothing of forming.

mod abreast;
mod bisection;
pub mod block_tridiagonal;
pub mod elementary;
mod grid;
pub mod least_squares;
pub mod lobatto;
pub mod number;
pub mod parts;
mod piecewise_linear;
mod power;
pub mod profile;
pub mod small;
mod student;

pub use abreast::Abreast;
pub use bisection::bisect;
pub use grid::Grid;
pub use number::Real;
pub use piecewise_linear::{PiecewiseLinear, interpolated};
pub use power::Power;
pub use student::student;
