//! A case with every direction refined on its own.

use super::band::{Band, Curves};
use super::bar::{Bar, Levels};
use super::direction::Direction;
use super::estimate::{Estimate, estimate};
use super::numbers::Of;
use super::outcome::Outcome;
use super::said;
use crate::case::{Case, Solution};
use crate::solver::Observer;
#[cfg(feature = "app")]
use rayon::prelude::*;

/// How many times finer the levels are \[–\].
const LEVELS: [f64; 2] = [2.0, 4.0];

/// Longest that a finer run may take, by what the run as it is took \[s\].
const LONGEST: f64 = 300.0;

/// How far the numbers of a solution can be trusted.
#[derive(Clone, Debug, PartialEq)]
pub struct Verification {
    /// Every number with its bar, in the order of telling.
    pub bars: Vec<Bar>,
    /// Whatever is no small error, a sentence each.
    pub told: Vec<String>,
    /// Every run, the one as it is first.
    pub outcomes: Vec<Outcome>,
    /// Around the punch force \[N, or N/mm\] over the travel \[mm\], of the stage with the largest.
    pub load: Option<Band>,
    /// Around the part's thickness \[mm\] over the initial distance from the axis \[mm\].
    pub thickness: Option<Band>,
}

/// Who looks on while the runs of a verification are solved.
pub trait Watch: Sync {
    /// Whether to end all of them.
    fn wants_to_stop(&self) -> bool {
        false
    }

    /// After `done` of `all` runs.
    fn ran(&self, _done: usize, _all: usize) {}
}

impl Watch for () {}

/// Ends a run when it is to end.
pub(crate) struct Watched<'a>(pub &'a dyn Watch);

impl Observer for Watched<'_> {
    fn wants_to_stop(&mut self) -> bool {
        self.0.wants_to_stop()
    }
}

/// Refines a solved case in every direction on its own; all runs side by side where the crate has threads.
pub fn verify(solution: &Solution, watch: &dyn Watch) -> Verification {
    let base = Outcome::of(solution, None);
    let mut jobs: Vec<(Direction, f64)> =
        Direction::ALL.iter().flat_map(|direction| LEVELS.map(|times| (*direction, times))).collect();
    if base.end.lost {
        jobs.clear();
    }
    let seconds = |(direction, times): &(Direction, f64)| {
        solution.wall.map_or(0.0, |wall| wall.as_secs_f64() * direction.cost(*times))
    };
    let long: Vec<_> = jobs.extract_if(.., |job| seconds(job) > LONGEST).collect();
    jobs.sort_by(|a, b| b.0.cost(b.1).total_cmp(&a.0.cost(a.1)));
    let refined = solved(&solution.case, &jobs, watch);
    if watch.wants_to_stop() {
        return Verification::without(base, &said::interrupted());
    }
    let estimated = |direction: Direction, levels: &[f64]| estimate(levels, direction.order());
    let mut verification = Verification::of(base, refined, tolerance(&solution.case), estimated);
    verification.told.extend(long.iter().map(|job| said::left_out(*job, seconds(job))));
    verification
}

/// To which every step is solved \[–\].
pub(super) fn tolerance(case: &Case) -> f64 {
    case.stages.iter().map(|stage| stage.model.settings.tolerance).fold(0.0, f64::max)
}

/// Runs of a case, each refined in one direction so many times; without those that have nothing to refine.
pub(super) fn solved(case: &Case, jobs: &[(Direction, f64)], watch: &dyn Watch) -> Vec<Outcome> {
    let one = |&(direction, times): &(Direction, f64)| {
        let stages = direction.refined(&case.stages, times)?;
        let case = Case { stages, ..case.clone() };
        Some(Outcome::of(&case.solve(&mut Watched(watch)), Some((direction, times))))
    };
    #[cfg(feature = "app")]
    let all = {
        let done = std::sync::atomic::AtomicUsize::new(0);
        // One after the other as threads are free: the most costly first.
        let one = jobs.iter().enumerate().par_bridge().map(|(i, job)| {
            let outcome = one(job);
            watch.ran(1 + done.fetch_add(1, std::sync::atomic::Ordering::Relaxed), jobs.len());
            (i, outcome)
        });
        let mut all: Vec<(usize, Option<Outcome>)> = one.collect();
        all.sort_by_key(|(i, _)| *i);
        all.into_iter().filter_map(|(_, outcome)| outcome).collect()
    };
    #[cfg(not(feature = "app"))]
    let all = {
        let one = |(i, job): (usize, &(Direction, f64))| {
            let outcome = one(job);
            watch.ran(i + 1, jobs.len());
            outcome
        };
        jobs.iter().enumerate().filter_map(one).collect()
    };
    all
}

