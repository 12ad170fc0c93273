//! What a verb prints on the output stream, and what is told on the error stream.

use super::code::Code;
use serde::Serialize;
use std::io::{self, Write};

/// Prints whole lines, the last one ended if need be; a reader that has gone away (`| head`) is no error.
pub fn say(text: &str) -> anyhow::Result<Code> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    match write!(io::stdout().lock(), "{text}{end}") {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Code::Done),
    }
}

/// Prints a value, indented.
pub fn say_json(value: &impl Serialize) -> anyhow::Result<Code> {
    say(&serde_json::to_string_pretty(value)?)
}

/// Tells of progress and errors. What cannot be shown, because the reader has gone away or the disk behind it is full, is
/// dropped: a message never ends a run.
pub fn tell(text: &str) {
    let _ = io::stderr().lock().write_all(text.as_bytes());
}
