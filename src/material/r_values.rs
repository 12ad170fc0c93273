//! Width strain over thickness strain in tension, by direction in the sheet, and what follows of it for a drawn cup.

use crate::material::law::prelude::*;

parameters! {
    /// r at 0°, 45° and 90° to the rolling direction; r̄ = (r0 + 2 r45 + r90)/4.
    #[schemars(rename = "Directions")]
    pub struct RValues {
        /// Along the rolling direction.
        pub r0: Positive<Number> = 0.525,
        /// At 45°.
        pub r45: Positive<Number> = 0.248,
        /// Across the rolling direction.
        pub r90: Positive<Number> = 0.429,
    }
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
/// Trust: the closed form of a flange drawn into a wall of radius a from a blank of radius b: a part at ρ becomes (ρ/a)^m long
/// by its own, ∫ (ρ/a)^m dρ = a/(m + 1) [(b/a)^(m+1) − 1], here less that of m̄; 2000 parts, second order in their length.
#[test]
fn ears_of_a_flange_are_those_of_the_closed_form() {
    let sheet = RValues { r0: 0.525, r45: 0.248, r90: 0.429 };
    assert_eq!((sheet.mean(), sheet.planar()), (0.3625, 0.229));
    let (a, b, count) = (30.0_f64, 55.0_f64, 2000);
    let wall = |m: f64| a / (m + 1.0) * ((b / a).powf(m + 1.0) - 1.0);
    let share = |r: f64| r / (1.0 + r);
    let mean = share(sheet.mean());
    let width = (b - a) / f64::from(count);
    let places = (0..count).map(|i| a + width * (f64::from(i) + 0.5));
    let ears = sheet.ears(places.map(|at| (width * (at / a).powf(mean), (a / at).ln())));
    for (ear, r) in ears.into_iter().zip([sheet.r90, sheet.r45, sheet.r0]) {
        assert!((ear - (wall(share(r)) - wall(mean))).abs() < 1e-5, "{ears:?}");
    }
    // Metal that is stretched along the hoop makes no ear.
    assert_eq!(sheet.ears([(10.0, 0.2)].into_iter()), [0.0; 3]);
}
