//! Case files to begin with: a process, a few wanted sizes, and everything else picked by stated rules.
//!
//! ```
//! let cup = stampflow::author::templates::find("cup")?;
//! let text = cup.fill(&[("punch-radius", "40 mm"), ("height", "35 mm")])?;
//! let case = stampflow::case::parse(&text, "cup.toml", &[])?;
//! assert_eq!(case.model().blank.thickness, 1.0);
//! # Ok::<(), stampflow::case::CaseError>(())
//! ```

mod air_bend;
mod bulge;
mod conical_cup;
mod cup;
mod hat_section;
mod hemispherical_cup;
mod inputs;
mod page;
mod redraw;
pub mod rules;
mod sheet;
mod stretch_dome;
mod tools;
mod u_bend;
mod v_bend;

pub use inputs::{Choice, Default, Kind};
pub use sheet::{FRICTION, K, N, OFFSET, SHEET};

use crate::case::CaseError;
use crate::units::closest;
use inputs::Inputs;
use std::fmt::Write;

/// A kind of case that can be written from a few sizes.
#[derive(Clone, Copy, Debug)]
pub struct Template {
    pub name: &'static str,
    /// What it forms, in one line.
    pub about: &'static str,
    /// Its own options; those of the sheet, [`SHEET`], come on top.
    pub own: &'static [Choice],
    write: fn(&Inputs) -> Result<String, CaseError>,
}

/// Every template.
pub const TEMPLATES: &[Template] = &[
    cup::TEMPLATE,
    hemispherical_cup::TEMPLATE,
    conical_cup::TEMPLATE,
    redraw::TEMPLATE,
    stretch_dome::TEMPLATE,
    bulge::TEMPLATE,
    hat_section::TEMPLATE,
    v_bend::TEMPLATE,
    u_bend::TEMPLATE,
];

/// The template of a name.
///
/// # Errors
/// When there is none; the message names those that are there.
pub fn find(name: &str) -> Result<&'static Template, CaseError> {
    TEMPLATES.iter().find(|template| template.name == name).ok_or_else(|| {
        let names: Vec<&str> = TEMPLATES.iter().map(|template| template.name).collect();
        let near = closest(name, names.iter().copied());
        let meant = near.first().map_or(String::new(), |near| format!("did you mean `{near}`? "));
        CaseError::bare(format!("there is no template `{name}`"), format!("{meant}there are {}", names.join(", ")))
    })
}

impl Template {
    /// Everything that may be given, the sheet's options last.
    pub fn options(&self) -> impl Iterator<Item = &'static Choice> + use<> {
        self.own.iter().chain(SHEET)
    }

    /// The text of a case file; `given` are names of options and their values with units.
    ///
    /// # Errors
    /// When an option is not one of this template's, a value is none of its kind, or the sizes do not go together.
    pub fn fill(&self, given: &[(&str, &str)]) -> Result<String, CaseError> {
        let text = (self.write)(&Inputs::read(self, given)?)?;
        // What the rules above let pass and a case does not.
        match crate::case::parse(&text, &format!("{}.toml", self.name), &[]) {
            Ok(_) => Ok(text),
            Err(error) => Err(self.refused(given, &text, &error)),
        }
    }

    /// An error of a case that nobody has seen yet, as one of the options that make it.
    fn refused(&self, given: &[(&str, &str)], text: &str, error: &CaseError) -> CaseError {
        let options: Vec<String> = given.iter().map(|(key, value)| format!("--{key} {value:?}")).collect();
        let with = if options.is_empty() { "its defaults".to_owned() } else { options.join(" ") };
        let line = error.position().and_then(|(line, _)| text.lines().nth(line - 1));
        let line = line.map_or(String::new(), |line| format!(" (it would have the line: {})", line.trim()));
        let what = format!("the template {} with {with} makes a case that is refused: {error}{line}", self.name);
        CaseError::bare(what, error.remedy().unwrap_or_default().to_owned())
    }
}

/// All templates with their options, as text.
pub fn list() -> String {
    let mut text = String::new();
    let lines = |text: &mut String, options: &[Choice]| {
        for choice in options {
            let option = format!("--{} {}", choice.key, choice.kind.placeholder());
            let _ = writeln!(text, "    {option:<26} {} [{}]", choice.about, choice.default.words());
        }
    };
    for template in TEMPLATES {
        let _ = writeln!(text, "{}\n  {}", template.name, template.about);
        lines(&mut text, template.own);
        text.push('\n');
    }
    let _ = writeln!(text, "every template");
    lines(&mut text, SHEET);
    text
}
