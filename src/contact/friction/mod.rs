//! Friction laws, one per file.
//!
//! A law gives the friction stress τ from the contact pressure p, the slip s of the step and its duration. All are regularised
//! by a sliding speed v₀, so that the law does not depend on the step.
//!
//! ```text
//! φ(s) = s/√(s² + s₀²),  s₀ = v₀ Δt          τ(p, s) = (a stress that the law gives) · φ(s)
//! ```
//!
//! # References
//! The plasticity analogy and its tangent: Perić, Owen, Computational model for 3D contact problems with friction
//! based on the penalty method (1991).

mod coulomb;
mod pressure_dependent;
mod stribeck;
mod tresca;

use crate::contact::penalty::ValueAndSlope;
use crate::material::law::{Law, family};

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

/// φ(s) = s/√(s² + s₀²) and its derivative \[1/mm\].
#[inline(always)]
pub fn direction(slip: f64, scale: f64) -> ValueAndSlope {
    let square = slip * slip + scale * scale;
    let inverse = 1.0 / square.sqrt();
    ValueAndSlope { value: slip * inverse, slope: inverse * inverse * inverse * (scale * scale) }
}

/// Friction law.
trait FrictionLaw: Law {
    /// Friction stress and its derivatives.
    fn at(&self, sliding: &Sliding) -> FrictionStress;

    /// Largest coefficient τ/p that the law gives while sliding slowly \[–\].
    fn largest_coefficient(&self) -> f64;
}

family! {
    /// The friction law of one tool: exactly one, or Coulomb's coefficient, 0 to 1.
    pub enum Friction: FrictionLaw, named in FrictionTable as "FrictionLaw";
    /// Friction stress and its derivatives.
    fn at(sliding: &Sliding) -> FrictionStress;
    [coulomb: Coulomb]
    pressure_dependent: PressureDependent,
    stribeck: Stribeck,
    tresca: Tresca,
}

impl Copy for Friction {}
impl Copy for FrictionTable {}

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
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use proptest::prelude::*;

    fn sliding() -> impl Strategy<Value = Sliding> {
        (1e-3..500.0, -0.3..0.3, 1e-4..1e-2, 1e-3..1.0, 20.0..400.0).prop_map(
            |(pressure, slip, scale, duration, shear_yield)| Sliding { pressure, slip, scale, duration, shear_yield },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        /// Trust: central differences; h = 1e-5 of the smallest length in the law, truncation near 1e-9 of the entry.
        #[test]
        fn derivatives_agree_with_differences(at in sliding()) {
            for (name, law) in Friction::examples() {
                let drag = law.at(&at);
                let h = 1e-5 * at.scale;
                let by = |slip: f64| law.at(&Sliding { slip, ..at }).value;
                let difference = (by(at.slip + h) - by(at.slip - h)) / (2.0 * h);
                let size = drag.value.abs() / at.scale;
                prop_assert!((difference - drag.by_slip).abs() < 1e-6 * size, "{name} by slip");
                let h = 1e-5 * at.pressure;
                let by = |pressure: f64| law.at(&Sliding { pressure, ..at }).value;
                let difference = (by(at.pressure + h) - by(at.pressure - h)) / (2.0 * h);
                prop_assert!((difference - drag.by_pressure).abs() < 1e-6 * drag.value.abs() / at.pressure, "{name} by pressure");
            }
        }

        /// Friction takes power, is odd in the slip and stays below the law's largest coefficient.
        #[test]
        fn friction_opposes_sliding(at in sliding()) {
            for (name, law) in Friction::examples() {
                let stress = law.at(&at).value;
                prop_assert!(stress * at.slip >= 0.0, "{name}");
                prop_assert_eq!(law.at(&Sliding { slip: -at.slip, ..at }).value, -stress);
                let viscous = if let Friction::Stribeck(s) = law { s.viscous * at.slip.abs() / at.duration } else { 0.0 };
                prop_assert!(stress.abs() <= (law.largest_coefficient() + viscous) * at.pressure * (1.0 + 1e-12), "{name}");
            }
        }
    }

    /// Trust: the published forms themselves, where the regularisation is full (slip ≫ s₀: φ = 1 to 5e-9).
    #[test]
    fn sliding_values_are_the_published_ones() {
        let at = |pressure: f64, speed: f64| Sliding {
            pressure,
            slip: speed,
            scale: 1e-4 * speed,
            duration: 1.0,
            shear_yield: 150.0,
        };
        let laws: std::collections::HashMap<_, _> = Friction::examples().into_iter().collect();
        assert_relative_eq!(laws["coulomb"].at(&at(20.0, 1.0)).value, 2.4, max_relative = 1e-8);
        // Below 1 % of the reference pressure the coefficient levels off; at 4 times it that is felt by 1e-6.
        let power = 0.12 * (40.0_f64 / 10.0).powf(-0.15) * 40.0;
        assert_relative_eq!(laws["pressure_dependent"].at(&at(40.0, 1.0)).value, power, max_relative = 1e-6);
        let stribeck = (0.05 + 0.1 * (-0.25_f64).exp() + 0.002) * 20.0;
        assert_relative_eq!(laws["stribeck"].at(&at(20.0, 1.0)).value, stribeck, max_relative = 1e-8);
        // Far above and far below the transition: the limit m k, and Coulomb.
        assert_relative_eq!(laws["tresca"].at(&at(2000.0, 1.0)).value, 30.0, max_relative = 1e-8);
        assert_relative_eq!(laws["tresca"].at(&at(1e-3, 1.0)).value, Tresca::BOUND * 1e-3, max_relative = 1e-8);
    }
}
