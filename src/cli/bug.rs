//! Panics, which are mistakes of this program: named with what to send, and stopping nothing else.

use std::any::Any;
use std::cell::RefCell;
use std::panic::{self, AssertUnwindSafe};

/// Longest quotation of a panic \[characters\].
const LONGEST: usize = 300;

thread_local! {
    /// Place in the source of this thread's last panic.
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// A caught panic.
#[derive(Debug, thiserror::Error)]
#[error(
    "{job} met a mistake of this program, not of yours: \"{text}\" at {place}. Please report it with this message, the case \
     file and the files that it names, and the version, stampflow {}",
    env!("CARGO_PKG_VERSION")
)]
pub struct Bug {
    job: String,
    text: String,
    place: String,
}

/// Silences panics; [`caught`] reports them.
pub fn listen() {
    panic::set_hook(Box::new(|panic| {
        let place = panic.location().map_or_else(|| "an unknown place".to_owned(), ToString::to_string);
        PLACE.with(|last| last.replace(place));
    }));
}

/// Runs a job, such as "case cup"; its panic becomes an error.
pub fn caught<T>(job: &str, run: impl FnOnce() -> anyhow::Result<T>) -> anyhow::Result<T> {
    panic::catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|panic| {
        let (job, text) = (job.to_owned(), message(panic.as_ref()).chars().take(LONGEST).collect());
        Err(Bug { job, text, place: PLACE.with(RefCell::take) }.into())
    })
}

fn message(panic: &(dyn Any + Send)) -> &str {
    let formatted = panic.downcast_ref::<String>().map(String::as_str);
    formatted.or(panic.downcast_ref::<&str>().copied()).unwrap_or("no words")
}
