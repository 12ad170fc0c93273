//! Work that goes on without Python, while the thread that asked for it hears Ctrl-C and hands on how far it has come.

use pyo3::prelude::*;
use stampflow::study::verify::Watch;
use stampflow::{Model, Observer, State};
use std::panic::resume_unwind;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread;
use std::time::Duration;

/// Time between two looks whether Ctrl-C was pressed: less is not felt.
const PATIENCE: Duration = Duration::from_millis(30);

/// What a user is called back with; `None` of one who does not ask.
pub type Progress = Option<Py<PyAny>>;

/// The way from the work to the thread that attends it.
pub struct Line<'a> {
    /// The share that is done, where it is asked for.
    share: Option<Sender<f64>>,
    stop: &'a AtomicBool,
}

impl Line<'_> {
    fn tell(&self, share: f64) {
        if let Some(line) = &self.share {
            // Who does not listen any more has asked to stop.
            let _ = line.send(share);
        }
    }
}

/// Does `work` on a thread of its own, without the interpreter's lock; what came out, whole or cut short, and the exception
/// that cut it short: of Ctrl-C or of `progress`.
pub fn attended<R: Send>(
    py: Python<'_>,
    progress: Progress,
    work: impl FnOnce(&Line<'_>) -> R + Send,
) -> (R, Option<PyErr>) {
    py.detach(|| {
        let stop = AtomicBool::new(false);
        thread::scope(|scope| {
            let (send, receive) = mpsc::channel();
            // Its end is the end of the work: it is dropped then.
            let (over, ended) = mpsc::channel::<()>();
            let line = Line { share: progress.is_some().then_some(send), stop: &stop };
            let worker = scope.spawn(move || {
                let _over = over;
                work(&line)
            });
            let mut raised = None;
            while !matches!(ended.recv_timeout(PATIENCE), Err(RecvTimeoutError::Disconnected)) {
                if raised.is_some() {
                    continue;
                }
                raised = Python::attach(|py| {
                    py.check_signals()?;
                    call(py, progress.as_ref(), receive.try_iter().last())
                })
                .err();
                stop.store(raised.is_some(), Ordering::Relaxed);
            }
            if raised.is_none() {
                raised = Python::attach(|py| call(py, progress.as_ref(), receive.try_iter().last())).err();
            }
            (worker.join().unwrap_or_else(|panic| resume_unwind(panic)), raised)
        })
    })
}

fn call(py: Python<'_>, progress: Option<&Py<PyAny>>, share: Option<f64>) -> PyResult<()> {
    progress.zip(share).map_or(Ok(()), |(progress, share)| progress.call1(py, (share,)).map(drop))
}

/// An observer at the end of a line.
pub struct Stages<'a> {
    line: &'a Line<'a>,
    /// Stages of the case, and those that were begun.
    all: usize,
    begun: usize,
}

impl<'a> Stages<'a> {
    /// Of a case with so many stages.
    pub fn new(line: &'a Line<'a>, all: usize) -> Self {
        Self { line, all, begun: 0 }
    }
}

impl Observer for Stages<'_> {
    fn stage(&mut self, _stage: &stampflow::Stage) {
        self.begun += 1;
    }

    fn state(&mut self, model: &Model, state: &State) {
        let before = self.begun.saturating_sub(1) as f64;
        self.line.tell((before + model.progress(state.time)) / self.all as f64);
    }

    fn wants_to_stop(&mut self) -> bool {
        self.line.stop.load(Ordering::Relaxed)
    }
}

/// Many runs at the end of a line.
impl Watch for Line<'_> {
    fn wants_to_stop(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    fn ran(&self, done: usize, all: usize) {
        self.tell(done as f64 / all as f64);
    }
}
