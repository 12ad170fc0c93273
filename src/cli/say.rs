//! What is printed, on the output stream and on the error stream: the only way to a terminal.

use super::code::Code;
use serde::Serialize;
use stampflow::case::files::visible;
use std::fmt;
use std::io::{self, Write};
use std::ops::Add;

/// Text for a screen. Control characters of what comes from outside, titles, names and values, are written as codes when
/// it is made.
#[derive(Clone, Debug, Default)]
pub struct Shown(String);

impl Shown {
    /// Text that brings its own colours; all else in it is [`visible`] already.
    pub fn coloured(text: String) -> Self {
        Self(text)
    }

    /// As it is printed.
    pub fn text(&self) -> &str {
        &self.0
    }
}

impl<T: AsRef<str>> From<T> for Shown {
    fn from(text: T) -> Self {
        Self(visible(text.as_ref()).into_owned())
    }
}

impl fmt::Write for Shown {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0 += &visible(text);
        Ok(())
    }
}

impl Add for Shown {
    type Output = Self;

    fn add(self, more: Self) -> Self {
        Self(self.0 + &more.0)
    }
}

/// Prints whole lines, the last one ended if need be; a reader that has gone away (`| head`) is no error.
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

/// Prints whole lines on the error stream; where that cannot be, there is no one to tell.
pub fn warn(text: impl Into<Shown>) {
    let _ = line(&mut io::stderr().lock(), text.into().text());
}

fn line(stream: &mut impl Write, text: &str) -> io::Result<()> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    write!(stream, "{}{end}", text)
}
