//! Results of a tension test of a sheet, computed from its law.

use super::Entry;

/// Plastic strain of the proof stress \[–\].
const PROOF: f64 = 0.002;

impl Entry {
    /// Proof stress: the law's stress at 0.2 % of plastic strain \[MPa\].
    pub fn proof_stress(&self) -> f64 {
        self.material.hardening.at(PROOF).stress
    }

    /// Tensile strength: force over the initial section at Considère's load maximum \[MPa\]; `None` where the law has none.
    pub fn tensile_strength(&self) -> Option<f64> {
        let strain = self.n()?;
        Some(self.material.hardening.at(strain).stress * (-strain).exp())
    }

    /// Uniform elongation, the change of length over the initial one at Considère's load maximum \[–\]; `None` where the law
    /// has none.
    pub fn uniform_elongation(&self) -> Option<f64> {
        Some(self.n()?.exp_m1())
    }
}
