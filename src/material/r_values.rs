//! Width strain over thickness strain in tension, by direction in the sheet, and what follows of it for a drawn cup.

use crate::units::{As, Number, Positive, rounded};
use schemars::JsonSchema;
use serde::Deserialize;

/// r at 0°, 45° and 90° to the rolling direction; r̄ = (r0 + 2 r45 + r90)/4.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Directions")]
pub struct RValues {
    /// Along the rolling direction.
    #[serde(with = "As::<Positive<Number>>")]
    #[schemars(with = "Positive<Number>", example = 0.525)]
    pub r0: f64,
    /// At 45°.
    #[serde(with = "As::<Positive<Number>>")]
    #[schemars(with = "Positive<Number>", example = 0.248)]
    pub r45: f64,
    /// Across the rolling direction.
    #[serde(with = "As::<Positive<Number>>")]
    #[schemars(with = "Positive<Number>", example = 0.429)]
    pub r90: f64,
}

impl RValues {
    /// r̄ = (r0 + 2 r45 + r90)/4, the normal anisotropy (ISO 10113, not read) \[–\].
    pub fn mean(&self) -> f64 {
        rounded(0.25 * (self.r0 + 2.0 * self.r45 + self.r90))
    }

    /// Δr = (r0 − 2 r45 + r90)/2, the planar anisotropy: ears at 0° and 90° where it is positive, at 45° where negative
    /// (ISO 10113, not read) \[–\].
    pub fn planar(&self) -> f64 {
        rounded(0.5 * (self.r0 - 2.0 * self.r45 + self.r90))
    }

    /// Height of the edge of a drawn cup at 0°, 45° and 90° over its mean, along the sheet \[mm\].
    ///
    /// ```text
    /// ΔL(α) = Σ ℓ {exp[−(m_α − m̄) ε_θ] − 1},   m = r/(1 + r),   r_α = r(α + 90°)      over parts with ε_θ < 0
    /// ```
    ///
    /// `parts` has the length ℓ \[mm\] and the logarithmic hoop strain ε_θ of each, as computed with r̄. An estimate: the yield
    /// stress by direction has a share in ears as large, and tension makes them smaller.
    ///
    /// # References
    /// The part of the r-values in: J. W. Yoon, R. E. Dick, F. Barlat, A new analytical theory for earing generated from
    /// anisotropic plasticity, Int. J. Plasticity 27 (2011) 1165–1184 (abstract read; derived here).
    pub fn ears(&self, parts: impl Iterator<Item = (f64, f64)> + Clone) -> [f64; 3] {
        let share = |r: f64| r / (1.0 + r);
        let mean = share(self.mean());
        [self.r90, self.r45, self.r0].map(|r| {
            let more = |(length, hoop): (f64, f64)| length * (-(share(r) - mean) * hoop.min(0.0)).exp_m1();
            parts.clone().map(more).sum()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::RValues;

    const SHEET: RValues = RValues { r0: 0.525, r45: 0.248, r90: 0.429 };

    /// Trust: by hand.
    #[test]
    fn mean_and_planar_anisotropy_are_their_formulas() {
        assert_eq!((SHEET.mean(), SHEET.planar()), (0.3625, 0.229));
    }

    /// Trust: the closed form of a flange drawn into a wall of radius a from a blank of radius b: a part at ρ becomes
    /// (ρ/a)^m long by its own, ∫ (ρ/a)^m dρ = a/(m + 1) [(b/a)^(m+1) − 1], here less that of m̄; summed over 2000 parts,
    /// second order in their length.
    #[test]
    fn ears_of_a_flange_are_those_of_the_closed_form() {
        let (a, b, count) = (30.0_f64, 55.0_f64, 2000);
        let wall = |m: f64| a / (m + 1.0) * ((b / a).powf(m + 1.0) - 1.0);
        let share = |r: f64| r / (1.0 + r);
        let mean = share(SHEET.mean());
        let width = (b - a) / f64::from(count);
        let parts = (0..count).map(|i| {
            let at = a + width * (f64::from(i) + 0.5);
            (width * (at / a).powf(mean), (a / at).ln())
        });
        let found = SHEET.ears(parts);
        for (ear, r) in found.into_iter().zip([SHEET.r90, SHEET.r45, SHEET.r0]) {
            assert!((ear - (wall(share(r)) - wall(mean))).abs() < 1e-5, "{found:?}");
        }
        assert!(found[1] < 0.0 && found[0] > 0.0, "Δr > 0: ears at 0° and 90°");
        // What is stretched along the hoop is not compressed, and makes no ear.
        assert_eq!(SHEET.ears([(10.0, 0.2)].into_iter()), [0.0; 3]);
    }
}
