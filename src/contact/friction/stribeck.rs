//! Kinematic friction: the coefficient depends on the sliding speed, in Stribeck's form.

use super::{Drag, Sliding, direction};

/// τ = p \[(μ_k + (μ_s − μ_k) exp(−(v/v_s)²)) φ(s) + c v\] with the sliding speed v = s/Δt.
///
/// # References
/// The Gaussian form in common use (as in MathWorks, Simscape, Translational Friction, but for its smoothing); not read:
/// B. Armstrong-Hélouvry, P. Dupont, C. Canudas de Wit, A survey of models, analysis tools and compensation methods for
/// the control of machines with friction, Automatica 30 (1994) 1083–1138.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stribeck {
    /// μ_s of the slowest sliding \[–\].
    pub at_rest: f64,
    /// μ_k of fast sliding \[–\].
    pub sliding: f64,
    /// Stribeck's speed v_s \[mm/s\].
    pub speed: f64,
    /// c \[s/mm\].
    pub viscous: f64,
}

impl Stribeck {
    /// The coefficient at the speed `v` ≥ 0 \[mm/s\], regularisation aside.
    pub fn coefficient(&self, v: f64) -> f64 {
        self.sliding + (self.at_rest - self.sliding) * (-(v / self.speed).powi(2)).exp() + self.viscous * v
    }

    /// The friction stress and its derivatives.
    #[inline]
    pub fn at(&self, at: &Sliding) -> Drag {
        let phi = direction(at.slip, at.scale);
        let v = at.slip / at.duration;
        let x = v / self.speed;
        let drop = (self.at_rest - self.sliding) * (-x * x).exp();
        let mu = self.sliding + drop;
        let mu_by_slip = -2.0 * x * drop / (self.speed * at.duration);
        let value = mu * phi.value + self.viscous * v;
        Drag {
            value: at.pressure * value,
            by_pressure: value,
            by_slip: at.pressure * (mu * phi.slope + mu_by_slip * phi.value + self.viscous / at.duration),
        }
    }

    /// The law in words and numbers.
    pub fn describe(&self) -> String {
        let viscous =
            if self.viscous == 0.0 { String::new() } else { format!(", + {} s/mm times the speed", self.viscous) };
        format!("{} at rest, {} sliding well beyond {} mm/s{viscous}", self.at_rest, self.sliding, self.speed)
    }
}
