//! Case files to begin with: a few wanted sizes, and everything else picked by stated rules.
//!
//! A template is a file, such as `cup.toml`: its inputs, and a case with `<placeholders>`, whose sizes a function derives.
//!
//! ```
//! let cup = stampflow::author::templates::find("cup")?;
//! let text = cup.fill(&[("punch-radius", "40 mm"), ("height", "35 mm")])?;
//! let case = stampflow::case::parse(&text, "cup.toml", &[])?;
//! assert_eq!(case.model().blank.thickness, 1.0);
//! # Ok::<(), stampflow::case::CaseError>(())
//! ```

mod bends;
mod clamped;
mod cup;
mod cups;
mod holes;
mod inputs;
mod sheet;
mod sizes;
mod strips;
mod tubes;

pub use crate::rules;
pub use inputs::Choice;
pub(super) use inputs::Inputs;
pub(super) use sheet::{LAW, Sheet, elastic, mild_steel};

use crate::assess::size;
use crate::case::CaseError;
use crate::geometry::Point;
use crate::model::Geometry;
use crate::units::{did_you_mean, joined, rounded, rounded_up, significant, trimmed};
use crate::writer::{Step, Values, exact, mm, plain, profile_text};
use rules::Picked;
use serde::Deserialize;
use sizes::{draw_ratio, ensure, newtons, nose, throat};
use std::{f64::consts::PI, fmt::Write, sync::LazyLock};

type Sizes = fn(&Inputs, &Sheet) -> Result<Values, CaseError>;

/// Kind of case that is written from a few sizes.
#[derive(Clone, Debug)]
pub struct Template {
    /// Name, as `stampflow new` takes it.
    pub name: &'static str,
    /// Description in one line.
    pub about: String,
    /// Its own options; those of the sheet come on top.
    pub own: Vec<Choice>,
    text: &'static str,
    sizes: Sizes,
}

#[derive(Deserialize)]
struct Header {
    #[serde(default)]
    about: String,
    inputs: Vec<Choice>,
}

/// Every template.
pub static TEMPLATES: LazyLock<Vec<Template>> = LazyLock::new(|| {
    let files: [(&str, &str, Sizes); 20] = [
        ("cup", include_str!("cup.toml"), cup::cup::<1>),
        ("redraw", include_str!("redraw.toml"), cup::cup::<2>),
        ("hemispherical-cup", include_str!("hemispherical_cup.toml"), cups::hemispherical),
        ("conical-cup", include_str!("conical_cup.toml"), cups::conical),
        ("stretch-dome", include_str!("stretch_dome.toml"), clamped::stretch_dome),
        ("bulge", include_str!("bulge.toml"), clamped::bulge),
        ("hydroform", include_str!("hydroform.toml"), clamped::hydroform),
        ("emboss", include_str!("emboss.toml"), clamped::emboss),
        ("erichsen", include_str!("erichsen.toml"), clamped::erichsen),
        ("hole-expansion", include_str!("hole_expansion.toml"), holes::hole_expansion),
        ("collar", include_str!("collar.toml"), holes::collar),
        ("tube-end", include_str!("tube_end.toml"), tubes::end),
        ("tube-inversion", include_str!("tube_inversion.toml"), tubes::inversion),
        ("tube-bulge", include_str!("tube_bulge.toml"), tubes::bulge),
        ("hat-section", include_str!("hat_section.toml"), strips::hat_section),
        ("box-section", include_str!("box_section.toml"), strips::box_section),
        ("joggle", include_str!("joggle.toml"), strips::joggle),
        ("v-bend", include_str!("v_bend.toml"), bends::v_bend),
        ("stretch-bend", include_str!("stretch_bend.toml"), bends::stretch_bend),
        ("u-bend", include_str!("u_bend.toml"), bends::u_bend),
    ];
    // A case of the kind before it has no text of its own.
    let mut before = "";
    let template = |(name, file, sizes): (&'static str, &'static str, Sizes)| {
        let (Header { about, inputs }, text) = header(file);
        let text = if text.is_empty() { before } else { text };
        before = text;
        Template { name, about, own: inputs, text, sizes }
    };
    files.map(template).into()
});

pub(super) static SHEET: LazyLock<(Vec<Choice>, &'static str)> = LazyLock::new(|| {
    let (header, text) = header(include_str!("sheet.toml"));
    (header.inputs, text)
});

fn header(file: &'static str) -> (Header, &'static str) {
    let (header, text) = file.split_once("---\n").expect("a header and a text");
    (toml::from_str(header).expect("the header is well written"), text)
}

impl Template {
    /// All options, those of the sheet last.
    pub fn options(&self) -> impl Iterator<Item = &Choice> {
        self.own.iter().chain(&SHEET.0)
    }

    /// Writes the text of a case file from option names and their values with units.
    /// Fails when an option is unknown, a value is not of its kind, sizes do not fit each other, or the blank is too wide.
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
        let (width, most) = (size::across(case.model()), rules::WIDEST);
        let what =
            || format!("a blank {} wide is odd: stampings are up to {}", plain(significant(width, 3)), plain(most));
        ensure(width <= most, what, &format!("are the units right? given: {with}"))?;
        Ok(text)
    }
}

/// Returns the template of a name. Fails when there is none; the message names all.
pub fn find(name: &str) -> Result<&'static Template, CaseError> {
    TEMPLATES.iter().find(|template| template.name == name).ok_or_else(|| {
        let names: Vec<&str> = TEMPLATES.iter().map(|template| template.name).collect();
        let meant = did_you_mean(name, names.iter().copied());
        CaseError::bare(format!("there is no template `{name}`"), format!("{meant}there are {}", names.join(", ")))
    })
}

/// All templates with their options, as text.
pub fn list() -> String {
    let groups = TEMPLATES.iter().map(|t| (format!("{}\n  {}", t.name, t.about), &t.own));
    let mut text = String::new();
    for (title, options) in groups.chain([("every template".to_owned(), &SHEET.0)]) {
        let _ = writeln!(text, "{title}");
        for Choice { key, value, default, about, diameter } in options {
            let diameter = diameter.as_ref().map_or(String::new(), |key| format!("; or --{key}"));
            let option = format!("--{key} {value}").replace(" SWITCH", "");
            let _ = writeln!(text, "    {option:<26} {about} [{default}]{diameter}");
        }
        text.push('\n');
    }
    text.trim_end().to_owned() + "\n"
}
