//! How values stand along a line: evenly, or their ratios.

/// Whether equal differences or equal ratios are equally far apart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal differences.
    #[default]
    Even,
    /// Equal ratios, of values above 0.
    Logarithmic,
}

impl Spacing {
    /// Logarithmic where that is so.
    pub fn of(is_log: bool) -> Self {
        if is_log { Self::Logarithmic } else { Self::Even }
    }

    /// Whether equal ratios are equally far apart.
    pub fn is_logarithmic(self) -> bool {
        self == Self::Logarithmic
    }

    /// Where a value stands: at its logarithm to base 10 where ratios count.
    pub fn place(self, value: f64) -> f64 {
        if self.is_logarithmic() { value.log10() } else { value }
    }

    /// The value that stands at a place.
    pub fn value(self, place: f64) -> f64 {
        if self.is_logarithmic() { 10_f64.powf(place) } else { place }
    }

    /// The value at a share of the way from one end to the other, without rounding at the ends.
    pub fn between(self, [from, to]: [f64; 2], share: f64) -> f64 {
        if self.is_logarithmic() { from * (to / from).powf(share) } else { from + share * (to - from) }
    }

    /// The share of the way that a value is at \[–\].
    pub fn share(self, [from, to]: [f64; 2], value: f64) -> f64 {
        if self.is_logarithmic() { (value / from).ln() / (to / from).ln() } else { (value - from) / (to - from) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand.
    #[test]
    fn places_and_shares_lead_back_to_their_values() {
        let (even, log) = (Spacing::of(false), Spacing::of(true));
        assert_eq!((even.place(50.0), log.place(100.0)), (50.0, 2.0));
        assert_eq!((even.between([2.0, 32.0], 0.5), log.between([2.0, 32.0], 0.5)), (17.0, 8.0));
        for spacing in [even, log] {
            for value in [2.0, 5.0, 32.0] {
                let share = spacing.share([2.0, 32.0], value);
                assert!((spacing.between([2.0, 32.0], share) / value - 1.0).abs() < 1e-14);
                assert!((spacing.value(spacing.place(value)) / value - 1.0).abs() < 1e-14);
            }
        }
    }
}
