//! What a verb prints on the output stream.

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
