//! Case files to begin with: a few wanted sizes, and everything else picked by stated rules.
//!
//! A template is a case with `<placeholders>`, `cup.toml`, and the function beside it that derives their sizes.
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
mod erichsen;
mod hat_section;
mod hemispherical_cup;
mod inputs;
mod redraw;
mod sheet;
mod sizes;
mod stretch_dome;
mod u_bend;
mod v_bend;

pub use crate::assess::design as rules;
pub use inputs::{Choice, Kind};
pub use sheet::{FRICTION, SHEET, typical};

use crate::assess::size;
use crate::author::writer::{Values, plain};
use crate::case::CaseError;
use crate::model::Geometry;
use crate::units::{did_you_mean, rounded, significant};
use inputs::{CLEARANCE, HOLDER_PRESSURE, Inputs, NOSE, SHOULDER, STRIP_CLEARANCE};
use rules::Picked;
use sheet::Sheet;
use sizes::{draw_ratio, ensure, nose, throat, warning};
use std::fmt::Write;

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
    text: &'static str,
    /// Derives the values of the placeholders.
    sizes: fn(&Inputs, &Sheet) -> Result<Values, CaseError>,
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

/// Every template.
pub const TEMPLATES: &[Template] = &[
    cup::TEMPLATE,
    hemispherical_cup::TEMPLATE,
    conical_cup::TEMPLATE,
    redraw::TEMPLATE,
    stretch_dome::TEMPLATE,
    bulge::TEMPLATE,
    erichsen::TEMPLATE,
    hat_section::TEMPLATE,
    v_bend::TEMPLATE,
    u_bend::TEMPLATE,
];

/// The template of a name.
///
/// # Errors
/// When there is none; the message names all.
pub fn find(name: &str) -> Result<&'static Template, CaseError> {
    TEMPLATES.iter().find(|template| template.name == name).ok_or_else(|| {
        let names: Vec<&str> = TEMPLATES.iter().map(|template| template.name).collect();
        let meant = did_you_mean(name, names.iter().copied());
        CaseError::bare(format!("there is no template `{name}`"), format!("{meant}there are {}", names.join(", ")))
    })
}

/// All templates with their options, as text.
pub fn list() -> String {
    let sheet = ("every template".to_owned(), SHEET);
    let mut text = String::new();
    for (title, options) in TEMPLATES.iter().map(|t| (format!("{}\n  {}", t.name, t.about), t.own)).chain([sheet]) {
        let _ = writeln!(text, "{title}");
        for choice in options {
            let option = format!("--{} {}", choice.key, choice.kind.placeholder);
            let diameter = choice.diameter.map_or(String::new(), |key| format!("; or --{key}"));
            let _ = writeln!(text, "    {option:<26} {} [{}]{diameter}", choice.about, choice.default);
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len());
    text + "\n"
}
