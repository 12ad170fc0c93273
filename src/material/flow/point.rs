//! State of a thickness point at the start of a step.

use super::Triple;
use crate::material::yield_condition::YieldCondition;
use crate::material::{Gtn, Surroundings, YieldCriterion};
use crate::units::ZERO_CELSIUS;

/// State of a thickness point at the start of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState {
    /// ε̄ at the start of the step \[–\].
    pub strain: f64,
    /// f that the step reckons with, 0 for a sheet without voids \[–\].
    pub porosity: f64,
    /// T \[K\].
    pub temperature: f64,
    /// Rate at the end of the step before.
    pub previous: PreviousRate,
    /// Resistance of its surroundings.
    pub surroundings: Surroundings,
}

/// Rate at the end of the step before, times its weight a in the rate of this one; zero in a first step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PreviousRate {
    /// a \[–\].
    pub(super) weight: f64,
    /// a p \[–\].
    pub(super) strain: Triple,
    /// a times its spread over the point's part of the thickness \[–\].
    pub(super) spread: [f64; 2],
    /// a p̄ \[–\].
    pub(super) equivalent: f64,
}

impl PointState {
    /// A point of ordinary metal at room temperature, by itself.
    pub fn at(strain: f64) -> Self {
        Self {
            strain,
            porosity: 0.0,
            temperature: ROOM_TEMPERATURE,
            previous: PreviousRate::default(),
            surroundings: Surroundings::default(),
        }
    }

    /// Point of a sheet that goes on flowing: the last rate would strain it by `p`, with this spread, in the step.
    #[must_use]
    pub fn following(
        self,
        p: Triple,
        spread: [f64; 2],
        a: f64,
        criterion: YieldCriterion,
        voids: Option<&Gtn>,
    ) -> Self {
        let (equivalent, spread) = match voids {
            None => (criterion.layer(p, spread, None).square.sqrt(), spread),
            Some(voids) => (voids.condition(criterion.quadratic(), self.porosity).equivalent_increment(p), [0.0; 2]),
        };
        let (strain, spread) = (p.map(|p| a * p), spread.map(|k| a * k));
        Self { previous: PreviousRate { weight: a, strain, spread, equivalent: a * equivalent }, ..self }
    }
}

/// 20 °C \[K\].
pub const ROOM_TEMPERATURE: f64 = 20.0 + ZERO_CELSIUS;
