//! The inner root of Hosford's condition: the stress ratio x whose normal has the strain ratio β.

use super::Hosford;

/// Step over its distances to 0 and to 1 after which x is right to round-off \[–\]: Halley's method is of third order.
const LAST: f64 = 1e-6;
/// Width of a bracket that is round-off \[–\].
const ROUND_OFF: f64 = 2e-16;
/// Ratios of strain increments that are one \[–\]: between them a chord is round-off.
const SAME: f64 = 1e-7;
/// Most iterations of the inner root: halving alone needs fifty.
const MOST: usize = 60;

impl Hosford {
    /// The ratio x whose normal goes with 1 and β, x'(β) or the chord from the carried ratio `w`, and 1/φ²; `sum` is 1 + β,
    /// without the round-off of β.
    pub(super) fn root(&self, beta: f64, sum: f64, w: Option<f64>) -> [f64; 3] {
        let weight = self.quadratic.ratio * sum;
        let start = w.unwrap_or_else(|| self.guess(beta, sum));
        let [first, first_between, mut step] = self.halley(beta, weight, start);
        let (mut low, mut high) = (-1.0, 1.0);
        let (mut x, mut value) = (start, first);
        for _ in 0..MOST {
            if value > 0.0 {
                high = x
            } else {
                low = x
            }
            let next = x - step;
            let settled = step.abs() <= ROUND_OFF.max(LAST * (x * (1.0 - x)).abs());
            x = if settled || next >= low && next <= high { next } else { 0.5 * (low + high) };
            if settled || high - low <= ROUND_OFF {
                break;
            }
            [value, _, step] = self.halley(beta, weight, x);
        }
        let (y, r) = (1.0 - x, self.quadratic.ratio);
        let (own, between) = (self.power.less_two(x.abs()), r * self.power.less_two(y));
        let across = y * between;
        let inverse_square = self.power.inverse_square((1.0 + x * x * own + y * across) * self.inverse_weight);
        let turn = if w.is_some() { -first * sum / (sum + first_between) } else { 0.0 };
        let rate = if turn.abs() > SAME {
            (x - start) / turn
        } else {
            (1.0 + across) / ((self.exponent() - 1.0) * (own + sum * between))
        };
        [x, rate, inverse_square]
    }

    /// Residual, its part that goes with 1 + β, and a step of Halley's method towards the root; Newton's at the ends.
    fn halley(&self, beta: f64, weight: f64, x: f64) -> [f64; 3] {
        let (y, more) = (1.0 - x, self.exponent() - 2.0);
        let (own, between) = (self.power.less_two(x.abs()), weight * self.power.less_two(y));
        let (along, across) = (x * own, y * between);
        let value = along - across - beta;
        // With the bend (a − 2)(own/x − between/y) over own + between.
        let both = own + between;
        let space = x * y * both;
        let newton = value / ((1.0 + more) * both);
        let bend = 0.5 * more * newton * (y * own - x * between);
        let step = if space == 0.0 { newton } else { newton * space / (space - bend) };
        [value, across, step]
    }

    /// Linear between the known ratios of pure shear, tension, plane strain and equi-biaxial stretching: exact for Hill's.
    fn guess(&self, beta: f64, sum: f64) -> f64 {
        let (tension, plane) = (self.quadratic.coupling, self.plane_strain);
        if beta >= 0.0 {
            plane + (1.0 - plane) * beta
        } else if beta >= -tension {
            plane * (1.0 + beta / tension)
        } else {
            sum / (1.0 - tension) - 1.0
        }
    }
}
