//! Friction whose coefficient depends on the sliding speed v = s/Δt, in Stribeck's form:
//! τ = p \[(μ_k + (μ_s − μ_k) exp(−(v/v_s)²)) φ(s) + c v\].

use super::{FrictionLaw, FrictionStress, Sliding, direction};
use crate::material::law::prelude::*;

parameters! {
    /// Coefficient that depends on the sliding speed v: sliding + (at_rest − sliding) exp(−(v/speed)²) + viscous v.
    ///
    /// Source: in common use (as in MathWorks, Simscape, Translational Friction, but for its smoothing);
    /// B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, Automatica 30 (1994) 1083–1138 (not read).
    pub struct Stribeck {
        /// Coefficient of the slowest sliding, 0 to 1.
        pub at_rest: "As::<Fraction>" = 0.15,
        /// Coefficient of fast sliding, 0 to 1.
        pub sliding: "As::<Fraction>" = 0.05,
        /// Stribeck's speed \[mm/s\].
        pub speed: "As::<Positive<Speed>>" = "10 mm/s",
        /// Rise of the coefficient with the speed, per mm/s; none when not given.
        #[serde(default)]
        pub viscous: "As::<NonNegative<Number>>" = 0.0001,
    }
}

impl Stribeck {
    /// The coefficient at the speed `v` ≥ 0 \[mm/s\], regularisation aside.
    pub fn coefficient(&self, v: f64) -> f64 {
        self.sliding + (self.at_rest - self.sliding) * (-(v / self.speed).powi(2)).exp() + self.viscous * v
    }
}

impl FrictionLaw for Stribeck {
    fn formula(&self) -> String {
        let Self { at_rest, sliding, speed, viscous } = self;
        let viscous = if *viscous == 0.0 { String::new() } else { format!(", + {viscous} s/mm times the speed") };
        format!("{at_rest} at rest, {sliding} sliding well beyond {speed} mm/s{viscous}")
    }

    fn at(&self, at: &Sliding) -> FrictionStress {
        let phi = direction(at.slip, at.scale);
        let v = at.slip / at.duration;
        let x = v / self.speed;
        let drop = (self.at_rest - self.sliding) * (-x * x).exp();
        let mu = self.sliding + drop;
        let mu_by_slip = -2.0 * x * drop / (self.speed * at.duration);
        let value = mu * phi.value + self.viscous * v;
        let by_slip = at.pressure * (mu * phi.slope + mu_by_slip * phi.value + self.viscous / at.duration);
        FrictionStress { value: at.pressure * value, by_pressure: value, by_slip }
    }

    fn largest_coefficient(&self) -> f64 {
        self.at_rest.max(self.sliding)
    }
}
