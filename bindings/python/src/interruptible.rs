//! Work on a thread of its own, without the interpreter's lock; the calling thread handles Ctrl-C and progress.

use pyo3::prelude::*;
use stampflow::study::Watch;
use stampflow::{Model, Observer, State};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::{panic::resume_unwind, thread, time::Duration};

/// Interval of the checks for Ctrl-C.
const INTERVAL: Duration = Duration::from_millis(30);

/// Callback with the share that is done.
pub type Progress = Option<Py<PyAny>>;

/// Channel from the work to the calling thread.
pub struct Line<'a> {
    share: Option<Sender<f64>>,
    stop: &'a AtomicBool,
}

impl Line<'_> {
    fn send(&self, share: f64) {
        if let Some(line) = &self.share {
            // The receiver is gone once the work is to stop.
            let _ = line.send(share);
        }
    }
}

/// Runs `work`; returns its result, whole or cut short, and the exception that cut it short.
pub fn interruptible<R: Send>(
    py: Python<'_>, progress: Progress, work: impl FnOnce(&Line<'_>) -> R + Send,
) -> (R, Option<PyErr>) {
    py.detach(|| {
        let stop = AtomicBool::new(false);
        thread::scope(|scope| {
            let (send, receive) = mpsc::channel();
            let (over, ended) = mpsc::channel::<()>();
            let line = Line { share: progress.is_some().then_some(send), stop: &stop };
            let worker = scope.spawn(move || {
                let _over = over;
                work(&line)
            });
            let call = || {
                Python::attach(|py| {
                    py.check_signals()?;
                    match (&progress, receive.try_iter().last()) {
                        (Some(progress), Some(share)) => progress.call1(py, (share,)).map(drop),
                        _ => Ok(()),
                    }
                })
                .err()
            };
            let mut raised = None;
            while !matches!(ended.recv_timeout(INTERVAL), Err(RecvTimeoutError::Disconnected)) {
                raised = raised.or_else(&call);
                stop.store(raised.is_some(), Ordering::Relaxed);
            }
            raised = raised.or_else(call);
            (worker.join().unwrap_or_else(|panic| resume_unwind(panic)), raised)
        })
    })
}

/// Runs `work` with new threads for its parallel parts: a process that was forked has none of its parent's.
pub fn pooled<R: Send>(work: impl FnOnce() -> R + Send) -> R {
    match rayon::ThreadPoolBuilder::new().build() {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}

/// Observer of the stages of one run.
pub struct Stages<'a> {
    line: &'a Line<'a>,
    count: usize,
    begun: usize,
}

impl<'a> Stages<'a> {
    /// Observer of a case with `count` stages.
    pub fn new(line: &'a Line<'a>, count: usize) -> Self {
        Self { line, count, begun: 0 }
    }
}

impl Observer for Stages<'_> {
    fn stage(&mut self, _stage: &stampflow::Stage) {
        self.begun += 1;
    }

    fn state(&mut self, model: &Model, state: &State) {
        let before = self.begun.saturating_sub(1) as f64;
        self.line.send((before + model.progress(state.time)) / self.count as f64);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.line.stop.load(Ordering::Relaxed)
    }
}

impl Watch for Line<'_> {
    fn wants_to_stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn ran(&self, done: usize, all: usize) {
        self.send(done as f64 / all as f64);
    }
}
