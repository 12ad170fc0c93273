//! A clamped disc bulged by oil.

use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{SHOULDER, elements};
use crate::author::page::{mm, plain};
use crate::case::CaseError;
use crate::model::Geometry;
use crate::units::rounded;

pub(super) const TEMPLATE: Template =
    Template::new("bulge", "a clamped disc bulged by oil through a round opening", OPTIONS, write);

const OPTIONS: &[Choice] = &[
    Choice::radius("opening", "opening-diameter", Value("50 mm"), "radius of the die's opening, half its diameter"),
    Choice::length("height", Rule("0.4 openings"), "height of the dome that the pressure is for"),
    SHOULDER,
    Choice::new("pressure", Kind::Stress, Rule("of a spherical membrane"), "pressure at the end"),
];

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let opening = inputs.value("opening");
    let height = inputs.given("height").unwrap_or(0.4 * opening);
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    // Stress over yield stress in even biaxial tension; the strain through the thickness is less by that.
    let biaxial = sheet.biaxial_factor();
    // The shoulder's end holds the sheet, its middle lies half a thickness below.
    let pressure_at =
        |height: f64| rules::bulge_pressure(opening, height, t, |strain| biaxial * sheet.stress(strain / biaxial));
    let why = format!(
        "for a dome {} high by membrane theory: p = 2 σ t/R of a spherical cap, t₀/t = (1 + h²/a²)² (Hill 1950, not read)",
        plain(height)
    );
    let pressure = inputs.pick("pressure", || Picked::by(pressure_at(height), why));
    let largest = (1..=100).map(|i| pressure_at(0.01 * f64::from(i) * opening)).fold(0.0, f64::max);
    if height > opening || pressure_at(height) < pressure_at(0.98 * height) || pressure.value >= largest {
        let what = format!(
            "the sheet bears {largest:.2} MPa at most: a dome {} high and a pressure of {:.2} MPa are beyond that, it would burst",
            plain(height),
            pressure.value
        );
        return Err(CaseError::bare(what, "make --height or --pressure smaller".into()));
    }
    let blank = Picked::by(opening + shoulder.value, "clamped where the die's shoulder ends");

    let mut page = begin(
        "Oil alone: a clamped disc bulges under a pressure that rises. There is no punch, so the run has a duration.",
        &format!("Bulge, opening diameter {}", plain(2.0 * opening)),
        Geometry::Axisymmetric,
        &sheet.notes("a made-up bulge test"),
    );
    sheet.blank(&mut page, Geometry::Axisymmetric, &blank);
    page.set("edge", "\"clamped\"", "");
    elements(&mut page, blank.value, shoulder.value);
    sheet.material(&mut page, false);
    sheet.forming_limit(&mut page);
    page.table("tools.die", "");
    page.set("throat", mm(opening), "");
    page.length("shoulder", &shoulder);
    page.set("friction", rounded(sheet.friction), "");
    page.table("gas", "");
    page.set(
        "lower",
        format!("{{ pressure = [[\"0 s\", \"0 MPa\"], [\"10 s\", \"{} MPa\"]] }}", rounded(pressure.value)),
        &pressure.why,
    );
    page.set("duration", "\"10 s\"", "");
    Ok(page.text())
}
