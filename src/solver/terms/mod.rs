//! The terms of the equilibrium, each with its residual and its matrix.

pub mod bead;
pub mod contact;
pub mod gas;
pub mod holder;
pub mod sheet;
