//! A conical cup with a flat bottom and a flange.

use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{HOLDER_PRESSURE, SHOULDER, Shape, Tools, careful, draw, throat};
use crate::author::page::{mm, plain};
use crate::case::CaseError;
use crate::model::Geometry;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const TEMPLATE: Template = Template::new(
    "conical-cup",
    "a conical cup with a flat bottom, drawn to a wanted depth with a flange left",
    OPTIONS,
    write,
);

const OPTIONS: &[Choice] = &[
    Choice::radius(
        "punch-radius",
        "punch-diameter",
        Value("35 mm"),
        "radius of the cone at its mouth, half its diameter",
    ),
    Choice::new("angle", Kind::Angle, Value("20 deg"), "angle of the wall to the axis"),
    Choice::length("height", Value("25 mm"), "depth: the punch's travel, up to the flange"),
    Choice::length("flange", Value("6 mm"), "width of flat flange left at the end"),
    Choice::length("nose", Rule("6 thicknesses"), "radius between bottom and cone"),
    SHOULDER,
    Choice::length("clearance", Rule("t √β"), "gap between punch and die at the full travel"),
    HOLDER_PRESSURE,
];

/// What the run cannot show.
const FREE_WALL: &str =
    "the wall hangs free between punch and die: a real one may wrinkle there, an axisymmetric run cannot";

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let (mouth, angle, height) = (inputs.value("punch-radius"), inputs.value("angle"), inputs.value("height"));
    let flange = inputs.value("flange");
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    let bottom = mouth - height * angle.tan();
    // The nose begins this far inside of the corner that bottom and cone would make.
    let inside = nose.value * (0.5 * (FRAC_PI_2 - angle)).tan();
    if angle >= 80f64.to_radians() || bottom < inside {
        let what = format!(
            "a wall at {:.1}° to the axis and {} deep narrows from {} at the mouth to {} at the bottom, where the nose takes {}",
            angle.to_degrees(),
            plain(height),
            plain(mouth),
            plain(bottom),
            plain(inside)
        );
        return Err(CaseError::bare(what, "make --height, --angle or --nose smaller, or --punch-radius larger".into()));
    }
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let blank_for = |height: f64, clearance: f64| {
        let bottom = mouth - height * angle.tan();
        let edge = mouth + clearance + shoulder.value + flange;
        let side = height / angle.cos();
        rules::blank_of(PI * bottom * bottom + PI * side * (bottom + mouth) + PI * (edge * edge - mouth * mouth))
    };
    let ratio = rules::draw_ratio(|height| blank_for(height, t), height, mouth, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let blank = Picked::by(
        blank_for(height, clearance.value),
        "half of D, D² = d₁² + 2 s (d₁ + d₂) + D_f² − d₂²: bottom, cone of side s and flange, the sheet keeps its area (Guldin)",
    );
    let throat = throat("mouth", mouth, &clearance);
    let flat = [throat.value + shoulder.value, blank.value];
    let pressure = inputs
        .pick("holder-pressure", || rules::holder_pressure(blank.value / mouth, 2.0 * mouth, flat, t, sheet.strength));
    let tools = Tools {
        geometry: Geometry::Axisymmetric,
        punch: punch(bottom, mouth, angle, &nose),
        travel: Picked::by(height, "the depth that is wanted"),
        throat,
        shoulder,
        holder: None,
    }
    .held(&pressure, blank.value)?;

    let page = begin(
        &format!("A conical cup with a flange left to hold.{}", careful(ratio)),
        &format!("Conical cup, mouth diameter {}", plain(2.0 * mouth)),
        Geometry::Axisymmetric,
        &[sheet.notes("a made-up cup"), vec![FREE_WALL.to_owned()]].concat(),
    );
    Ok(draw(page, &sheet, &blank, tools.shoulder.value.min(nose.value), &tools))
}

/// Bottom, nose, cone up to the mouth, and a straight wall below it.
fn punch(bottom: f64, mouth: f64, angle: f64, nose: &Picked) -> Shape {
    let r = nose.value;
    let flat = bottom - r * (0.5 * (FRAC_PI_2 - angle)).tan();
    let depth = (mouth - bottom) / angle.tan();
    let point = |x: f64, z: f64| format!("[{}, {}]", mm(x), mm(z));
    let steps = [
        format!("{{ from = {} }}", point(0.0, 0.0)),
        format!("{{ to = {} }}", point(flat, 0.0)),
        format!(
            "{{ arc_to = {}, center = {}, turn = \"right\" }}",
            point(flat + r * angle.cos(), -r + r * angle.sin()),
            point(flat, -r)
        ),
        format!("{{ to = {} }}", point(mouth, -depth)),
        format!("{{ to = {} }}", point(mouth, -4.0 * depth)),
    ];
    Shape { key: "profile", value: format!("[\n    {},\n]", steps.join(",\n    ")), why: nose.reason("nose: ") }
}
