//! The last value of a variable with a positive sign, or a zero crossing: a scan, then division of the bracket.
//!
//! Trials of a round are independent; rounds follow from all before. A failed one is neither positive nor negative.

use super::variable::SearchRange;
use crate::plot::Spacing;
use crate::units::significant;

/// End of the range, or which of several crossings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The smallest value.
    Smallest,
    /// The largest value.
    Largest,
}

/// A trial: its value, and its sign and size; `None` if it failed.
pub(super) type Trial = (f64, Option<f64>);

/// Result of a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bracket {
    /// The sign changes between these two; the first is the positive one of a limit.
    Between([f64; 2]),
    /// Positive up to this end of the range.
    Everywhere(f64),
    /// Nowhere positive, or no crossing.
    Nowhere,
    /// Positive here; beyond it every trial failed.
    Open(f64),
    /// Every trial failed.
    Failed,
}

const PLACES: usize = 9;
/// Default tolerance over the range \[–\].
const TOLERANCE: f64 = 0.005;
const AT_ONCE: usize = 3;
/// Distance of the two trials that close in on a secant's zero, over the bracket \[–\].
const CLOSE: f64 = 0.05;
const ROUNDS: usize = 40;

#[derive(Clone, Debug)]
pub(super) struct Search {
    pub range: SearchRange,
    /// Wanted width of the bracket; a share of the range by default.
    pub tolerance: Option<f64>,
    /// Last positive value, else a zero crossing.
    pub is_limit: bool,
    pub side: Side,
}

impl Search {
    fn tolerance(&self, x: f64) -> f64 {
        let SearchRange { ends: [low, high], spacing, .. } = self.range;
        self.tolerance.unwrap_or_else(|| match spacing {
            Spacing::Logarithmic => x * ((high / low).ln() * TOLERANCE).exp_m1(),
            Spacing::Even => TOLERANCE * (high - low),
        })
    }

    /// Value at a share of the range, rounded to the decimal below half the tolerance.
    pub fn at(&self, share: f64) -> f64 {
        let SearchRange { ends: [low, high], spacing, .. } = self.range;
        if share <= 0.0 || share >= 1.0 {
            return if share <= 0.0 { low } else { high };
        }
        let x = spacing.between([low, high], share);
        let step = 10f64.powf((0.5 * self.tolerance(x)).log10().floor());
        significant((x / step).round() * step, 12).clamp(low, high)
    }

    pub fn share(&self, x: f64) -> f64 {
        self.range.spacing.share(self.range.ends, x)
    }

    pub fn next(&self, trials: &[Trial]) -> Vec<f64> {
        let even = |n: usize| (0..n).map(|i| i as f64 / (n - 1) as f64).collect::<Vec<_>>();
        let places = self.range.count.unwrap_or(PLACES).max(3);
        let scan = self.untried(trials, &even(places));
        if !scan.is_empty() {
            return scan;
        }
        let Bracket::Between(bracket) = self.result(trials) else {
            // The condition may hold only between two of the first places.
            return self.untried(trials, &even(2 * places - 1));
        };
        let width = (bracket[1] - bracket[0]).abs();
        if width <= self.tolerance(bracket[0]) * (1.0 + 1e-9) || trials.len() > places + ROUNDS * AT_ONCE {
            return Vec::new();
        }
        let [from, to] = bracket.map(|x| self.share(x));
        let part = |i: usize| from + (to - from) * i as f64 / (AT_ONCE + 1) as f64;
        let mut shares: Vec<f64> = (1..=AT_ONCE).map(part).collect();
        let [a, b] = bracket.map(|x| trials.iter().find(|trial| trial.0 == x).and_then(|trial| trial.1));
        let secant = a.zip(b).map(|(a, b)| from + (to - from) * a / (a - b));
        if let Some(zero) = secant.filter(|zero| zero.is_finite() && !self.is_limit) {
            let close = CLOSE * (to - from);
            shares.splice(..2, [zero - close, zero + close].map(|share| share.clamp(from.min(to), from.max(to))));
        }
        self.untried(trials, &shares)
    }

    pub fn result(&self, trials: &[Trial]) -> Bracket {
        let mut sorted: Vec<Trial> = trials.to_vec();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        if self.side == Side::Smallest {
            sorted.reverse();
        }
        let end = sorted.last().map(|trial| trial.0);
        let known: Vec<(f64, bool)> = sorted.iter().filter_map(|(x, value)| Some((*x, (*value)? >= 0.0))).collect();
        let Some(&(last, holds)) = known.last() else { return Bracket::Failed };
        // Bisection towards the positive trial that is nearest to the side.
        match known.windows(2).rfind(|pair| pair[0].1 != pair[1].1 && (!self.is_limit || pair[0].1)) {
            _ if self.is_limit && holds && end == Some(last) => Bracket::Everywhere(last),
            _ if self.is_limit && holds => Bracket::Open(last),
            Some(pair) => Bracket::Between([pair[0].0, pair[1].0]),
            None => Bracket::Nowhere,
        }
    }

    fn untried(&self, trials: &[Trial], shares: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::new();
        for x in shares.iter().map(|share| self.at(*share)) {
            values.extend((!values.contains(&x) && !trials.iter().any(|(tried, _)| *tried == x)).then_some(x));
        }
        values
    }
}
