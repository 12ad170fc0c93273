//! The yield condition of a sheet without voids.

use super::{Hill48, Hosford, yield_condition::Metric, yield_condition::Triple, yield_condition::YieldCondition};
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

impl YieldCriterion {
    /// r̄ \[–\].
    pub fn ratio(&self) -> f64 {
        self.quadratic().ratio
    }

    /// Hill's condition of the same r̄.
    pub fn quadratic(&self) -> Hill48 {
        match self {
            Self::Hill48(hill) => *hill,
            Self::Hosford(hosford) => hosford.quadratic,
        }
    }

    /// Equivalent stress σ̄ \[MPa\].
    pub fn equivalent_stress(&self, s: Triple) -> f64 {
        match self {
            Self::Hill48(hill) => hill.equivalent_stress(s),
            Self::Hosford(hosford) => hosford.equivalent_stress(s),
        }
    }

    /// Yield stress of equi-biaxial tension over that of tension \[–\].
    pub fn biaxial_factor(&self) -> f64 {
        1.0 / self.equivalent_stress([1.0, 1.0, 0.0])
    }

    /// Stress of plane strain over tension, equivalent over plane strain: (1 + r̄)/√(1 + 2r̄) by Hill \[–\].
    pub fn plane_strain_factor(&self) -> f64 {
        self.metric([1.0, 0.0, 0.0]).square.sqrt()
    }
}

impl YieldCondition for YieldCriterion {
    fn metric_towards(&self, e: Triple, w: Option<[f64; 2]>) -> Metric {
        match self {
            Self::Hill48(hill) => hill.metric_towards(e, w),
            Self::Hosford(hosford) => hosford.metric_towards(e, w),
        }
    }
}

impl fmt::Display for YieldCriterion {
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
