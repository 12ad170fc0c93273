//! A hat section drawn with a holder.

use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{NOSE, SHOULDER, Tools, draw, flat_punch, nose_fits, throat};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;

pub(super) const TEMPLATE: Template =
    Template::new("hat-section", "a hat section (plane strain) drawn to a wanted depth under a holder", OPTIONS, write);

const OPTIONS: &[Choice] = &[
    Choice::length("half-width", Value("30 mm"), "half-width of the punch"),
    Choice::length("height", Value("40 mm"), "depth: the punch's travel, up to the flange"),
    Choice::length("flange", Value("20 mm"), "width of flat flange left at the end"),
    NOSE,
    SHOULDER,
    Choice::length("clearance", Rule("1.1 thicknesses"), "gap between punch and die"),
    Choice::new(
        "holder-pressure",
        Kind::Stress,
        Rule("1 % of the tensile strength"),
        "pressure of the holder on the flange",
    ),
];

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let (half_width, height, flange) = (inputs.value("half-width"), inputs.value("height"), inputs.value("flange"));
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    nose_fits(nose.value, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let least = nose.value + shoulder.value + t;
    if height < least {
        let what = format!("a depth of {} leaves no wall between nose and shoulder, {}", plain(height), plain(least));
        return Err(CaseError::bare(what, "make --height larger, or --nose and --shoulder smaller".into()));
    }
    let clearance = inputs.pick("clearance", || rules::strip_clearance(t));
    let wall = height - least;
    let blank = Picked::by(
        half_width - nose.value
            + rules::quarter_bend(nose.value, t)
            + wall
            + rules::quarter_bend(shoulder.value, t)
            + flange,
        "bottom, two bends, wall and flange along the mid-surface, which keeps its length",
    );
    let pressure = inputs.pick("holder-pressure", || rules::strip_pressure(sheet.strength));
    let tools = Tools {
        geometry: Geometry::PlaneStrain,
        punch: flat_punch("half_width", half_width, &nose),
        travel: Picked::by(height, "the depth that is wanted"),
        throat: throat("punch", half_width, &clearance),
        shoulder,
        holder: None,
    }
    .held(&pressure, blank.value)?;

    let page = begin(
        "One half of a hat section, drawn. By the flow law, which does not spring back: for that see cases/hat_springback.toml, \
         which takes longer, or stampflow new u-bend.",
        &format!("Hat section, punch {} wide", plain(2.0 * half_width)),
        Geometry::PlaneStrain,
        &sheet.notes("a made-up section"),
    );
    Ok(draw(page, &sheet, &blank, tools.shoulder.value.min(nose.value), &tools))
}
