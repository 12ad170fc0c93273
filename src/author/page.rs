//! The text of a case file as it grows: tables, keys, and a comment for every picked number.

use super::rules::Picked;
use std::fmt::{Display, Write};

/// A comment that would make its line longer than this stands above it \[characters\].
const WIDE: usize = 100;

/// A case file being written.
pub(super) struct Page(String);

impl Page {
    /// Begins with what is said of the case as a whole.
    pub fn new(about: &str, title: &str, geometry: &str, notes: &[String]) -> Self {
        let mut page = Self(String::new());
        page.comment(about);
        page.comment("Every quantity is text with its unit; mm, in, N, kN, MPa, ksi ... are understood.");
        let _ = writeln!(page.0, "\ntitle = {title:?}\ngeometry = {geometry:?}\nnotes = [");
        for note in notes {
            let _ = writeln!(page.0, "    {note:?},");
        }
        page.0.push_str("]\n");
        page
    }

    /// A comment, wrapped into lines.
    pub fn comment(&mut self, text: &str) {
        let mut line = String::from("#");
        for word in text.split_whitespace() {
            if line.chars().count() + 1 + word.chars().count() > WIDE {
                let _ = writeln!(self.0, "{line}");
                line = String::from("#");
            }
            line.push(' ');
            line.push_str(word);
        }
        let _ = writeln!(self.0, "{line}");
    }

    /// Begins a table, `tools.punch` or `[stages]`, with a comment above it where there is one.
    pub fn table(&mut self, name: &str, why: &str) {
        self.0.push('\n');
        if !why.is_empty() {
            self.comment(why);
        }
        let _ = writeln!(self.0, "[{name}]");
    }

    /// A key and its value as TOML, with why it is so.
    pub fn set(&mut self, key: &str, value: impl Display, why: &str) {
        let line = format!("{key} = {value}");
        if why.is_empty() {
            let _ = writeln!(self.0, "{line}");
        } else if line.chars().count() + 3 + why.chars().count() <= WIDE {
            let _ = writeln!(self.0, "{line}   # {why}");
        } else {
            self.comment(why);
            let _ = writeln!(self.0, "{line}");
        }
    }

    /// A picked length.
    pub fn length(&mut self, key: &str, picked: &Picked) {
        self.set(key, mm(picked.value), &picked.why);
    }

    pub fn text(self) -> String {
        self.0
    }
}

/// A length as a sentence has it.
pub(super) fn plain(length: f64) -> String {
    format!("{} mm", crate::assess::check::mm(length))
}

/// A length as a case file has it.
pub(super) fn mm(length: f64) -> String {
    format!("\"{}\"", plain(length))
}
