//! How sure what is estimated from a sample is: intervals of 95 % from its independent scramblings.
//!
//! Points of one scrambling know of each other, so that their number says little about the error of a mean; scramblings do
//! not. What is estimated from all but one of them, for each, gives the variance (the jackknife of groups), and Student's t
//! the interval.
//!
//! # References
//! A. B. Owen, Monte Carlo theory, methods and examples (2013), chapter 17 (not read: intervals from replicates);
//! E. B. Wilson, Probable inference, the law of succession, and statistical inference, J. Am. Stat. Assoc. 22 (1927) 209–212
//! (not read: the interval of a share); E. L. Korn, B. I. Graubard, Confidence intervals for proportions with small expected
//! number of positive counts, Survey Methodology 24 (1998) 193–201 (not read: such an interval with the number of tries that
//! independent points would need).

use super::sampling::REPLICATES;
use statrs::distribution::{ContinuousCDF, StudentsT};

/// Share of intervals that hold the truth.
pub const CONFIDENCE: f64 = 0.95;

/// A number with its interval of [`CONFIDENCE`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The estimate.
    pub value: f64,
    /// The lower end of its interval.
    pub low: f64,
    /// The upper end.
    pub high: f64,
}

/// Estimates from all scramblings, `of` giving the estimate without one of them or, by `None`, from all; `None` where there
/// is none.
pub fn jackknife(of: impl Fn(Option<usize>) -> Option<f64>) -> Option<Estimate> {
    let value = of(None)?;
    let half = students_t() * variance(&of)?.sqrt();
    Some(Estimate { value, low: value - half, high: value + half })
}

/// The jackknife's variance of an estimate.
fn variance(of: &impl Fn(Option<usize>) -> Option<f64>) -> Option<f64> {
    let without: Vec<f64> = (0..REPLICATES).map(|one| of(Some(one))).collect::<Option<_>>()?;
    let count = without.len() as f64;
    let mean = without.iter().sum::<f64>() / count;
    Some((count - 1.0) / count * without.iter().map(|value| (value - mean).powi(2)).sum::<f64>())
}

/// Hits and tries of a scrambling.
pub type Tries = (u64, u64);

/// The probability of an event with its interval; `None` where no scrambling but one has a try.
///
/// Wilson's interval with as many independent tries as would have the variance that the scramblings show, and Student's t; no
/// narrower than what one who has seen none in all tries may say, ln 40/n, for scramblings can agree by chance.
pub fn probability(tries: &[Tries; REPLICATES]) -> Option<Estimate> {
    let share = |without: Option<usize>| {
        let kept = || tries.iter().enumerate().filter(|(i, _)| Some(*i) != without).map(|(_, own)| own);
        let all = kept().map(|own| own.1).sum::<u64>();
        (all > 0).then(|| kept().map(|own| own.0).sum::<u64>() as f64 / all as f64)
    };
    let all = tries.iter().map(|own| own.1).sum::<u64>() as f64;
    let (value, variance) = (share(None)?, variance(&share)?);
    let (low, high) = match variance > 0.0 {
        true => wilson(value, value * (1.0 - value) / variance, students_t()),
        false => (value, value),
    };
    let least = (0.5 * (1.0 - CONFIDENCE)).recip().ln() / all;
    Some(Estimate { value, low: low.min(value - least).max(0.0), high: high.max(value + least).min(1.0) })
}

/// The interval of a share of so many independent tries, as wide as so many standard deviations.
fn wilson(share: f64, tries: f64, deviations: f64) -> (f64, f64) {
    let square = deviations * deviations / tries;
    let middle = (share + 0.5 * square) / (1.0 + square);
    let half = (square * (share * (1.0 - share) + 0.25 * square)).sqrt() / (1.0 + square);
    (middle - half, middle + half)
}

/// Student's t of the interval with one degree of freedom fewer than there are scramblings.
fn students_t() -> f64 {
    let law = StudentsT::new(0.0, 1.0, REPLICATES as f64 - 1.0).expect("more than one scrambling");
    law.inverse_cdf(0.5 * (1.0 + CONFIDENCE))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: tables of Student's distribution, and Wilson's interval of 3 of 20 in textbooks (0.0524, 0.3604).
    #[test]
    fn quantiles_are_those_of_tables() {
        assert_relative_eq!(students_t(), 2.131_45, max_relative = 1e-5);
        let (low, high) = wilson(0.15, 20.0, 1.959_964);
        assert_relative_eq!(low, 0.0524, max_relative = 2e-3);
        assert_relative_eq!(high, 0.3604, max_relative = 2e-3);
    }

    /// Trust: none in n independent tries has a chance of 0.025 where the probability is 1 − 0.025^(1/n), ln 40/n for many.
    #[test]
    fn none_in_all_tries_is_not_never() {
        let never = probability(&[(0, 100); REPLICATES]).expect("tries");
        assert_eq!((never.value, never.low), (0.0, 0.0));
        assert_relative_eq!(never.high, 1.0 - 0.025f64.powf(1.0 / 1600.0), max_relative = 2e-3);
        assert!(probability(&[(0, 0); REPLICATES]).is_none());
    }
}
