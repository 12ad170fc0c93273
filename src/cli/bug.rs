//! Panics: mistakes of this program. What panics is given up, named with what to send, and stops nothing else.

use std::any::Any;
use std::cell::RefCell;
use std::panic::{self, AssertUnwindSafe};

/// Longest part of a panic's own words that is told, in characters.
const LONGEST: usize = 300;

thread_local! {
    /// Where in the source this thread has panicked last.
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
}

/// A panic, caught.
#[derive(Debug, thiserror::Error)]
#[error(
    "{of} met a mistake of this program, not of yours: \"{what}\" at {place}. Please report it with this message, the case \
     file and the files that it names, and the version, stampflow {}",
    env!("CARGO_PKG_VERSION")
)]
pub struct Bug {
    of: String,
    what: String,
    place: String,
}

/// From here on a panic prints nothing; [`caught`] tells of it.
pub fn listen() {
    panic::set_hook(Box::new(|panic| {
        let place = panic.location().map_or_else(|| "an unknown place".to_owned(), ToString::to_string);
        PLACE.with(|last| last.replace(place));
    }));
}

/// What a job returns; its panic is an error, about what is worked at, as in "case cup".
pub fn caught<T>(of: &str, job: impl FnOnce() -> anyhow::Result<T>) -> anyhow::Result<T> {
    panic::catch_unwind(AssertUnwindSafe(job)).unwrap_or_else(|panic| {
        let (of, what) = (of.to_owned(), words(panic.as_ref()).chars().take(LONGEST).collect());
        Err(Bug { of, what, place: PLACE.with(RefCell::take) }.into())
    })
}

/// What a panic says.
fn words(panic: &(dyn Any + Send)) -> &str {
    let formatted = panic.downcast_ref::<String>().map(String::as_str);
    formatted.or(panic.downcast_ref::<&str>().copied()).unwrap_or("no words")
}
