//! Friction laws: one law, one file.
//!
//! Every law gives the friction stress τ that opposes sliding, from the contact pressure p, the slip s of the step
//! relative to the tool and the step's duration. All are regularised alike: a node that should stick creeps instead,
//! slower than a stated sliding speed v₀, so that the law does not depend on the step.
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

pub use coulomb::Coulomb;
pub use pressure_dependent::PressureDependent;
pub use stribeck::Stribeck;
pub use tresca::Tresca;

use crate::contact::penalty::ValueAndSlope;
use std::fmt;

/// What a law looks at.
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

/// Friction stress against the slip \[MPa\], and its derivatives by pressure \[–\] and slip \[MPa/mm\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drag {
    pub value: f64,
    pub by_pressure: f64,
    pub by_slip: f64,
}

/// φ(s) = s/√(s² + s₀²) and its derivative \[1/mm\].
#[inline]
pub fn direction(slip: f64, scale: f64) -> ValueAndSlope {
    let root = (slip * slip + scale * scale).sqrt();
    ValueAndSlope { value: slip / root, slope: scale * scale / (root * root * root) }
}

/// The law of one tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Friction {
    Coulomb(Coulomb),
    PressureDependent(PressureDependent),
    Stribeck(Stribeck),
    Tresca(Tresca),
}

impl From<f64> for Friction {
    /// Coulomb's law with this coefficient \[–\].
    fn from(coefficient: f64) -> Self {
        Self::Coulomb(Coulomb { coefficient })
    }
}

impl Friction {
    /// The friction stress and its derivatives.
    #[inline]
    pub fn at(&self, sliding: &Sliding) -> Drag {
        match self {
            Self::Coulomb(law) => law.at(sliding),
            Self::PressureDependent(law) => law.at(sliding),
            Self::Stribeck(law) => law.at(sliding),
            Self::Tresca(law) => law.at(sliding),
        }
    }

    /// Whether the law asks for the sheet's shear yield stress.
    pub fn needs_shear_yield(&self) -> bool {
        matches!(self, Self::Tresca(_))
    }

    /// Largest coefficient τ/p that the law gives while sliding slowly \[–\].
    pub fn largest_coefficient(&self) -> f64 {
        match self {
            Self::Coulomb(law) => law.coefficient,
            Self::PressureDependent(law) => law.largest(),
            Self::Stribeck(law) => law.at_rest.max(law.sliding),
            Self::Tresca(law) => law.coefficient,
        }
    }

    /// One example of every law, named: for tests and lists.
    pub fn examples() -> Vec<(&'static str, Self)> {
        vec![
            ("coulomb", Self::from(0.12)),
            (
                "pressure_dependent",
                Self::PressureDependent(PressureDependent { coefficient: 0.12, reference: 10.0, exponent: 0.85 }),
            ),
            ("stribeck", Self::Stribeck(Stribeck { at_rest: 0.15, sliding: 0.05, speed: 2.0, viscous: 0.002 })),
            ("tresca", Self::Tresca(Tresca { factor: 0.2, coefficient: Tresca::BOUND })),
        ]
    }
}

impl fmt::Display for Friction {
    /// The law in words and numbers with units; Coulomb's coefficient alone.
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Coulomb(law) => write!(f, "{}", law.coefficient),
            Self::PressureDependent(law) => f.write_str(&law.describe()),
            Self::Stribeck(law) => f.write_str(&law.describe()),
            Self::Tresca(law) => f.write_str(&law.describe()),
        }
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

        /// Friction only ever takes power, is odd in the slip and stays below the law's largest coefficient.
        #[test]
        fn friction_opposes_sliding(at in sliding()) {
            for (name, law) in Friction::examples() {
                let drag = law.at(&at);
                prop_assert!(drag.value * at.slip >= 0.0, "{name}");
                prop_assert_eq!(law.at(&Sliding { slip: -at.slip, ..at }).value, -drag.value);
                let viscous = if let Friction::Stribeck(s) = law { s.viscous * at.slip.abs() / at.duration } else { 0.0 };
                prop_assert!(drag.value.abs() <= (law.largest_coefficient() + viscous) * at.pressure * (1.0 + 1e-12), "{name}");
                if let Friction::Tresca(tresca) = law {
                    prop_assert!(drag.value.abs() <= tresca.factor * at.shear_yield);
                }
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
