//! A clamped sheet stretched over a hemispherical punch.

use super::inputs::{Choice, Inputs, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{SHOULDER, Tools, draw, round_punch, throat};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;

pub(super) const TEMPLATE: Template =
    Template::new("stretch-dome", "a clamped sheet stretched over a hemispherical punch", OPTIONS, write);

const OPTIONS: &[Choice] = &[
    Choice::radius("punch-radius", "punch-diameter", Value("50 mm"), "radius of the punch, half its diameter"),
    Choice::length("height", Rule("half the punch's radius"), "height of the dome: the punch's travel"),
    SHOULDER,
    Choice::length("clearance", Rule("2 thicknesses"), "gap between punch and die"),
];

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let radius = inputs.value("punch-radius");
    let height = inputs.pick("height", || {
        Picked::by(0.5 * radius, "half the punch's radius: mild steel does not tear yet (declared)")
    });
    if height.value > radius {
        let what =
            format!("a dome {} high is higher than its punch's radius of {}", plain(height.value), plain(radius));
        return Err(CaseError::bare(
            what,
            "no clamped sheet stretches so far: draw it, stampflow new hemispherical-cup".into(),
        ));
    }
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let clearance = inputs
        .pick("clearance", || Picked::by(2.0 * t, "2 thicknesses, declared: the sheet does not go between the walls"));
    let throat = throat("punch", radius, &clearance);
    let blank = Picked::by(throat.value + shoulder.value, "clamped where the die's shoulder ends, as by a lock bead");
    let tools = Tools {
        geometry: Geometry::Axisymmetric,
        punch: round_punch(&Picked::given(radius)),
        travel: height,
        throat,
        shoulder,
        holder: None,
    };

    let page = begin(
        "A sheet clamped at its edge and stretched over a hemisphere, as in a test of its formability.",
        &format!("Stretched dome, punch diameter {}", plain(2.0 * radius)),
        Geometry::Axisymmetric,
        &sheet.notes("a made-up dome"),
    );
    Ok(draw(page, &sheet, &blank, tools.shoulder.value, &tools))
}
