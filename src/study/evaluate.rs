//! The engine: evaluates the designs that a study asks for, on all cores, until it asks for no more.

use super::parallel_map::parallel_map;
use super::report::StudyReport;
use super::run::{Design, Evaluated, Run, Silent, evaluate_design, evaluated, responses};
use super::run_table::RunTable;
use super::shard::Shard;
use super::{BaseCase, StudyError};
use crate::verification::Watch;
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// A kind of study.
pub trait Study: Sync {
    /// The case that it varies.
    fn base(&self) -> &BaseCase;

    /// Hash of everything that decides its designs.
    fn key(&self) -> String;

    /// Columns of its variables.
    fn columns(&self) -> Vec<String>;

    /// Number of designs; 0 if each depends on the runs before.
    fn designs(&self) -> u64;

    /// Checks the request against the base case's responses.
    ///
    /// # Errors
    /// When it asks for a number that no run has.
    fn check(&mut self, _runs: &RunTable) -> Result<(), StudyError> {
        Ok(())
    }

    /// Next designs; empty when it is done.
    fn next(&mut self, runs: &RunTable) -> Vec<Design>;

    /// Results of all runs.
    fn report(&self, runs: &RunTable) -> StudyReport;
}

/// Settings of an evaluation.
pub struct Evaluation<'a> {
    /// Runs at the same time.
    pub threads: usize,
    /// Whether each run gets error bars, from one coarser run.
    pub errors: bool,
    /// Share of the designs to run.
    pub shard: Shard,
    /// Progress, and whether to stop.
    pub watch: &'a dyn Watch,
}

/// Rows of an earlier evaluation, by index.
pub type EarlierRuns = BTreeMap<u64, Run>;

/// Runs the base case; the table has no rows yet.
///
/// # Errors
/// When a mistake of this program ends the run.
pub fn begin(study: &mut dyn Study, settings: &Evaluation) -> Result<RunTable, StudyError> {
    let case = study.base().case(&[])?;
    let inputs = BaseCase::input_hash(&case);
    let solution = BaseCase::solve(case, settings.watch).map_err(|why| {
        StudyError::new(format!("the case as it stands cannot be run: {why}"), "try `stampflow check`")
    })?;
    let (_, responses, rows) = responses(&solution);
    let values = vec![String::new(); study.columns().len()];
    let design = Design { index: 0, values, settings: Vec::new() };
    let base = evaluated(&solution, &design, inputs, &responses, settings.errors, &Silent(settings.watch));
    let table = RunTable::new(study, responses, rows, base.run, settings.errors);
    study.check(&table)?;
    Ok(table)
}

/// Evaluates a study until it is done or `progress` breaks. Designs whose rows are among `earlier` are not run again.
///
/// # Errors
/// Those of [`begin`].
pub fn evaluate(
    study: &mut dyn Study,
    settings: &Evaluation,
    mut runs: RunTable,
    earlier: &EarlierRuns,
    progress: &mut dyn FnMut(&RunTable, &Evaluated) -> ControlFlow<()>,
) -> RunTable {
    while !settings.watch.wants_to_stop() {
        let designs: Vec<Design> =
            study.next(&runs).into_iter().filter(|design| settings.shard.holds(design.index)).collect();
        if designs.is_empty() {
            break;
        }
        let of = |design: &Design| earlier.get(&design.index).filter(|run| run.values == design.values);
        let base = study.base().clone();
        let responses = runs.responses.clone();
        let counted = Counted { watch: settings.watch, before: runs.runs.len() };
        let one = |design: &Design| match of(design) {
            Some(run) => Evaluated { run: run.clone(), outcome: None },
            None => evaluate_design(&base, design, &responses, settings.errors, &Silent(settings.watch)),
        };
        let (mut count, wanted) = (0, designs.len());
        let ended = parallel_map(&designs, settings.threads, &counted, one, |evaluated| {
            count += 1;
            let flow = if earlier.contains_key(&evaluated.run.index) {
                ControlFlow::Continue(())
            } else {
                progress(&runs, &evaluated)
            };
            runs.runs.push(evaluated.run);
            if flow.is_break() { Err(()) } else { Ok(()) }
        });
        if ended.is_err() || count < wanted || study.designs() > 0 {
            break;
        }
    }
    runs
}

/// Watch that counts on from the runs before.
struct Counted<'a> {
    watch: &'a dyn Watch,
    before: usize,
}

impl Watch for Counted<'_> {
    fn wants_to_stop(&self) -> bool {
        self.watch.wants_to_stop()
    }

    fn ran(&self, done: usize, all: usize) {
        self.watch.ran(self.before + done, self.before + all);
    }
}
