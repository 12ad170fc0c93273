//! The instant at which a run ends, which seldom falls on the end of a step.
//!
//! The excess over the rule that ends the run is negative at the last accepted state and not negative where a step has
//! overstepped the end. That step is repeated, as far as the line between the two comes to nothing; a repeated step that
//! stops short is accepted and the search goes on from there. Where one side is hit twice running, the excess of the other
//! counts half, so that a bent curve, or a jump, is closed in from both sides: the rule of Illinois.
//!
//! # References
//! M. Dowell, P. Jarratt, BIT 11 (1971) 168–174 (not read); the rule is in common use.

/// Share of the step that first went beyond the end by which the run may do so in the end \[–\].
const TOLERANCE: f64 = 1e-3;

/// A time at which the run was over \[s\], the excess there \[–\], and the time by which it may be too late \[s\].
#[derive(Clone, Copy, Debug)]
struct Over {
    time: f64,
    excess: f64,
    tolerance: f64,
}

/// The search for the end, from the first step that goes beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct EndSearch {
    /// Excess at the last accepted state \[–\]: negative.
    before: f64,
    over: Option<Over>,
    /// Whether the last repeated step stopped short.
    short: bool,
    /// Shortest time that is told apart \[s\].
    smallest: f64,
}

impl EndSearch {
    /// At the start of a run; times below `smallest` \[s\] are not told apart.
    pub fn new(smallest: f64) -> Self {
        Self { before: -1.0, over: None, short: false, smallest }
    }

    /// Length of the step from `time` that ends where the run is expected to, or a little beyond \[s\]; `None` before a step
    /// has gone beyond.
    pub fn step(&self, time: f64) -> Option<f64> {
        let over = self.over.as_ref()?;
        let rest = over.time - time;
        Some((rest - late(self.before, over.excess, rest) + 0.5 * over.tolerance).min(rest))
    }

    /// Takes notice of the excess after a step of `dt` from `time` \[s\]; `true` where the step is to be repeated shorter.
    pub fn look(&mut self, time: f64, dt: f64, excess: f64) -> bool {
        if excess < 0.0 {
            self.before = excess;
            let twice = self.short;
            self.short = self.over.is_some();
            // Another path, in other steps, may come to the end later.
            self.over = self.over.filter(|over| time + dt < over.time);
            if let Some(over) = self.over.as_mut().filter(|_| twice) {
                over.excess *= 0.5;
            }
            return false;
        }
        let first = TOLERANCE * dt;
        let tolerance = self.over.map_or(first.max(self.smallest), |over| over.tolerance);
        if late(self.before, excess, dt) <= tolerance {
            return false;
        }
        if self.over.is_some() && !self.short {
            self.before *= 0.5;
        }
        self.short = false;
        self.over = Some(Over { time: time + dt, excess, tolerance });
        true
    }
}

/// Time by which the end of `dt` \[s\] lies beyond the root of the line from `before` < 0 to `excess` ≥ 0 \[s\].
fn late(before: f64, excess: f64, dt: f64) -> f64 {
    dt * excess / (excess - before)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Goes along a curve in steps of 0.3 s until its end is found; the instant, and the steps that were repeated.
    fn find(excess: impl Fn(f64) -> f64) -> (f64, usize) {
        let (mut search, mut time, mut repeated) = (EndSearch::new(1e-9), 0.0, 0);
        loop {
            let dt = search.step(time).unwrap_or(0.3);
            if search.look(time, dt, excess(time + dt)) {
                repeated += 1;
                continue;
            }
            time += dt;
            if excess(time) >= 0.0 {
                return (time, repeated);
            }
        }
    }

    /// Trust: the instants are given; they are found to a thousandth of the step, from above, in a handful of tries, a jump
    /// in no more than halving takes, with a few to spare.
    #[test]
    fn the_instant_is_found_from_above_within_a_thousandth_of_the_step() {
        type Curve = fn(f64, f64) -> f64;
        let end = std::f64::consts::FRAC_1_SQRT_2;
        let curves: [(Curve, usize); 4] = [
            (|t, end| t / end - 1.0, 1),
            (|t, end| (t / end).powi(8) - 1.0, 8),
            (|t, end| 1.0 - (end / t).powi(8), 8),
            (|t, end| if t < end { -1.0 } else { 3.0 }, 16),
        ];
        for (curve, most) in curves {
            let (found, repeated) = find(|t| curve(t, end));
            assert!((0.0..1.5e-3 * 0.3).contains(&(found - end)), "{found} {end}");
            assert!((1..=most).contains(&repeated), "{repeated}");
        }
    }

    /// An end that a step meets is no reason to repeat it.
    #[test]
    fn a_step_that_ends_at_the_end_is_kept() {
        assert!(!EndSearch::new(1e-9).look(0.0, 0.3, 0.0));
    }
}
