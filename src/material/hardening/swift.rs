use super::flow_stress::{FlowStress, HardeningLaw};
use crate::material::law::prelude::*;

parameters! {
    /// σ = k (offset + ε)^n.
    ///
    /// Valid up to large strains for most steels; it hardens without end.
    /// Source: H. W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1–18.
    pub struct Swift {
        /// K, the stress at a total strain of 1 \[MPa\].
        k: Positive<Stress> = "520 MPa",
        /// Hardening exponent, 0 to 1.
        n: Fraction = 0.22,
        /// Offset strain, 1e-6 to 1.
        offset: Positive<Number> = 0.005,
    }
}

constructor!(Swift { k, n, offset });

impl Law for Swift {
    fn examples() -> Vec<Self> {
        vec![Self { k: 589.0, n: 0.216, offset: 1e-4 }]
    }

    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        let Self { k, n, offset } = *self;
        require("k", k > 0.0 && k.is_finite(), || format!("k must be positive, found {k} MPa"))?;
        require("n", (0.0..=1.0).contains(&n), || format!("n must lie between 0 and 1, found {n}"))?;
        require("offset", (1e-6..=1.0).contains(&offset), || {
            format!("the offset strain must lie between 1e-6 and 1, found {offset:e}; 1e-4 to 1e-2 is usual")
        })
    }

    fn formula(&self) -> String {
        format!("Swift, σ = {} ({} + ε)^{} MPa", rounded(self.k), rounded(self.offset), rounded(self.n))
    }
}

impl HardeningLaw for Swift {
    #[inline]
    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        let total = strain + self.offset;
        let stress = self.k * total.powf(self.n);
        FlowStress { stress, slope: stress * self.n / total }
    }
}
