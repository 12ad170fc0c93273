//! Friction laws, one per file.
//!
//! A law gives τ from pressure p, slip s and duration of a step, regularised by a sliding speed v₀.
//!
//! ```text
//! φ(s) = s/√(s² + s₀²),  s₀ = v₀ Δt          τ(p, s) = (a stress that the law gives) · φ(s)
//! ```
//!
//! # References
//! The plasticity analogy and its tangent: Perić, Owen, 3D contact problems with friction by the penalty method (1991).

mod coulomb;
mod pressure_dependent;
mod stribeck;
mod tresca;

use crate::material::law::family;
use crate::numerics::ValueAndSlope;

/// Contact pressure and slip of a point.
#[derive(Clone, Copy, Debug)]
pub struct Sliding {
    /// Contact pressure p ≥ 0 \[MPa\].
    pub pressure: f64,
    /// Slip s of the step relative to the tool \[mm\].
    pub slip: f64,
    /// s₀ > 0 \[mm\].
    pub scale: f64,
    /// Duration Δt of the step \[s\].
    pub duration: f64,
    /// Shear yield stress k of the sheet \[MPa\].
    pub shear_yield: f64,
}

/// Friction stress against the slip, and its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrictionStress {
    /// τ \[MPa\].
    pub value: f64,
    /// ∂τ/∂p \[–\].
    pub by_pressure: f64,
    /// ∂τ/∂s \[MPa/mm\].
    pub by_slip: f64,
}

impl FrictionStress {
    /// Stress `full` φ(s), whose derivative by the pressure is `by_pressure` φ(s).
    fn regularised(full: f64, by_pressure: f64, at: &Sliding) -> Self {
        let phi = direction(at.slip, at.scale);
        Self { value: full * phi.value, by_pressure: by_pressure * phi.value, by_slip: full * phi.slope }
    }
}

/// φ(s) = s/√(s² + s₀²) and its derivative \[1/mm\].
#[inline(always)]
pub fn direction(slip: f64, scale: f64) -> ValueAndSlope {
    let inverse = 1.0 / (slip * slip + scale * scale).sqrt();
    ValueAndSlope { value: slip * inverse, slope: inverse * inverse * inverse * (scale * scale) }
}

family! {
    /// The friction law of one tool: exactly one, or Coulomb's coefficient, 0 to 1.
    #[derive(Copy)]
    pub enum Friction: FrictionLaw, named in FrictionTable as "FrictionLaw";
    /// Friction stress and its derivatives.
    fn at(sliding: &Sliding) -> FrictionStress;
    {
        fn largest_coefficient(&self) -> f64;
    }
    [coulomb: Coulomb]
    pressure_dependent: PressureDependent,
    stribeck: Stribeck,
    tresca: Tresca,
}

impl From<f64> for Friction {
    /// Coulomb's law with this coefficient \[–\].
    fn from(coefficient: f64) -> Self {
        Self::Coulomb(Coulomb { coefficient })
    }
}

impl Friction {
    /// Largest coefficient τ/p that the law gives while sliding slowly \[–\].
    pub fn largest_coefficient(&self) -> f64 {
        self.law().largest_coefficient()
    }

    /// Law with every coefficient, and the share of the shear yield stress, changed by as much, within 0 to 1 \[–\].
    pub fn changed(mut self, by: f64) -> Self {
        let change = |coefficient: &mut f64| *coefficient = (*coefficient + by).clamp(0.0, 1.0);
        match &mut self {
            Self::Coulomb(law) => change(&mut law.coefficient),
            Self::PressureDependent(law) => change(&mut law.coefficient),
            Self::Stribeck(law) => [&mut law.at_rest, &mut law.sliding].into_iter().for_each(change),
            Self::Tresca(law) => [&mut law.factor, &mut law.coefficient].into_iter().for_each(change),
        }
        self
    }
}
