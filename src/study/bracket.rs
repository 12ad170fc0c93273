//! The last value of a variable with a positive sign, or a zero crossing: a scan, then division of the bracket.
//!
//! It knows nothing of cases. Trials of a round are independent of each other; each round follows from all before, so that a
//! search is resumed from its trials. A trial that failed is neither positive nor negative.

/// End of the range, or which of several crossings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The smallest value.
    Smallest,
    /// The largest value.
    Largest,
}

/// Object of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// Last value, on that side, with a positive sign.
    Limit(Side),
    /// Zero crossing nearest to that side.
    Crossing(Side),
}

/// A trial: its value, and its sign and size; `None` where it failed.
pub type Trial = (f64, Option<f64>);

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

/// Trials of one round that divide a bracket.
const AT_ONCE: usize = 3;
/// Distance of the two trials that close in on a secant's zero, over the bracket \[–\].
const CLOSE: f64 = 0.05;
/// Most rounds of division.
const ROUNDS: usize = 40;

/// A range and how it is searched.
pub struct Search<'a> {
    /// Value at a share of the way, rounded.
    pub at: &'a dyn Fn(f64) -> f64,
    /// Share of the way at a value.
    pub share: &'a dyn Fn(f64) -> f64,
    /// Wanted width of the bracket at a value.
    pub tolerance: &'a dyn Fn(f64) -> f64,
    /// Trials of the scan.
    pub places: usize,
    /// Its object.
    pub aim: Aim,
}

