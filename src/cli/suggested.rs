//! Values that a shell offers to complete; any other text is accepted too.

use clap::builder::{PossibleValue, StringValueParser, TypedValueParser};
use clap::error::Error;
use clap::{Arg, Command};
use stampflow::case::{self, library};
use std::ffi::OsStr;
use std::sync::LazyLock;

/// Parser of a text, with words to offer.
#[derive(Clone)]
pub struct Suggested(&'static LazyLock<Vec<String>>);

impl Suggested {
    pub const SHEETS: Self = Self(&SHEETS);
    pub const KEYS: Self = Self(&KEYS);
}

/// Sheets of the library and the grades that they stand for; a space would end a word of the shell.
static SHEETS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let grades = library::materials().into_iter().flatten().filter_map(|entry| entry.stands_for);
    let grades = grades.flat_map(|stands| stands.grades).filter(|grade| !grade.contains(' '));
    library::names().map(str::to_owned).chain(grades).collect()
});

/// Keys of a case file, ready for their value.
static KEYS: LazyLock<Vec<String>> = LazyLock::new(|| case::keys().into_iter().map(|key| key + "=").collect());

impl TypedValueParser for Suggested {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &OsStr) -> Result<String, Error> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0.iter().map(|word| PossibleValue::new(word.as_str()))))
    }
}
