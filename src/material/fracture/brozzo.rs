use super::*;

parameters! {
    /// ∫ 2 σ₁/(3 (σ₁ − σ_m)) dε̄ = critical: Brozzo's criterion, which adds the mean stress to that of Cockcroft and Latham.
    ///
    /// Valid for tension-dominated forming, as theirs. Source: P. Brozzo, B. Deluca, R. Rendina, Proc. 7th Biennial Conf.
    /// IDDRG (1972) (not read); the form as in the user subroutines UMMDp of JANCAE (read).
    pub struct Brozzo {
        /// C, of a tension test the equivalent strain at fracture.
        pub critical: "As::<Positive<Number>>" = 0.6,
    }
}

impl FractureCriterion for Brozzo {
    fn formula(&self) -> String {
        format!("∫ 2 σ₁/(3 (σ₁ − σ_m)) dε̄ = {}", self.critical)
    }

    fn at(&self, stress: FractureStress) -> f64 {
        2.0 / 3.0 * stress.largest.max(0.0) / (stress.largest - stress.mean) / self.critical
    }
}
