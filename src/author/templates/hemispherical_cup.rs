//! A cup with a hemispherical bottom and a flange.

use super::inputs::{Choice, Inputs, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{HOLDER_PRESSURE, SHOULDER, Tools, careful, draw, round_punch, throat};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;
use std::f64::consts::PI;

pub(super) const TEMPLATE: Template = Template::new(
    "hemispherical-cup",
    "a cup with a hemispherical bottom, drawn to a wanted depth with a flange left",
    OPTIONS,
    write,
);

const OPTIONS: &[Choice] = &[
    Choice::radius(
        "punch-radius",
        "punch-diameter",
        Value("30 mm"),
        "radius of the punch and of its nose, half its diameter",
    ),
    Choice::length("height", Value("32 mm"), "depth: the punch's travel, up to the flange"),
    Choice::length("flange", Value("6 mm"), "width of flat flange left at the end"),
    SHOULDER,
    Choice::length("clearance", Rule("t √β"), "gap between punch and die"),
    HOLDER_PRESSURE,
];

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let (radius, height, flange) = (inputs.value("punch-radius"), inputs.value("height"), inputs.value("flange"));
    if height < 0.5 * radius {
        let what = format!("a depth of {} is less than half the punch's radius: no cup, but a dome", plain(height));
        return Err(CaseError::bare(what, "make --height larger, or stretch it: stampflow new stretch-dome".into()));
    }
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let middle = radius + 0.5 * t;
    // The clearance follows from the ratio and the blank, by the little that the throat is wider, from the clearance.
    let blank_for = |height: f64, clearance: f64| {
        let edge = radius + clearance + shoulder.value + flange;
        rules::blank_of(2.0 * PI * middle * height + PI * (edge * edge - middle * middle))
    };
    let ratio = rules::draw_ratio(|height| blank_for(height, t), height, radius, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let blank = Picked::by(
        blank_for(height, clearance.value),
        "half of D, D² = 4 d h + D_f² − d²: dome, wall and flange of diameter D_f, the mid-surface keeps its area (Guldin)",
    );
    let throat = throat("punch", radius, &clearance);
    let flat = [throat.value + shoulder.value, blank.value];
    let pressure = inputs.pick("holder-pressure", || {
        rules::holder_pressure(blank.value / radius, 2.0 * radius, flat, t, sheet.strength)
    });
    let tools = Tools {
        geometry: Geometry::Axisymmetric,
        punch: round_punch(&Picked::given(radius)),
        travel: Picked::by(height, "the depth that is wanted"),
        throat,
        shoulder,
        holder: None,
    }
    .held(&pressure, blank.value)?;

    let page = begin(
        &format!("A cup with a hemispherical bottom, with a flange left to hold.{}", careful(ratio)),
        &format!("Hemispherical cup, punch diameter {}", plain(2.0 * radius)),
        Geometry::Axisymmetric,
        &sheet.notes("a made-up cup"),
    );
    Ok(draw(page, &sheet, &blank, tools.shoulder.value, &tools))
}