impl Search<'_> {
    /// Values of the next round; empty when the search is over.
    pub fn next(&self, trials: &[Trial]) -> Vec<f64> {
        let even = |n: usize| (0..n).map(|i| i as f64 / (n - 1) as f64).collect::<Vec<_>>();
        let scan = self.untried(trials, &even(self.places));
        if !scan.is_empty() {
            return scan;
        }
        let Bracket::Between(bracket) = self.result(trials) else {
            // A stretch may lie between the first places.
            return self.untried(trials, &even(2 * self.places - 1));
        };
        let [from, to] = bracket.map(|x| (self.share)(x));
        let width = (bracket[1] - bracket[0]).abs();
        if width <= (self.tolerance)(bracket[0]) * (1.0 + 1e-9) || trials.len() > self.places + ROUNDS * AT_ONCE {
            return Vec::new();
        }
        let part = |i: usize| from + (to - from) * i as f64 / (AT_ONCE + 1) as f64;
        let mut shares: Vec<f64> = (1..=AT_ONCE).map(part).collect();
        if let (Aim::Crossing(_), Some(zero)) = (self.aim, self.secant(trials, bracket)) {
            let close = CLOSE * (to - from);
            let clamp = |share: f64| share.clamp(from.min(to), from.max(to));
            shares.splice(..2, [clamp(zero - close), clamp(zero + close)]);
        }
        self.untried(trials, &shares)
    }

    /// Result of some trials.
    pub fn result(&self, trials: &[Trial]) -> Bracket {
        let (Aim::Limit(side) | Aim::Crossing(side)) = self.aim;
        let mut sorted: Vec<Trial> = trials.to_vec();
        sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
        if side == Side::Smallest {
            sorted.reverse();
        }
        let end = sorted.last().map(|trial| trial.0);
        let known: Vec<(f64, bool, f64)> =
            sorted.iter().filter_map(|(x, value)| value.map(|value| (*x, value >= 0.0, value))).collect();
        let Some(last) = known.last() else { return Bracket::Failed };
        let is_limit = matches!(self.aim, Aim::Limit(_));
        // Bisection towards the positive trial that is nearest to the side.
        let change = known.windows(2).rfind(|pair| pair[0].1 != pair[1].1 && (!is_limit || pair[0].1));
        match change {
            Some(pair) if !(is_limit && last.1) => Bracket::Between([pair[0].0, pair[1].0]),
            _ if is_limit && last.1 && end == Some(last.0) => Bracket::Everywhere(last.0),
            _ if is_limit && last.1 => Bracket::Open(last.0),
            _ => Bracket::Nowhere,
        }
    }

    /// Stretches on which a condition holds, as first and last value.
    pub fn stretches(trials: &[Trial]) -> Vec<[f64; 2]> {
        let mut known: Vec<(f64, f64)> = trials.iter().filter_map(|(x, value)| Some((*x, (*value)?))).collect();
        known.sort_by(|a, b| a.0.total_cmp(&b.0));
        let stretches = known.chunk_by(|a, b| (a.1 >= 0.0) == (b.1 >= 0.0)).filter(|stretch| stretch[0].1 >= 0.0);
        stretches.map(|stretch| [stretch[0].0, stretch[stretch.len() - 1].0]).collect()
    }

    /// Share of the way of a linear zero in a bracket.
    fn secant(&self, trials: &[Trial], bracket: [f64; 2]) -> Option<f64> {
        let value = |x: f64| trials.iter().find(|trial| trial.0 == x)?.1;
        let (a, b) = (value(bracket[0])?, value(bracket[1])?);
        let [from, to] = bracket.map(|x| (self.share)(x));
        Some(from + (to - from) * a / (a - b)).filter(|share| share.is_finite())
    }

    fn untried(&self, trials: &[Trial], shares: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::new();
        for x in shares.iter().map(|share| (self.at)(*share)) {
            if !values.contains(&x) && !trials.iter().any(|(tried, _)| *tried == x) {
                values.push(x);
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn search(aim: Aim, of: &dyn Fn(f64) -> Option<f64>) -> (Bracket, Vec<Trial>) {
        let search = Search { at: &|s| 10.0 * s, share: &|x| 0.1 * x, tolerance: &|_| 0.01, places: 9, aim };
        let mut trials: Vec<Trial> = Vec::new();
        loop {
            let next = search.next(&trials);
            if next.is_empty() {
                return (search.result(&trials), trials);
            }
            trials.extend(next.into_iter().map(|x| (x, of(x))));
        }
    }

    /// Trust: limits and roots by construction.
    #[test]
    fn limits_and_roots_are_bracketed() {
        let limit = |x: f64| Some(if x <= 6.37 { 1.0 } else { -1.0 });
        let (found, trials) = search(Aim::Limit(Side::Largest), &limit);
        let Bracket::Between([inner, outer]) = found else { panic!("{found:?}") };
        assert!(inner <= 6.37 && 6.37 < outer && outer - inner <= 0.0101 && trials.len() < 30, "{found:?}");
        let (found, trials) = search(Aim::Crossing(Side::Smallest), &|x| Some(x * x - 20.0));
        let Bracket::Between([a, b]) = found else { panic!("{found:?}") };
        let root = 20f64.sqrt();
        assert!((a - root) * (b - root) <= 0.0 && (a - b).abs() <= 0.0101 && trials.len() < 21, "{found:?}");
        let island = |x: f64| Some(if (4.0..4.6).contains(&x) { 1.0 } else { -1.0 });
        let (found, _) = search(Aim::Limit(Side::Largest), &island);
        assert!(matches!(found, Bracket::Between([a, b]) if a < 4.6 && b >= 4.6), "{found:?}");
        for (of, expected) in [
            (&(|_| Some(1.0)) as &dyn Fn(f64) -> Option<f64>, Bracket::Everywhere(10.0)),
            (&|_| Some(-1.0), Bracket::Nowhere),
            (&|_| None, Bracket::Failed),
            (&|x: f64| (x < 5.1).then_some(1.0), Bracket::Open(5.0)),
        ] {
            assert_eq!(search(Aim::Limit(Side::Largest), of).0, expected);
        }
        assert_eq!(
            Search::stretches(&[(1.0, Some(1.0)), (2.0, None), (3.0, Some(1.0)), (4.0, Some(-1.0))]),
            [[1.0, 3.0]]
        );
    }
}
