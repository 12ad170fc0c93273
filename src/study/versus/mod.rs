//! Several runs, and what was measured, side by side.
//!
//! ```text
//! Candidate     a case, as it stands or with overrides of its own
//! Measured      curves of a CSV file
//! Asked         all of them, checked to have something in common, each named by what sets it apart
//! Versus        what came of the runs, with their error bars
//! Compared      a number of all runs, and what of the differences is more than error
//! Line          a row of the table as it is told
//! ```

mod candidate;
mod difference;
mod measured;
mod misfit;
mod names;
mod telling;

pub use candidate::Candidate;
pub use difference::{Change, Compared};
pub use measured::{Curve, Measured, Of};
pub use misfit::Misfit;
pub use telling::{COLUMNS, Line, Said};

use super::{StudyError, Subject, side_by_side};
use crate::assess::{self, Light};
use crate::case::Solution;
use crate::study::verify::{Number, Outcome, Verification, Watch, answered, quick};
use crate::units::joined;
use std::convert::Infallible;

/// What is to be compared: cases and measurements that fit each other.
#[derive(Clone, Debug)]
pub struct Asked {
    candidates: Vec<Candidate>,
    names: Vec<String>,
    measured: Vec<Measured>,
}

/// One of the runs that are compared.
#[derive(Clone, Debug)]
pub struct Member {
    /// Its letter in tables and legends: `A`, `B`, ...
    pub mark: String,
    /// What sets it apart from the others: `friction 0.12`, or the name of its case.
    pub name: String,
    /// What was run, and what came out.
    pub solution: Solution,
    /// The error bars of its numbers.
    pub verification: Verification,
    /// The worst light of its verdict, which minds the error bars.
    pub light: Light,
    /// Labels of the verdict's rows that are red, and of those that are amber.
    pub red: Vec<&'static str>,
    /// See `red`.
    pub amber: Vec<&'static str>,
}

/// Runs and measurements side by side.
#[derive(Clone, Debug)]
pub struct Versus {
    /// In the order in which they were asked for; differences are against the first.
    pub members: Vec<Member>,
    /// What was measured.
    pub measured: Vec<Measured>,
}

impl Asked {
    /// Of cases and measurements.
    ///
    /// # Errors
    /// When there is nothing to compare with, one is there twice, their forces are not of one kind, or a measured curve has
    /// no counterpart in any run.
    pub fn new(candidates: Vec<Candidate>, measured: Vec<Measured>) -> Result<Self, StudyError> {
        candidate::check(&candidates)?;
        if candidates.len() + measured.len() < 2 || candidates.is_empty() {
            let help = "give another case, a variant such as --also \"friction=0.12\", or a curve.csv";
            return Err(StudyError::new("there is nothing to compare with: one is not enough", help));
        }
        for curves in &measured {
            curves.check(&candidates)?;
        }
        let names = names::of(&candidates);
        Ok(Self { candidates, names, measured })
    }

    /// How many runs that are.
    pub fn count(&self) -> usize {
        self.candidates.len()
    }

    /// Every file that is read: nothing may be written over them.
    pub fn inputs(&self) -> Vec<std::path::PathBuf> {
        let of_cases = self.candidates.iter().flat_map(|candidate| candidate.case.inputs.iter().cloned());
        of_cases.chain(self.measured.iter().map(|curves| curves.path.clone())).collect()
    }

    /// Runs all cases on so many threads, but for the first where that is `known`, each with quick error bars. Once `watch`
    /// wants to stop, those after it are missing.
    ///
    /// # Errors
    /// When a mistake of this program ends a run.
    pub fn solve(
        self,
        known: Option<(Solution, Verification)>,
        threads: usize,
        watch: &dyn Watch,
    ) -> Result<Versus, StudyError> {
        let begun = usize::from(known.is_some());
        let mut solved: Vec<_> = known.into_iter().collect();
        let mut wrong = None;
        let one = |candidate: &Candidate| {
            let solution = Subject::solution(candidate.case.clone(), watch)?;
            let verification = quick(&solution, &Unheard(watch));
            Ok((solution, verification))
        };
        let each = |result: Result<_, String>| {
            match result {
                Ok(pair) => solved.push(pair),
                Err(why) => wrong = wrong.take().or(Some(why)),
            }
            Ok::<_, Infallible>(())
        };
        let Ok(()) = side_by_side(&self.candidates[begun..], threads, watch, one, each);
        if let Some(why) = wrong {
            return Err(StudyError::new(format!("a case cannot be run: {why}"), "try `stampflow check` on each"));
        }
        let named = self.names.into_iter().enumerate();
        let members = named.zip(solved).map(|((i, name), (solution, verification))| {
            let (_, findings) = answered(&solution, Some(&verification));
            let rows = || assess::judgements(&findings);
            let of = |light: Light| rows().filter(|row| row.light == light).map(|row| row.label).collect();
            let light = rows().map(|row| row.light).max().unwrap_or(Light::Grey);
            let mark = mark(i);
            Member { mark, name, red: of(Light::Red), amber: of(Light::Amber), solution, verification, light }
        });
        Ok(Versus { members: members.collect(), measured: self.measured })
    }
}

/// Counts no runs of its own.
struct Unheard<'a>(&'a dyn Watch);

impl Watch for Unheard<'_> {
    fn wants_to_stop(&self) -> bool {
        self.0.wants_to_stop()
    }
}

/// A letter, or beyond them a number.
fn mark(i: usize) -> String {
    (b'A'..=b'Z').nth(i).map_or_else(|| (i + 1).to_string(), |letter| char::from(letter).to_string())
}

impl Member {
    /// Mark and name: `B: friction 0.12`.
    pub fn label(&self) -> String {
        joined([String::from(self.mark.clone()), self.name.clone()], ": ")
    }

    /// Its numbers, its curves, and how it ended.
    pub fn outcome(&self) -> &Outcome {
        &self.verification.outcomes[0]
    }

    /// A number of its own, and half its error bar where there is one.
    pub fn number(&self, number: &Number) -> Option<(Number, Option<f64>)> {
        let bar = self.verification.bars.iter().find(|bar| bar.number.is(number))?;
        Some((bar.number.clone(), bar.half))
    }
}
