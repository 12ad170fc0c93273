//! A thickness point as a step finds it.

use super::Triple;
use crate::material::{Gtn, Surroundings, YieldCriterion};
use crate::units::ZERO_CELSIUS;

/// A thickness point as the step finds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointState<T = f64> {
    /// ε̄ at the start of the step \[–\].
    pub strain: T,
    /// f that the step reckons with, 0 for a sheet without voids \[–\].
    pub porosity: T,
    /// T \[K\].
    pub temperature: T,
    /// What the step before has to do with this one.
    pub past: Past<T>,
    /// What flows around it.
    pub surroundings: Surroundings<T>,
}

/// What the step before has to do with this one: nothing, until it is said.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Past<T = f64> {
    /// a \[–\].
    pub(super) weight: T,
    /// a p \[–\].
    pub(super) strain: Triple<T>,
    /// a times its spread over the point's part of the thickness \[–\].
    pub(super) spread: [T; 2],
    /// a p̄ \[–\].
    pub(super) equivalent: T,
}

impl PointState {
    /// A point of ordinary metal at room temperature, by itself.
    pub fn at(strain: f64) -> Self {
        Self {
            strain,
            porosity: 0.0,
            temperature: ROOM_TEMPERATURE,
            past: Past::default(),
            surroundings: Surroundings::default(),
        }
    }

    /// The point of a sheet that goes on flowing: with what the last rate would strain in this step, p, its spread over the
    /// point's part of the thickness, and with its weight a in the rate at the end.
    #[must_use]
    pub fn following(
        self,
        p: Triple,
        spread: [f64; 2],
        a: f64,
        criterion: YieldCriterion,
        voids: Option<&Gtn>,
    ) -> Self {
        let equivalent = match voids {
            None => criterion.equivalent_across(p, spread),
            Some(voids) => voids.condition(criterion.quadratic(), self.porosity).equivalent_increment(p),
        };
        let past =
            Past { weight: a, strain: p.map(|p| a * p), spread: spread.map(|k| a * k), equivalent: a * equivalent };
        Self { past, ..self }
    }
}

/// 20 °C \[K\].
pub const ROOM_TEMPERATURE: f64 = 20.0 + ZERO_CELSIUS;