impl Verification {
    /// From the run as it is, solved to a tolerance, and the refined ones.
    pub(super) fn of(
        base: Outcome,
        mut refined: Vec<Outcome>,
        tolerance: f64,
        estimate: impl Fn(Direction, &[f64]) -> Estimate + Copy,
    ) -> Self {
        refined.sort_by(|a, b| a.times.total_cmp(&b.times));
        let directions: Vec<(Direction, Vec<&Outcome>)> = Direction::ALL
            .into_iter()
            .chain([Direction::Together])
            .map(|direction| (direction, refined.iter().filter(|o| o.direction == Some(direction)).collect()))
            .filter(|(_, runs): &(_, Vec<&Outcome>)| !runs.is_empty())
            .collect();
        let counted = |runs: &[&Outcome]| -> Vec<Outcome> {
            runs.iter().filter(|run| run.end.is_like(&base.end)).map(|run| (*run).clone()).collect()
        };
        let counted: Vec<(Direction, Vec<Outcome>)> =
            directions.iter().map(|(direction, runs)| (*direction, counted(runs))).collect();

        let mut told = Vec::new();
        if base.end.lost {
            told.push(base.end.why.clone());
        }
        told.extend(refined.iter().filter(|run| run.end.lost).filter_map(said::lost));
        let other = |run: &&Outcome| !run.end.lost && !run.end.is_like(&base.end);
        told.extend(refined.iter().filter(other).filter_map(|run| said::ended_otherwise(&base, run)));
        let all: Vec<Outcome> = [base.clone()].into_iter().chain(refined.iter().cloned()).collect();
        told.extend(said::below_shell_length(&base, &all));

        let differ = refined.iter().any(|run| other(&run));
        let missing = counted.iter().find(|(_, runs)| runs.is_empty()).map(|(direction, _)| said::no_finer(*direction));
        let without = match (base.end.lost || counted.is_empty(), differ, missing) {
            (true, ..) => Some(base.end.why.clone()),
            (_, true, _) => Some(said::ends_differ()),
            (.., missing) => missing,
        };
        let bars = base.numbers.iter().map(|number| match &without {
            Some(why) => Bar::none(number.clone(), why.clone()),
            None => {
                let own = (1.0, Some(number.amount.value));
                let levels = counted.iter().map(|(direction, runs)| Levels {
                    direction: *direction,
                    values: [own].into_iter().chain(runs.iter().map(|run| (run.times, run.value(number)))).collect(),
                });
                Bar::of(number.clone(), &levels.collect::<Vec<_>>(), tolerance, estimate)
            }
        });
        let bars: Vec<Bar> = bars.collect();
        let band = |curve: fn(&Outcome) -> &[(f64, f64)]| {
            let finer = counted
                .iter()
                .map(|(direction, runs)| Curves { direction: *direction, finer: runs.iter().map(curve).collect() });
            let finer: Vec<Curves> = finer.collect();
            Band::around(curve(&base), &finer, estimate).filter(|_| without.is_none())
        };
        let (load, thickness) = (band(|run| &run.load), band(|run| &run.thickness));
        Self { bars, told, outcomes: all, load, thickness }
    }

    /// Verification without bars, and the reason.
    pub(super) fn without(base: Outcome, why: &str) -> Self {
        let bars = base.numbers.iter().map(|number| Bar::none(number.clone(), why.to_owned())).collect();
        Self { bars, told: Vec::new(), outcomes: vec![base], load: None, thickness: None }
    }

    /// The first of the finer runs that came to another end, for a reason of the part's.
    pub(super) fn finer_that_ends_otherwise(&self) -> Option<&Outcome> {
        let (base, refined) = self.outcomes.split_first()?;
        refined.iter().find(|run| run.times > 1.0 && !run.end.lost && !run.end.is_like(&base.end))
    }

    /// The bar of a number.
    pub fn bar(&self, of: Of, key: &str) -> Option<&Bar> {
        self.bars.iter().find(|bar| bar.number.of == of && bar.number.key == key)
    }
}
