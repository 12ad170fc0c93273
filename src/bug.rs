//! Panics, which are mistakes of this program: named with what to send, and stopping nothing else.

use std::{cell::RefCell, panic, panic::AssertUnwindSafe};

/// Longest quotation of a panic \[characters\].
const LONGEST: usize = 300;

thread_local! {
    static PLACE: RefCell<String> = const { RefCell::new(String::new()) };
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
        let text = panic.downcast_ref::<String>().map(String::as_str).or(panic.downcast_ref::<&str>().copied());
        let text: String = text.unwrap_or("no words").chars().take(LONGEST).collect();
        let (place, version) = (PLACE.with(RefCell::take), env!("CARGO_PKG_VERSION"));
        anyhow::bail!(
            "{job} met a mistake of this program, not of yours: \"{text}\" at {place}. Please report it with this message, \
             the case file and the files that it names, and the version, stampflow {version}"
        )
    })
}
