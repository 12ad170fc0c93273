//! stampflow as WebAssembly, for a worker of the page: one function that takes a question and leaves an answer as JSON
//! and an array of numbers.
//!
//! ```text
//! JavaScript                          here
//!   input(length)                →    room for the question; its address
//!   writes it (see `question`), then a file
//!   call(length of the question) →    asks; the answer stays until the next call
//!   text, text_length            ←    JSON; an array of numbers in it is {"at": first, "of": count}
//!   numbers, numbers_length      ←    all arrays, one after the other
//! ```
//!
//! A panic ends the instance; its words are then the text of the answer.

mod answer;
mod case;
mod drawing;
mod film;
mod json;
mod question;
mod sliders;
mod stage;
mod templates;
mod trace;

use json::Numbers;
use question::Question;
use std::sync::{Mutex, MutexGuard, PoisonError};

static INPUT: Mutex<Vec<u8>> = Mutex::new(Vec::new());
static TEXT: Mutex<String> = Mutex::new(String::new());
static NUMBERS: Mutex<Vec<f64>> = Mutex::new(Vec::new());

/// There is one thread.
fn held<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Makes room for a question of so many bytes.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    let mut input = held(&INPUT);
    input.clear();
    input.resize(length, 0);
    input.as_mut_ptr()
}

/// Answers a question of so many bytes; a file follows.
#[unsafe(no_mangle)]
pub extern "C" fn call(length: usize) {
    std::panic::set_hook(Box::new(|panic| *held(&TEXT) = panic.to_string()));
    let input = std::mem::take(&mut *held(&INPUT));
    let (question, file) = input.split_at(length.min(input.len()));
    let mut numbers = Numbers::default();
    let question = String::from_utf8_lossy(question);
    let answer = Question::read(&question).answer(file, &mut numbers);
    *held(&TEXT) = answer.to_string();
    *held(&NUMBERS) = numbers.0;
}

/// Where the JSON of the answer is.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    held(&TEXT).as_ptr()
}

/// Its length \[bytes\].
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    held(&TEXT).len()
}

/// Where the numbers of the answer are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers() -> *const f64 {
    held(&NUMBERS).as_ptr()
}

/// How many there are.
#[unsafe(no_mangle)]
pub extern "C" fn numbers_length() -> usize {
    held(&NUMBERS).len()
}
