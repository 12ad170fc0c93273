//! What a template is: its options, and the text made of them.

use super::inputs::{Choice, Inputs, Kind};
use super::sheet::SHEET;
use crate::assess::size;
use crate::author::page::{Page, plain};
use crate::case::CaseError;
use crate::model::{Geometry, Model};
use crate::units::{Dimensioned, Length, Positive, significant};

/// What writes a template's case.
type Write = fn(&Inputs) -> Result<String, CaseError>;

/// A kind of case that can be written from a few sizes.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    /// Its name, as `stampflow new` takes it.
    pub name: &'static str,
    /// What it forms, in one line.
    pub about: &'static str,
    /// Its own options; those of the sheet, [`SHEET`], come on top.
    pub own: &'static [Choice],
    /// The text of its case, or why the values do not go together.
    write: Write,
}

/// The page of a template's case.
pub(super) fn begin(about: &str, title: &str, geometry: Geometry, notes: &[String]) -> Page {
    let units = "Every quantity is text with its unit; mm, in, N, kN, MPa, ksi ... are understood.";
    Page::new([about, units], title, geometry, notes)
}

impl Template {
    pub(super) const fn new(name: &'static str, about: &'static str, own: &'static [Choice], write: Write) -> Self {
        Self { name, about, own, write }
    }

    /// Everything that may be given, the sheet's options last.
    pub fn options(&self) -> impl Iterator<Item = &'static Choice> + use<> {
        self.own.iter().chain(SHEET)
    }

    /// The text of a case file; `given` are names of options and their values with units.
    ///
    /// # Errors
    /// When an option is not one of this template's, a value is none of its kind, the sizes do not go together, or the blank
    /// would be wider than any.
    pub fn fill(&self, given: &[(&str, &str)]) -> Result<String, CaseError> {
        let text = (self.write)(&Inputs::read(self.name, self.options(), given)?)?;
        // What the rules above let pass and a case does not.
        match crate::case::parse(&text, &format!("{}.toml", self.name), &[]) {
            Ok(case) => self.small_enough(given, case.model()).map(|()| text),
            Err(error) => Err(self.refused(given, &error)),
        }
    }

    /// A blank that is wider than any is made by a wrong unit.
    fn small_enough(&self, given: &[(&str, &str)], model: &Model) -> Result<(), CaseError> {
        let across = size::across(model);
        if across <= *size::WIDTHS.end() {
            return Ok(());
        }
        let length = |text: &str| text.parse::<Positive<Length>>().map_or(0.0, Dimensioned::value);
        let lengths = given.iter().filter(|(key, _)| self.options().any(|o| o.key == *key && o.kind == Kind::Length));
        let largest = lengths.max_by(|(_, a), (_, b)| length(a).total_cmp(&length(b)));
        let help = largest.map_or_else(String::new, |(key, text)| {
            let number = text.trim_end_matches(|c: char| !c.is_ascii_digit());
            format!("is the unit right? --{key} {text:?} was given; try --{key} \"{number} mm\"")
        });
        let most = plain(*size::WIDTHS.end());
        Err(CaseError::bare(
            format!("the blank would be {} wide; stampings are up to {most}", plain(significant(across, 3))),
            help,
        ))
    }

    /// An error of a case that nobody has seen yet, as one of the options that make it.
    fn refused(&self, given: &[(&str, &str)], error: &CaseError) -> CaseError {
        let options: Vec<String> = given.iter().map(|(key, value)| format!("--{key} {value:?}")).collect();
        let with = if options.is_empty() { "its defaults".to_owned() } else { options.join(" ") };
        let line = error.line().map_or(String::new(), |line| format!(" (it would have the line: {})", line.trim()));
        let what = format!("the template {} with {with} makes a case that is refused: {error}{line}", self.name);
        CaseError::bare(what, error.remedy().unwrap_or_default().to_owned())
    }
}
