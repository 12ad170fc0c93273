use super::*;

parameters! {
    /// ∫ max(σ₁, 0)/σ̄ dε̄ = critical: the normalised criterion of Cockcroft and Latham.
    ///
    /// Valid for tension-dominated forming; the critical value holds for the sheet, and for the element size, that it was fitted with.
    /// Source: M. G. Cockcroft, D. J. Latham, J. Inst. Metals 96 (1968) 33 (not read); normalised as in UMMDp (read).
    pub struct CockcroftLatham {
        /// C, of a tension test the equivalent strain at fracture.
        pub critical: "As::<Positive<Number>>" = 0.6,
    }
}

impl FractureCriterion for CockcroftLatham {
    fn formula(&self) -> String {
        format!("∫ max(σ₁, 0)/σ̄ dε̄ = {}", self.critical)
    }

    fn at(&self, stress: FractureStress) -> f64 {
        stress.largest.max(0.0) / stress.equivalent / self.critical
    }
}
