//! Runs the designs of a study on all cores, and hands on what came of them in order.

use super::StudyError;
use super::hash::short_hash;
use super::plan::{Design, Plan};
use super::row::{Row, Solved};
use crate::case::Case;
use crate::files::{CSV, Disk, Files};
use crate::verification::{Watch, Watched};
use std::any::Any;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, mpsc};
use std::thread;
use std::time::{Duration, Instant};

/// So many rows at most are waiting for one before them that is slow: what keeps memory flat.
const AHEAD: u64 = 4096;

/// How long a thread sleeps that is that far ahead.
const NAP: Duration = Duration::from_millis(1);

/// Runs designs of a plan by their indices on so many threads and hands each row to `each`, in the order of the indices. Once
/// `watch` wants to stop no row is handed on of which the run was cut short.
///
/// # Errors
/// The first that `each` returns, which ends the study.
pub fn run<E>(
    plan: &Plan,
    indices: &[u64],
    threads: usize,
    watch: &dyn Watch,
    mut each: impl FnMut(Row) -> Result<(), E>,
) -> Result<(), E> {
    let taken = Mutex::new(indices.iter().copied().enumerate());
    let written = AtomicU64::new(0);
    let (send, receive) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, indices.len().max(1)) {
            let (send, taken, written) = (send.clone(), &taken, &written);
            scope.spawn(move || {
                let next = || taken.lock().ok()?.next();
                while let Some((place, index)) = next().filter(|_| !watch.wants_to_stop()) {
                    while place as u64 > written.load(Ordering::Relaxed) + AHEAD && !watch.wants_to_stop() {
                        thread::sleep(NAP);
                    }
                    let row = one(plan, plan.design(index), watch);
                    // A receiver that has gone has returned an error: there is nothing left to do.
                    if watch.wants_to_stop() || send.send((place, row)).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        let mut next = 0;
        for (place, row) in receive {
            waiting.insert(place, row);
            while let Some(row) = waiting.remove(&next) {
                each(row)?;
                next += 1;
                written.store(next as u64, Ordering::Relaxed);
                watch.ran(next, indices.len());
            }
        }
        Ok(())
    })
}

/// What comes of the case as it stands, which says what columns the table has.
///
/// # Errors
/// When a mistake of this program ends it.
pub fn base(plan: &Plan, watch: &dyn Watch) -> Result<Solved, StudyError> {
    let design = Design { index: 0, values: Vec::new(), settings: Vec::new() };
    let solved = one(plan, design, watch).result;
    solved
        .map_err(|why| StudyError::new(format!("the case as it stands cannot be run: {why}"), "try `stampflow check`"))
}

/// What comes of one design.
pub fn one(plan: &Plan, design: Design, watch: &dyn Watch) -> Row {
    let start = Instant::now();
    let mut inputs = String::new();
    let result = match plan.case(&design.settings) {
        Ok(case) => {
            inputs = hash(&case);
            // A mistake of this program in one design is told in its row.
            catch_unwind(AssertUnwindSafe(|| Solved::of(&case.solve(&mut Watched(watch)))))
                .map_err(|panic| words(panic.as_ref()))
        }
        Err(error) => Err(error.to_string()),
    };
    Row { design, inputs, result, seconds: start.elapsed().as_secs_f64() }
}

/// Of all that a case was read from.
fn hash(case: &Case) -> String {
    let beside = case.inputs.iter().filter(|path| **path != case.path);
    let beside = beside.map(|path| Disk.read(path, CSV).unwrap_or_default());
    short_hash([case.text.clone().into_bytes()].into_iter().chain(beside))
}

fn words(panic: &(dyn Any + Send)) -> String {
    let said = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
    format!("a mistake of this program: {}", said.unwrap_or("no words"))
}
