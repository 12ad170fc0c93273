//! Friction laws: one law, one file.

mod coulomb;

pub use coulomb::Coulomb;
