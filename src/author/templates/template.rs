//! A kind of case that is written from a few sizes.

use super::inputs::{Choice, Inputs};
use super::sheet::{SHEET, Sheet};
use super::sizes::ensure;
use crate::assess::size;
use crate::author::writer::{Values, plain};
use crate::case::CaseError;
use crate::units::significant;

/// A kind of case that is written from a few sizes.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    /// Name, as `stampflow new` takes it.
    pub name: &'static str,
    /// Description in one line.
    pub about: &'static str,
    /// Its own options; those of the sheet, [`SHEET`], come on top.
    pub own: &'static [Choice],
    /// Case file with placeholders.
    pub(super) text: &'static str,
    /// Derives the values of the placeholders.
    pub(super) sizes: fn(&Inputs, &Sheet) -> Result<Values, CaseError>,
}

impl Template {
    /// All options, those of the sheet last.
    pub fn options(&self) -> impl Iterator<Item = &'static Choice> + use<> {
        self.own.iter().chain(SHEET)
    }

    /// Writes the text of a case file from option names and their values with units.
    ///
    /// # Errors
    /// When an option is unknown, a value is not of its kind, sizes do not fit each other, or the blank is too wide.
    pub fn fill(&self, given: &[(&str, &str)]) -> Result<String, CaseError> {
        let inputs = Inputs::read(self, given)?;
        let text = (self.sizes)(&inputs, &Sheet::read(&inputs)?)?.fill(self.text);
        let options: Vec<String> = given.iter().map(|(key, value)| format!("--{key} {value:?}")).collect();
        let with = if options.is_empty() { "its defaults".to_owned() } else { options.join(" ") };
        let case = crate::case::parse(&text, &format!("{}.toml", self.name), &[]).map_err(|error| {
            // Nobody has seen this case: the error is told in terms of the options.
            let line = error.line().map_or(String::new(), |line| format!(" (it would have the line: {})", line.trim()));
            let what = format!("the template {} with {with} makes a case that is refused: {error}{line}", self.name);
            CaseError::bare(what, error.remedy().unwrap_or_default().to_owned())
        })?;
        let (width, most) = (size::across(case.model()), *size::WIDTHS.end());
        let what =
            || format!("the blank would be {} wide; stampings are up to {}", plain(significant(width, 3)), plain(most));
        ensure(width <= most, what, &format!("are the units right? given: {with}"))?;
        Ok(text)
    }
}
