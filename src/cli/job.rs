//! A case on its way from its file to its results.

use super::progress::Watch;
use rayon::prelude::*;
use stampflow::case::{self, Case};
use stampflow::compare::{CompareError, Comparison, Computed, compare};
use stampflow::output::{Subject, load_travel, profile, remove_stale, write_all, write_comparison};
use stampflow::record::{IterationRecord, Run};
use stampflow::solver;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// A case whose input was found to be in order.
pub struct Job {
    pub case: Case,
    pub overrides: Vec<String>,
}

/// A case with its run.
pub struct Solved {
    job: Job,
    run: Run,
    wall: Duration,
    pub comparisons: Vec<Comparison>,
    pub iterations: Vec<IterationRecord>,
}

impl Job {
    /// Reads a case and the curves that it will be compared with, so that bad input is found before solving.
    pub fn load(path: &Path, overrides: &[String]) -> anyhow::Result<Self> {
        let case = case::load(path, overrides)?;
        compared(&case, &Run::unsolved())?;
        Ok(Self { case, overrides: overrides.to_vec() })
    }

    /// Runs the case under a watch.
    fn solve(self, mut watch: Watch) -> anyhow::Result<Solved> {
        let start = Instant::now();
        let mut run = solver::run(&self.case.model, &mut watch);
        let wall = start.elapsed();
        let iterations = watch.finish(&run);
        run.warnings.extend(case::check::report(&self.case).warnings);
        let comparisons = compared(&self.case, &run)?;
        Ok(Solved { job: self, run, wall, comparisons, iterations })
    }
}

impl Solved {
    /// The name of the case.
    pub fn name(&self) -> &str {
        &self.job.case.name
    }

    /// What outputs are made from.
    pub fn subject(&self) -> Subject<'_> {
        let case = &self.job.case;
        Subject {
            name: &case.name,
            case_text: &case.text,
            overrides: &self.job.overrides,
            derived: &case.derived,
            model: &case.model,
            run: &self.run,
            wall: self.wall,
        }
    }

    /// Writes tables, plots and comparisons.
    pub fn write(&self, dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
        let mut written = write_all(&self.subject(), dir)?;
        written.extend(self.write_comparisons(dir)?);
        remove_stale(dir, &written)?;
        Ok(written)
    }

    /// Writes comparisons only.
    pub fn write_comparisons(&self, dir: &Path) -> anyhow::Result<Vec<PathBuf>> {
        let mut written = Vec::new();
        for (i, comparison) in self.comparisons.iter().enumerate() {
            written.extend(write_comparison(&self.subject(), i + 1, comparison, dir)?);
        }
        Ok(written)
    }
}

/// Solves jobs side by side and hands each to `then` as it ends; what `then` returns comes back in the jobs' order.
pub fn solve_all<T: Send>(
    jobs: Vec<Job>,
    watch: impl Fn(&Case) -> Watch + Sync,
    then: impl Fn(Solved) -> anyhow::Result<T> + Sync,
) -> Vec<anyhow::Result<T>> {
    jobs.into_par_iter()
        .map(|job| {
            let watch = watch(&job.case);
            then(job.solve(watch)?)
        })
        .collect()
}

fn compared(case: &Case, run: &Run) -> Result<Vec<Comparison>, CompareError> {
    let history = load_travel::table(&case.model, run);
    let profile = profile::last(&case.model, &run.frames);
    let computed = Computed { history: &history, profile: &profile, complete: run.stop.is_complete() };
    case.compare.iter().map(|spec| compare(spec, &computed)).collect()
}
