//! Root search for the instant at which a run ends.
//!
//! A step that goes beyond is repeated up to the root of the line between the excesses at both ends; where one side is hit twice
//! running, the excess of the other counts half (Illinois variant of regula falsi).
//!
//! Source: M. Dowell, P. Jarratt, BIT 11 (1971) 168–174 (not read).

/// Accepted overshoot over the step that first went beyond the end \[–\].
const TOLERANCE: f64 = 1e-3;

#[derive(Clone, Copy, Debug)]
struct Over {
    /// Time beyond the end \[s\].
    time: f64,
    /// Excess there \[–\].
    excess: f64,
    /// Accepted overshoot \[s\].
    tolerance: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct EndSearch {
    /// Excess at the last accepted state \[–\]: negative.
    before: f64,
    over: Option<Over>,
    short: bool,
    /// Time resolution \[s\].
    smallest: f64,
}

impl EndSearch {
    /// Search with a time resolution \[s\].
    pub fn new(smallest: f64) -> Self {
        Self { before: -1.0, over: None, short: false, smallest }
    }

    /// Length of the step from `time` to just beyond the expected end \[s\]; `None` before a step has gone beyond.
    pub fn step(&self, time: f64) -> Option<f64> {
        let over = self.over.as_ref()?;
        let rest = over.time - time;
        Some((rest - late(self.before, over.excess, rest) + 0.5 * over.tolerance).min(rest))
    }

    /// Records the excess after a step of `dt` from `time` \[s\]; `true` if the step is to be repeated shorter.
    pub fn look(&mut self, time: f64, dt: f64, excess: f64) -> bool {
        if excess < 0.0 {
            self.before = excess;
            let twice = self.short;
            self.short = self.over.is_some();
            self.over = self.over.filter(|over| time + dt < over.time);
            if let Some(over) = self.over.as_mut().filter(|_| twice) {
                over.excess *= 0.5;
            }
            return false;
        }
        let tolerance = self.over.map_or((TOLERANCE * dt).max(self.smallest), |over| over.tolerance);
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

/// Trust: the instant is given; it is found from above within a thousandth of the step, in a handful of repetitions.
#[cfg(test)]
#[test]
fn the_instant_is_found_from_above_within_a_thousandth_of_the_step() {
    let end = std::f64::consts::FRAC_1_SQRT_2;
    let jump = |t: f64| if t < end { -1.0 } else { 3.0 };
    for (curve, most) in [(&(|t: f64| (t / end).powi(8) - 1.0) as &dyn Fn(f64) -> f64, 8), (&jump, 16)] {
        let (mut search, mut time, mut repeated) = (EndSearch::new(1e-9), 0.0, 0);
        while curve(time) < 0.0 {
            let dt = search.step(time).unwrap_or(0.3);
            let again = search.look(time, dt, curve(time + dt));
            repeated += usize::from(again);
            time += if again { 0.0 } else { dt };
        }
        assert!((0.0..1.5e-3 * 0.3).contains(&(time - end)) && (1..=most).contains(&repeated), "{time} {repeated}");
    }
}
