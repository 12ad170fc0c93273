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

    /// Δr = (r0 − 2 r45 + r90)/2, the planar anisotropy: ears at 0° and 90° where it is positive, at 45° where negative
    /// (ISO 10113, not read) \[–\].
    pub fn planar(&self) -> f64 {
        rounded(0.5 * (self.r0 - 2.0 * self.r45 + self.r90))
    }
}
