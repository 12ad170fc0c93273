//! Width strain over thickness strain in tension, by direction in the sheet.

use crate::material::law::prelude::*;

parameters! {
    /// r at 0°, 45° and 90° to the rolling direction; r̄ = (r0 + 2 r45 + r90)/4.
    #[schemars(rename = "Directions")]
    pub struct RValues {
        /// Along the rolling direction.
        pub r0: "As::<Positive<Number>>" = 0.525,
        /// At 45°.
        pub r45: "As::<Positive<Number>>" = 0.248,
        /// Across the rolling direction.
        pub r90: "As::<Positive<Number>>" = 0.429,
    }
}

impl RValues {
    /// r̄ = (r0 + 2 r45 + r90)/4, the normal anisotropy (ISO 10113, not read) \[–\].
    pub fn mean(&self) -> f64 {
        rounded(0.25 * (self.r0 + 2.0 * self.r45 + self.r90))
    }

    /// Planar anisotropy Δr = (r0 − 2 r45 + r90)/2 \[–\], positive with ears at 0° and 90° (ISO 10113, not read).
    pub fn planar(&self) -> f64 {
        rounded(0.5 * (self.r0 - 2.0 * self.r45 + self.r90))
    }

    /// Height of the edge of a drawn cup at 0°, 45° and 90° over its mean, along the sheet \[mm\].
    ///
    /// ```text
    /// ΔL(α) = Σ ℓ {exp[−(m_α − m̄) ε_θ] − 1},   m = r/(1 + r),   r_α = r(α + 90°)      over parts with ε_θ < 0
    /// ```
    ///
    /// `parts` has the length ℓ \[mm\] and the logarithmic hoop strain ε_θ of each, as computed with r̄. Source: J. W. Yoon,
    /// R. E. Dick, F. Barlat, Int. J. Plasticity 27 (2011) 1165–1184 (abstract read; derived here).
    pub fn rim_heights(&self, parts: impl Iterator<Item = (f64, f64)> + Clone) -> [f64; 3] {
        let share = |r: f64| r / (1.0 + r);
        let mean = share(self.mean());
        [self.r90, self.r45, self.r0].map(|r| {
            parts.clone().map(|(length, hoop): (f64, f64)| length * (-(share(r) - mean) * hoop.min(0.0)).exp_m1()).sum()
        })
    }
}
