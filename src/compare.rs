//! A computed table against a reference curve.

use std::path::PathBuf;

/// What to compare with which curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    pub reference: PathBuf,
    pub x: String,
    pub y: String,
    pub quantity: Quantity,
    /// In units of the x column.
    pub range: Option<(f64, f64)>,
    /// Relative, 0.05 = 5 %.
    pub tolerance: f64,
    pub reason: String,
    pub optional: bool,
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// Punch force at equal travel.
    PunchForce,
    /// Punch travel at equal force.
    Travel,
    /// Thickness over the initial distance from the axis, at the last frame.
    ThicknessAtS0,
    /// Thickness over the present radius, at the last frame.
    ThicknessAtRadius,
}
