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
mod erichsen;
mod hat_section;
mod hemispherical_cup;
mod inputs;
mod redraw;
pub mod rules;
mod sheet;
mod stretch_dome;
mod template;
mod tools;
mod u_bend;
mod v_bend;

pub use inputs::{Choice, Default, Kind};
pub use sheet::{FRICTION, SHEET, typical};
pub use template::Template;

use crate::case::CaseError;
use crate::units::did_you_mean;
use std::fmt::Write;

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
/// When there is none; the message names those that are there.
pub fn find(name: &str) -> Result<&'static Template, CaseError> {
    TEMPLATES.iter().find(|template| template.name == name).ok_or_else(|| {
        let names: Vec<&str> = TEMPLATES.iter().map(|template| template.name).collect();
        let meant = did_you_mean(name, names.iter().copied());
        CaseError::bare(format!("there is no template `{name}`"), format!("{meant}there are {}", names.join(", ")))
    })
}

/// All templates with their options, as text.
pub fn list() -> String {
    let mut text = String::new();
    let lines = |text: &mut String, options: &[Choice]| {
        for choice in options {
            let option = format!("--{} {}", choice.key, choice.kind.placeholder());
            let across = choice.diameter.map_or(String::new(), |key| format!("; or --{key}"));
            let _ = writeln!(text, "    {option:<26} {} [{}]{across}", choice.about, choice.default.words());
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
