use super::*;

parameters! {
    /// ∫ (1 + σ_m/(a σ̄)) dε̄ = critical: Oyane's criterion, from the volume of voids at which a metal breaks.
    ///
    /// Valid where voids grow; two tests of different mean stress fit it. Source: M. Oyane, T. Sato, K. Okimoto, S. Shima,
    /// J. Mech. Working Technol. 4 (1980) 65–81 (abstract read; the form is in common use).
    pub struct Oyane {
        /// a; many take 0.424, of R. Hambli and M. Reszka, Int. J. Mech. Sci. 44 (2002) 1349–1361 (not read).
        pub a: "As::<Positive<Number>>" = 0.424,
        /// C.
        pub critical: "As::<Positive<Number>>" = 1.0,
    }
}

impl FractureCriterion for Oyane {
    fn formula(&self) -> String {
        format!("∫ (1 + σ_m/({} σ̄)) dε̄ = {}", self.a, self.critical)
    }

    fn at(&self, stress: FractureStress) -> f64 {
        (1.0 + stress.mean / (self.a * stress.equivalent)).max(0.0) / self.critical
    }
}
