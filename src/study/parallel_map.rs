//! Jobs on several threads, with their results in order.

use super::Watch;
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// Runs jobs on several threads and passes each result to `each`, in the order of the jobs. After `watch` asks to stop,
/// no result that was cut short is passed on; the first error of `each` ends all jobs.
pub fn parallel_map<J: Sync, R: Send, E>(
    jobs: &[J],
    threads: usize,
    watch: &dyn Watch,
    one: impl Fn(&J) -> R + Sync,
    mut each: impl FnMut(R) -> Result<(), E>,
) -> Result<(), E> {
    let begun = AtomicUsize::new(0);
    let (send, receive) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..threads.clamp(1, jobs.len().max(1)) {
            let (send, begun, one) = (send.clone(), &begun, &one);
            scope.spawn(move || {
                while let Some(i) = Some(begun.fetch_add(1, Ordering::Relaxed)).filter(|i| *i < jobs.len()) {
                    let result = (!watch.wants_to_stop()).then(|| one(&jobs[i]));
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
