//! What is told of fitted keys.

use super::case::CaseFit;
use crate::numerics::least_squares::Ended;
use crate::units::{Amount, Digits};
use crate::units::{Unit, four_digits};

/// Keys that are as closely tied cannot be told apart by the curves \[–\].
const TIED: f64 = 0.95;
/// A key that moves the curves by less over its whole range is not felt: so many times the noise of a run \[–\].
const FELT: f64 = 10.0;

impl CaseFit {
    /// What came out and what the curves cannot tell.
    pub fn sentences(&self) -> Vec<String> {
        let share = |rms: f64| Amount::new(100.0 * rms, Unit::Percent, Digits::Significant(2));
        let [before, after] = self.rms;
        let times = |rms: f64| Amount::new(rms, Unit::None, Digits::Significant(2));
        let mut told = vec![match self.matched.first().is_some_and(|matched| matched.is_weighted) {
            true => format!(
                "Runs miss the curves by {before} standard deviations in the mean at the start, by {after} at the end.",
                before = times(before),
                after = times(after)
            ),
            false => format!(
                "Runs miss the curves by {before} of their mean height at the start, by {after} at the end.",
                before = share(before),
                after = share(after)
            ),
        }];
        told.extend(match self.ended {
            Ended::Found => None,
            Ended::Stopped => Some("It was interrupted: this is the best so far, and intervals are left out.".into()),
            Ended::Steps | Ended::Blind(_) => {
                Some("It was still going down when it was ended: begin again where it is now.".into())
            }
        });
        for (estimate, felt) in self.estimates.all.iter().zip(&self.felt) {
            let key = estimate.key.clone();
            if *felt < FELT * self.noise {
                told.push(format!(
                    "{key} is not felt by these curves: over its whole range they hardly move. Leave it out."
                ));
            } else if let Some(bound) = estimate.pushed {
                told.push(format!("{key} is at its bound, {bound}: the curves want it beyond. Widen the range if that can be, or look for what else is wrong.", bound = format!("{} {}", four_digits(bound), estimate.unit).trim_end()));
            }
        }
        for (i, j, correlation) in self.estimates.alike(TIED) {
            let [first, second] = [i, j].map(|i| self.estimates.all[i].key.clone());
            told.push(format!("{first} and {second} cannot be told apart by these curves: correlation {correlation}. Give one of them, or another curve.", correlation = Amount::new(correlation, Unit::None, Digits::Decimals(2))));
        }
        for matched in &self.matched {
            if matched.left_out > 0 {
                told.push(format!(
                    "{n} of {all} points of {file} are left out: the run at the start ended before them.",
                    n = matched.left_out,
                    all = matched.points.len(),
                    file = matched.name
                ));
            }
        }
        // How many runs it took hangs on round-off, and is in the JSON alone.
        let [_, failed] = self.runs;
        if failed > 0 {
            told.push(format!("{failed} runs failed or ended before the curves do."));
        }
        told
    }
}
