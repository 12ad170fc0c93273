//! Resistance of a thickness point to flowing faster than its surroundings.
//!
//! ```text
//! g(Δε̄) = 1 + m ln((Δε̄ + Δε̄_f)/(Δε̄_r + Δε̄_f))       on σ_y
//! ```
//!
//! With Δε̄_r what the surroundings flow in a step: a rate sensitivity that only differences of rate feel. A sheet that flows
//! evenly bears what it does without.

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
    /// Multiplies a flow stress and its slope by g at an increment Δε̄ of the step.
    #[inline]
    pub fn hold(&self, yielding: &mut FlowStress, increment: f64) {
        let Self { exponent, floor, .. } = *self;
        if exponent > 0.0 {
            let flow = increment + floor;
            let factor = 1.0 + exponent * (flow / (self.increment + floor)).ln();
            yielding.slope = yielding.slope * factor + yielding.stress * exponent / flow;
            yielding.stress *= factor;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const AROUND: Surroundings = Surroundings { exponent: 0.005, increment: 0.01, floor: 5e-4 };

    /// σ_y of a straight hardening line, held.
    fn held(increment: f64) -> FlowStress {
        let mut yielding = FlowStress { stress: 300.0 + 500.0 * increment, slope: 500.0 };
        AROUND.hold(&mut yielding, increment);
        yielding
    }

    /// Trust: the formula; ten times the rate is 2.3 exponents less the share of the floor.
    #[test]
    fn faster_flow_is_resisted_and_slower_flow_helped() {
        assert_relative_eq!(held(AROUND.increment).stress, 305.0, max_relative = 1e-15);
        assert_relative_eq!(held(0.1).stress, 350.0 * (1.0 + 0.005 * (0.1005_f64 / 0.0105).ln()), max_relative = 1e-15);
        assert!(held(0.001).stress < 300.5);
    }

    /// Trust: central differences over a thousandth of the increment: truncation near 1e-7 of the slope.
    #[test]
    fn the_slope_is_the_derivative() {
        for x in [1e-4, 1e-3, 1e-2, 1e-1] {
            let h = 1e-3 * x;
            let difference = (held(x + h).stress - held(x - h).stress) / (2.0 * h);
            assert_relative_eq!(held(x).slope, difference, max_relative = 1e-6);
        }
    }
}
