//! Printing on the output and the error stream, the only way to a terminal.

use super::code::Code;
use serde::Serialize;
use stampflow::case::files::visible;
use std::io::{self, Write};
use std::ops::Add;

/// Text for a screen; control characters of titles, names and values are written as codes.
#[derive(Clone, Debug, Default)]
pub struct Shown(String);

impl Shown {
    /// Text with colours of its own, the rest of it [`visible`].
    pub fn coloured(text: String) -> Self {
        Self(text)
    }

    pub fn text(&self) -> &str {
        &self.0
    }
}

impl<T: AsRef<str>> From<T> for Shown {
    fn from(text: T) -> Self {
        Self(visible(text.as_ref()).into_owned())
    }
}

impl Add for Shown {
    type Output = Self;

    fn add(self, more: Self) -> Self {
        Self(self.0 + &more.0)
    }
}

/// Prints whole lines; a reader that has gone away (`| head`) is no error.
pub fn say(text: impl Into<Shown>) -> anyhow::Result<Code> {
    match line(&mut io::stdout().lock(), text.into().text()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Code::Done),
    }
}

/// Prints a value, indented.
pub fn say_json(value: &impl Serialize) -> anyhow::Result<Code> {
    say(serde_json::to_string_pretty(value)?)
}

/// Prints whole lines on the error stream; failures are ignored.
pub fn warn(text: impl Into<Shown>) {
    let _ = line(&mut io::stderr().lock(), text.into().text());
}

fn line(stream: &mut impl Write, text: &str) -> io::Result<()> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    write!(stream, "{}{end}", text)
}
