//! stampflow as WebAssembly, for a worker of the page: one function that takes a request and leaves an answer, both as JSON.
//!
//! ```text
//! JavaScript                          here
//!   input(length)                →    room for the request; its address
//!   writes it, then a file
//!   call(length of the request)  →    solves; the answer stays until the next call
//!   text, text_length            ←    the answer
//! ```
//!
//! A panic ends the instance; its message is then the text of the answer.

mod film;
mod request;
mod solve;
mod stage;
mod trace;

use request::Request;
use serde_json::json;
use std::sync::{Mutex, MutexGuard, PoisonError};

static INPUT: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static TEXT: Mutex<String> = Mutex::new(String::new());

/// There is one thread.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes room for a request and a file \[bytes\].
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    let mut input = lock(&INPUT);
    input.clear();
    input.resize(length, 0);
    input.as_mut_ptr()
}

/// Answers a request of so many bytes; a file follows.
#[unsafe(no_mangle)]
pub extern "C" fn call(length: usize) {
    std::panic::set_hook(Box::new(|panic| *lock(&TEXT) = panic.to_string()));
    let input = std::mem::take(&mut *lock(&INPUT));
    let (request, file) = input.split_at(length.min(input.len()));
    let answer = match serde_json::from_slice::<Request>(request) {
        Ok(request) => request.answer(file).unwrap_or_else(|failure| json!({ "error": failure })),
        Err(error) => json!({ "error": { "what": error.to_string() } }),
    };
    *lock(&TEXT) = answer.to_string();
}

/// Address of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    lock(&TEXT).as_ptr()
}

/// Length of the answer \[bytes\].
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    lock(&TEXT).len()
}
