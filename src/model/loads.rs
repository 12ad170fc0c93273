//! What loads the sheet beside the tools: draw beads and gas.

use super::Geometry;
use crate::numerics::PiecewiseLinear;

/// A draw bead as a line restraint on the flange.
///
/// It pulls the sheet back with a force per length of its line while the sheet passes it, and the force that closes it
/// is taken from the holder's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bead {
    /// Distance of its line from the axis or the symmetry plane \[mm\].
    pub at: f64,
    /// Restraining force per length of the line \[N/mm\].
    pub restraining: f64,
    /// Closing force per length of the line \[N/mm\].
    pub closing: f64,
}

impl Bead {
    /// Length of the line \[mm\], or 1 per mm of depth.
    pub fn line(&self, geometry: Geometry) -> f64 {
        match geometry {
            Geometry::Axisymmetric => std::f64::consts::TAU * self.at,
            Geometry::PlaneStrain => 1.0,
        }
    }
}

/// Gas or oil pressure on a face of the sheet; it stays normal to the sheet and acts on its current area.
#[derive(Clone, Debug, PartialEq)]
pub struct Gas {
    /// The face that it presses on.
    pub face: Face,
    /// The pressure, or what decides it.
    pub pressure: Pressure,
    /// It acts on what lies closer to the axis or symmetry plane than this seal \[mm\].
    pub within: f64,
}

/// Which face of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The punch's side: pressure pushes along the punch travel.
    Lower,
    /// The die's side: pressure pushes against the punch travel.
    Upper,
}

impl Face {
    /// Which way pressure on it pushes: +1 along the punch travel, −1 against it.
    pub fn sign(self) -> f64 {
        match self {
            Face::Lower => 1.0,
            Face::Upper => -1.0,
        }
    }
}

/// What decides a gas pressure.
#[derive(Clone, Debug, PartialEq)]
pub enum Pressure {
    /// Given over time \[MPa over s\].
    OverTime(PiecewiseLinear),
    /// As much as holds a strain rate; an unknown of its own.
    Rate(RateControl),
}

impl Pressure {
    /// The pressure at a time where it is given \[MPa\].
    pub fn given(&self, time: f64) -> Option<f64> {
        match self {
            Self::OverTime(history) => Some(history.at(time)),
            Self::Rate(_) => None,
        }
    }
}

impl From<PiecewiseLinear> for Pressure {
    fn from(history: PiecewiseLinear) -> Self {
        Self::OverTime(history)
    }
}

impl From<f64> for Pressure {
    fn from(pressure: f64) -> Self {
        Self::OverTime(pressure.into())
    }
}

/// Superplastic forming: the pressure that makes the sheet's strain rate, by the norm ‖ε̄̇‖ = (Σ V ε̄̇^q/Σ V)^(1/q), the
/// target in every step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateControl {
    /// Target of the norm \[1/s\].
    pub target: f64,
    /// q: 1 is the mean over the sheet's volume, a large one the fastest place \[–\].
    pub exponent: f64,
    /// Largest pressure that the press gives \[MPa\]; infinite where nothing is said.
    pub max_pressure: f64,
    /// Fastest rise of the pressure \[MPa/s\]; infinite where nothing is said.
    pub max_rise: f64,
}

impl RateControl {
    /// A target and a norm, and a press that gives any pressure.
    pub fn new(target: f64, exponent: f64) -> Self {
        Self { target, exponent, max_pressure: f64::INFINITY, max_rise: f64::INFINITY }
    }

    /// What the pressure may come to at the end of a step of `dt` \[s\] that it begins with `before` \[MPa\], and which cap
    /// says so; `None` where there is no cap.
    pub fn cap(&self, before: f64, dt: f64) -> Option<(f64, PressureCap)> {
        let risen = before + self.max_rise * dt;
        let (cap, which) = if self.max_pressure <= risen {
            (self.max_pressure, PressureCap::Largest)
        } else {
            (risen, PressureCap::Rise)
        };
        cap.is_finite().then_some((cap, which))
    }
}

/// What the press cannot go beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureCap {
    /// Its largest pressure.
    Largest,
    /// Its fastest rise of the pressure.
    Rise,
}
