//! A strip bent into a U between punch and die, and let go.

use super::inputs::{Choice, Inputs, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{NOSE, SHOULDER, Tools, bend, flat_punch, nose_fits, throat};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;

pub(super) const TEMPLATE: Template = Template::new(
    "u-bend",
    "a strip (plane strain) bent into a U without a holder, and its spring-back",
    OPTIONS,
    write,
);

const OPTIONS: &[Choice] = &[
    Choice::length("half-width", Value("20 mm"), "half-width of the punch"),
    Choice::length("leg", Value("25 mm"), "height of the legs, outside of the bottom to their ends"),
    NOSE,
    SHOULDER,
    Choice::length("clearance", Rule("1.1 thicknesses"), "gap between punch and die"),
];

/// What to expect of the bottom.
const NO_PAD: &str =
    "no pad holds the bottom of the U, which bows off the punch's face and stays bowed when it is let go";

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let (half_width, leg) = (inputs.value("half-width"), inputs.value("leg"));
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    nose_fits(nose.value, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let clearance = inputs.pick("clearance", || rules::strip_clearance(t));
    let blank = Picked::by(
        half_width - nose.value + rules::quarter_bend(nose.value, t) + leg - t - nose.value,
        "half of the bottom, the bend and the leg along the mid-surface, which keeps its length",
    );
    let throat = throat("punch", half_width, &clearance);
    let least = throat.value + shoulder.value + 2.0 * t;
    if blank.value < least {
        let what = format!(
            "a leg of {} makes a strip of {}, which hardly rests on the die's shoulder, up to {}",
            plain(leg),
            plain(blank.value),
            plain(least)
        );
        return Err(CaseError::bare(what, "make --leg larger, or --shoulder or --clearance smaller".into()));
    }
    let tools = Tools {
        geometry: Geometry::PlaneStrain,
        punch: flat_punch("half_width", half_width, &nose),
        travel: rules::upright_travel(nose.value, shoulder.value, t),
        throat,
        shoulder,
        holder: None,
    };

    let mut page = begin(
        "One half of a strip that is bent into a U and then let go.",
        &format!("U-bend, punch {} wide", plain(2.0 * half_width)),
        Geometry::PlaneStrain,
        &[sheet.notes("a made-up bend"), vec![NO_PAD.to_owned()]].concat(),
    );
    bend(&mut page, &sheet, &blank, nose.value, &tools);
    Ok(page.text())
}
