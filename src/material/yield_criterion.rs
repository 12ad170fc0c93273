//! The yield condition of a sheet without voids.

use super::yield_condition::{Metric, Triple, YieldCondition};
use super::{Hill48, Hosford};
use std::fmt;

/// The yield condition of a sheet without voids.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum YieldCriterion {
    /// Hill 1948, quadratic.
    Hill48(Hill48),
    /// Hosford's, of a higher exponent.
    Hosford(Hosford),
}

impl Default for YieldCriterion {
    /// Huber-Mises.
    fn default() -> Self {
        Hill48::default().into()
    }
}

impl From<Hill48> for YieldCriterion {
    fn from(hill: Hill48) -> Self {
        Self::Hill48(hill)
    }
}

impl From<Hosford> for YieldCriterion {
    fn from(hosford: Hosford) -> Self {
        Self::Hosford(hosford)
    }
}

/// Hands a method on to the condition.
macro_rules! by_condition {
    ($self:ident, $condition:ident => $call:expr) => {
        match $self {
            Self::Hill48($condition) => $call,
            Self::Hosford($condition) => $call,
        }
    };
}

impl YieldCriterion {
    /// r̄ \[–\].
    pub fn ratio(&self) -> f64 {
        by_condition!(self, condition => condition.ratio())
    }

    /// Hill's condition of the same r̄.
    pub fn quadratic(&self) -> Hill48 {
        match self {
            Self::Hill48(hill) => *hill,
            Self::Hosford(hosford) => hosford.quadratic(),
        }
    }

    /// Equivalent stress σ̄ \[MPa\].
    #[inline]
    pub fn equivalent_stress(&self, s: Triple) -> f64 {
        by_condition!(self, condition => condition.equivalent_stress(s))
    }

    /// Equivalent strain increment Δε̄ \[–\].
    #[inline]
    pub fn equivalent_increment(&self, e: Triple) -> f64 {
        by_condition!(self, condition => condition.equivalent_increment(e))
    }

    /// Equivalent increment of a part of the thickness over which it goes evenly from `e` − `k` to `e` + `k`: its root mean
    /// square \[–\].
    pub fn equivalent_across(&self, e: Triple, k: [f64; 2]) -> f64 {
        by_condition!(self, condition => condition.layer(e, k, None).square.sqrt())
    }

    /// ½Δε̄² of a strain increment: its gradient, which is Δε̄ times the stress over the yield stress, and second derivative.
    #[inline]
    pub fn metric(&self, e: Triple) -> Metric {
        by_condition!(self, condition => condition.metric(e))
    }

    /// ∂Δε̄/∂Δε: the stress of a strain increment over the yield stress \[–\]; nothing for no increment.
    pub fn stress(&self, e: Triple) -> Triple {
        let Metric { gradient, square, .. } = self.metric(e);
        if square == 0.0 { [0.0; 3] } else { gradient.map(|s| s / square.sqrt()) }
    }

    /// σ_θ/σ_s where the sheet does not strain along θ \[–\].
    pub fn plane_strain_ratio(&self) -> f64 {
        match self {
            Self::Hill48(hill) => hill.coupling(),
            Self::Hosford(hosford) => hosford.plane_strain_ratio(),
        }
    }

    /// Stress of equi-biaxial tension over that of tension along one direction, when both yield \[–\].
    pub fn biaxial_factor(&self) -> f64 {
        1.0 / self.equivalent_stress([1.0, 1.0, 0.0])
    }
}

impl fmt::Display for YieldCriterion {
    /// The formula with its name and numbers.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let r = self.ratio();
        match self {
            Self::Hill48(_) => write!(f, "Hill 1948, r̄ = {r}"),
            Self::Hosford(hosford) => {
                let a = hosford.exponent();
                write!(f, "Hosford, (1 + r̄) σ̄^{a} = |σ_s|^{a} + |σ_θ|^{a} + r̄ |σ_s − σ_θ|^{a}, r̄ = {r}")
            }
        }
    }
}
