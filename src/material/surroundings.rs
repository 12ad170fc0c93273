//! Resistance of a thickness point to flowing faster than its surroundings.
//!
//! ```text
//! g(Δε̄) = 1 + m ln((Δε̄ + Δε̄_f)/(Δε̄_r + Δε̄_f))       on σ_y
//! ```
//!
//! With Δε̄_r the flow of the surroundings: a rate sensitivity that only differences of rate feel.

use super::FlowStress;

/// Rate sensitivity of a thickness point to its surroundings.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Surroundings {
    /// m; 0 where nothing holds the point back \[–\].
    pub exponent: f64,
    /// Δε̄_r of the step \[–\].
    pub increment: f64,
    /// Δε̄_f, below which increments are not told apart; positive where m is \[–\].
    pub floor: f64,
}

impl Surroundings {
    /// A flow stress times g at an increment Δε̄ of the step, by which its slope is.
    pub fn held(&self, yielding: FlowStress, increment: f64) -> FlowStress {
        let Self { exponent, floor, .. } = *self;
        if exponent <= 0.0 {
            return yielding;
        }
        let flow = increment + floor;
        let factor = 1.0 + exponent * (flow / (self.increment + floor)).ln();
        let slope = yielding.slope * factor + yielding.stress * exponent / flow;
        FlowStress { stress: yielding.stress * factor, slope }
    }
}
