use super::*;

parameters! {
    /// 1 + (rate/C)^(1/p), which is Perzyna's law ε̄̇ = C ⟨σ̄/σ_s − 1⟩^p with the fluidity C.
    ///
    /// Valid for the strong rate dependence of mild steel at press speeds and beyond.
    /// Source: in common use; Cowper, Symonds, Brown Univ. (1957), P. Perzyna, Adv. Appl. Mech. 9 (1966) (not read).
    pub struct CowperSymonds {
        /// C \[1/s\].
        pub rate: "As::<Positive<StrainRate>>" = "40 /s",
        /// p.
        pub exponent: "As::<Positive<Number>>" = 5.0,
    }
}

impl RateLaw for CowperSymonds {
    fn formula(&self) -> String {
        format!("[1 + (ε̄̇/{} 1/s)^(1/{})]", self.rate, self.exponent)
    }

    fn at(&self, rate: f64) -> ValueAndSlope {
        let over = (rate / self.rate).powf(1.0 / self.exponent);
        ValueAndSlope { value: 1.0 + over, slope: over / (self.exponent * rate) }
    }
}
