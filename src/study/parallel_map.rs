//! Jobs on several threads, with their results in order.

use crate::verification::Watch;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

/// Results that may wait for a slow one before them; keeps memory flat.
const AHEAD: usize = 4096;

const NAP: Duration = Duration::from_millis(1);

/// Runs jobs on several threads and passes each result to `each`, in the order of the jobs. After `watch` asks to stop,
/// no result that was cut short is passed on.
///
/// # Errors
/// The first error of `each`, which ends all jobs.
pub fn parallel_map<J: Sync, R: Send, E>(
    jobs: &[J],
    threads: usize,
    watch: &dyn Watch,
    one: impl Fn(&J) -> R + Sync,
    mut each: impl FnMut(R) -> Result<(), E>,
) -> Result<(), E> {
    let taken = AtomicUsize::new(0);
    let handed = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, jobs.len().max(1)) {
            let (send, taken, handed, one) = (send.clone(), &taken, &handed, &one);
            scope.spawn(move || {
                loop {
                    let place = taken.fetch_add(1, Ordering::Relaxed);
                    let Some(job) = jobs.get(place).filter(|_| !watch.wants_to_stop()) else { break };
                    while place > handed.load(Ordering::Relaxed) + AHEAD && !watch.wants_to_stop() {
                        thread::sleep(NAP);
                    }
                    let result = one(job);
                    if watch.wants_to_stop() || send.send((place, result)).is_err() {
                        break;
                    }
                }
            });
        }
        drop(send);
        let mut waiting = BTreeMap::new();
        let mut next = 0;
        for (place, result) in receive {
            waiting.insert(place, result);
            while let Some(result) = waiting.remove(&next) {
                each(result)?;
                next += 1;
                handed.store(next, Ordering::Relaxed);
                watch.ran(next, jobs.len());
            }
        }
        Ok(())
    })
}
