use super::*;

parameters! {
    /// ∫ 0.283 exp(3 σ_m/2σ̄) dε̄ = critical: growth of a round void by Rice and Tracey, ln(R/R₀) at fracture.
    ///
    /// Valid for voids apart from each other in a metal that flows; it falls slowly under pressure. Source: J. R. Rice,
    /// D. M. Tracey, J. Mech. Phys. Solids 17 (1969) (abstract read); the exponential as in UMMDp (read), the factor common.
    pub struct RiceTracey {
        /// C, the logarithm of the void's growth at fracture.
        pub critical: "As::<Positive<Number>>" = 0.3,
    }
}

/// Factor of the void's growth at high mean stress \[–\].
const GROWTH: f64 = 0.283;

impl FractureCriterion for RiceTracey {
    fn formula(&self) -> String {
        format!("∫ {GROWTH} exp(3 σ_m/2σ̄) dε̄ = {}", self.critical)
    }

    fn at(&self, stress: FractureStress) -> f64 {
        GROWTH * (1.5 * stress.mean / stress.equivalent).exp() / self.critical
    }
}
