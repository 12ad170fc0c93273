//! The engine: evaluates the designs that a study asks for, on all cores, until it asks for no more.

use super::{run::evaluate_design, run::evaluated, run::responses, *};
use std::{ops::ControlFlow, sync::atomic::AtomicUsize, sync::atomic::Ordering, sync::mpsc, thread};

/// Plan of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    pub(super) base: BaseCase,
    pub(super) key: String,
    pub(super) columns: Vec<String>,
    /// Number of designs; 0 if each depends on the runs before.
    pub designs: u64,
}

impl Plan {
    pub(super) fn new(base: BaseCase, decided: &str, columns: Vec<String>, designs: u64) -> Self {
        Self { key: short_hash([&base.key, decided]), base, columns, designs }
    }
}

/// A kind of study.
pub trait Study: Sync {
    /// Its case, variables and number of designs.
    fn plan(&self) -> &Plan;

    /// Checks the request against the base case's responses.
    fn check(&mut self, _runs: &RunTable) -> Result<()> {
        Ok(())
    }

    /// Number of designs that are known after some runs; the study is done when it is theirs.
    fn known(&mut self, _runs: &RunTable) -> u64 {
        self.plan().designs
    }

    /// Design at a position below the number of known ones.
    fn design(&self, index: u64) -> Design;

    /// Results of all runs.
    fn report(&self, runs: &RunTable) -> StudyReport;
}

/// Settings of an evaluation.
pub struct Evaluation<'a> {
    /// Runs at the same time.
    pub threads: usize,
    /// Share of the designs to run.
    pub shard: Shard,
    /// Progress, and whether to stop.
    pub watch: &'a dyn Watch,
}

/// Rows of an earlier evaluation, by index.
pub type EarlierRuns = BTreeMap<u64, Run>;

/// Most rows of one table, which is held in memory: 1 kB each.
const MOST: u64 = 1_000_000;

/// Runs the base case; the table has no rows yet. After the watch asked to stop, it is not to be used.
pub fn begin(study: &mut dyn Study, settings: &Evaluation) -> Result<RunTable> {
    let plan = study.plan().clone();
    let (rows, least) = (settings.shard.len(plan.designs), plan.designs.div_ceil(MOST));
    let help = format!("run {least} shards or more of it with --shard, take fewer values, or a sample by `scatter`");
    ensure(rows <= MOST, format!("{rows} runs are more than one table holds: {MOST}"), help)?;
    let case = plan.base.case(&[])?;
    let inputs = BaseCase::input_hash(&case);
    let solution = BaseCase::solve(case, settings.watch).map_err(|reason| {
        StudyError::new(format!("the case as it stands cannot be run: {reason}"), "try `stampflow check`")
    })?;
    let (responses, rows) = responses(&solution);
    let design = Design { index: 0, values: vec![String::new(); plan.columns.len()], settings: Vec::new() };
    let base = evaluated(Run::failed(&design, inputs, responses.len()), &solution, &responses).run;
    let table = RunTable { plan, rows, base, responses, runs: Vec::new() };
    // A case that was cut has other numbers.
    if !settings.watch.wants_to_stop() {
        study.check(&table)?;
    }
    Ok(table)
}

/// Evaluates a study until it is done or `progress` breaks. Designs whose rows are among `earlier` are not run again.
pub fn evaluate(
    study: &mut dyn Study, settings: &Evaluation, mut runs: RunTable, earlier: &EarlierRuns,
    progress: &mut dyn FnMut(&RunTable, &Evaluated) -> ControlFlow<()>,
) -> RunTable {
    while !settings.watch.wants_to_stop() {
        let all = settings.shard.len(study.known(&runs)) as usize;
        let (study, responses, begun) = (&*study, runs.responses.clone(), runs.runs.len());
        let one = |i: usize| {
            let design = study.design(settings.shard.index(begun + i));
            match earlier.get(&design.index).filter(|run| run.values == design.values) {
                Some(run) => Evaluated { run: run.clone(), outcome: None },
                None => evaluate_design(&study.plan().base, &design, &responses, settings.watch),
            }
        };
        let ended = parallel_map(all - begun, settings.threads, settings.watch, one, |evaluated| {
            let is_new = !earlier.contains_key(&evaluated.run.index);
            let flow = if is_new { progress(&runs, &evaluated) } else { ControlFlow::Continue(()) };
            runs.runs.push(evaluated.run);
            settings.watch.ran(runs.runs.len(), all);
            if flow.is_break() { Err(()) } else { Ok(()) }
        });
        if all == begun || ended.is_err() || runs.runs.len() < all {
            break;
        }
    }
    runs
}

/// Runs jobs on several threads and passes each result to `each`, in the order of the jobs. After `watch` asks to stop,
/// no result that was cut short is passed on; the first error of `each` ends all jobs.
pub fn parallel_map<R: Send, E>(
    jobs: usize, threads: usize, watch: &dyn Watch, one: impl Fn(usize) -> R + Sync,
    mut each: impl FnMut(R) -> Result<(), E>,
) -> Result<(), E> {
    let begun = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, jobs.max(1)) {
            let (send, begun, one) = (send.clone(), &begun, &one);
            scope.spawn(move || {
                while let Some(i) = Some(begun.fetch_add(1, Ordering::Relaxed)).filter(|i| *i < jobs) {
                    let result = (!watch.wants_to_stop()).then(|| one(i));
                    let Some(result) = result.filter(|_| !watch.wants_to_stop()) else { break };
                    if send.send((i, result)).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        let mut next = 0;
        for (i, result) in receive {
            waiting.insert(i, result);
            while let Some(result) = waiting.remove(&next) {
                each(result)?;
                next += 1;
            }
        }
        Ok(())
    })
}
