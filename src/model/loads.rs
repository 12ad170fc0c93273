//! Draw beads and gas.

use super::Geometry;
use crate::numerics::PiecewiseLinear;
use crate::units::{As, Length, Positive};

/// Draw bead: line restraint on the flange whose closing force is taken from the holder's.
#[derive(Clone, Debug, PartialEq)]
pub struct Bead {
    /// Distance of its line from the axis or the symmetry plane \[mm\].
    pub at: f64,
    /// Restraining force per length of the line over the punch travel \[N/mm over mm\].
    pub restraining: PiecewiseLinear,
    /// Closing force per length of the line \[N/mm\].
    pub closing: f64,
    /// Section that both forces are computed from; `None` where they are given.
    pub round: Option<Round>,
}

/// Round bead in the holder, groove in the die; both forces come from a strip that is bent into them and pulled through.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Round {
    /// Radius of the bead.
    #[serde(with = "As::<Positive<Length>>")]
    pub radius: f64,
    /// Height over the holder's face; above the radius its flanks are straight. It closes to 1.02 thicknesses, or the gap.
    #[serde(with = "As::<Positive<Length>>")]
    pub height: f64,
    /// Radius of the groove's edges.
    #[serde(with = "As::<Positive<Length>>")]
    pub shoulder: f64,
    /// Distance between the bead's foot and the groove's wall on each side; 1.1 thicknesses when not given, as declared.
    #[serde(default, with = "As::<Positive<Length>>")]
    pub clearance: Option<f64>,
}

impl Bead {
    /// Length of the line \[mm\], or 1 per mm of depth.
    pub fn line(&self, geometry: Geometry) -> f64 {
        geometry.line(self.at)
    }
}

/// Gas or oil pressure on a face, normal to the current sheet.
#[derive(Clone, Debug, PartialEq)]
pub struct Gas {
    /// Face under pressure.
    pub face: Face,
    /// Pressure or its control.
    pub pressure: Pressure,
    /// Distance of the seal from the axis or symmetry plane \[mm\]; the gas acts inside.
    pub within: f64,
}

/// Face of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The punch's side: pressure pushes along the punch travel.
    Lower,
    /// The die's side: pressure pushes against the punch travel.
    Upper,
}

impl Face {
    /// Direction of pressure: +1 along the punch travel, −1 against it.
    pub fn sign(self) -> f64 {
        if self == Face::Lower { 1.0 } else { -1.0 }
    }
}

/// Given or controlled gas pressure.
#[derive(Clone, Debug, PartialEq)]
pub enum Pressure {
    /// Pressure over time \[MPa over s\].
    OverTime(PiecewiseLinear),
    /// Unknown pressure that holds a strain rate.
    Rate(RateControl),
}

impl Pressure {
    /// Given pressure at a time \[MPa\].
    pub fn prescribed(&self, time: f64) -> Option<f64> {
        if let Self::OverTime(history) = self { Some(history.at(time)) } else { None }
    }
}

impl<T: Into<PiecewiseLinear>> From<T> for Pressure {
    fn from(history: T) -> Self {
        Self::OverTime(history.into())
    }
}

/// Superplastic forming: pressure that holds the norm ‖ε̄̇‖ = (Σ V ε̄̇^q/Σ V)^(1/q) at a target in every step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateControl {
    /// Target of the norm \[1/s\].
    pub target: f64,
    /// Exponent q \[–\]: 1 is the mean over the volume, a large one the fastest place.
    pub exponent: f64,
    /// Largest pressure \[MPa\]; infinite without limit.
    pub max_pressure: f64,
    /// Fastest rise of the pressure \[MPa/s\]; infinite without limit.
    pub max_rise: f64,
}

impl RateControl {
    /// Control without limits of the press.
    pub fn new(target: f64, exponent: f64) -> Self {
        Self { target, exponent, max_pressure: f64::INFINITY, max_rise: f64::INFINITY }
    }

    /// Largest pressure at the end of a step of `dt` \[s\] from `before` \[MPa\], and its cap; `None` without a cap.
    pub fn cap(&self, before: f64, dt: f64) -> Option<(f64, PressureCap)> {
        let risen = before + self.max_rise * dt;
        let which = if self.max_pressure <= risen { PressureCap::Largest } else { PressureCap::Rise };
        Some((self.max_pressure.min(risen), which)).filter(|(cap, _)| cap.is_finite())
    }
}

/// Limit of the press.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureCap {
    /// Largest pressure.
    Largest,
    /// Fastest rise of the pressure.
    Rise,
}
