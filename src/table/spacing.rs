//! Linear and logarithmic spacing of values.

/// Linear or logarithmic.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal differences are equally far apart.
    #[default]
    Even,
    /// Equal ratios are equally far apart, of values above 0.
    Logarithmic,
}

impl Spacing {
    /// Logarithmic if the flag is set.
    pub fn of(is_log: bool) -> Self {
        if is_log { Self::Logarithmic } else { Self::Even }
    }

    /// True if logarithmic.
    pub fn is_logarithmic(self) -> bool {
        self == Self::Logarithmic
    }

    /// Position of a value on the axis: its logarithm to base 10 if logarithmic.
    pub fn place(self, value: f64) -> f64 {
        if self.is_logarithmic() { value.log10() } else { value }
    }

    /// Value at a position on the axis.
    pub fn value(self, place: f64) -> f64 {
        if self.is_logarithmic() { 10_f64.powf(place) } else { place }
    }

    /// Value at a share of the way between two ends, exact at the ends.
    pub fn between(self, [from, to]: [f64; 2], share: f64) -> f64 {
        if self.is_logarithmic() { from * (to / from).powf(share) } else { from + share * (to - from) }
    }

    /// Share of the way between two ends \[–\].
    pub fn share(self, [from, to]: [f64; 2], value: f64) -> f64 {
        if self.is_logarithmic() { (value / from).ln() / (to / from).ln() } else { (value - from) / (to - from) }
    }
}
