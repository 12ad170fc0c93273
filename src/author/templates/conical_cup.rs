//! A conical cup with a flat bottom and a flange.

use super::sizes::round_pressure;
use super::*;
use crate::author::writer::{mm, profile_text};
use crate::geometry::Point;
use std::f64::consts::{FRAC_PI_2, PI};

pub(super) const TEMPLATE: Template = Template {
    name: "conical-cup",
    about: "a conical cup with a flat bottom, drawn to a wanted depth with a flange left",
    own: &[
        Choice::length("punch-radius", "35 mm", "radius of the cone at its mouth").or_diameter("punch-diameter"),
        Choice::new("angle", Kind::ANGLE, "20 deg", "angle of the wall to the axis"),
        Choice::length("height", "25 mm", "depth: the punch's travel, up to the flange"),
        Choice::length("flange", "6 mm", "width of flat flange left at the end"),
        Choice::length("nose", "6 thicknesses", "radius between bottom and cone"),
        SHOULDER,
        Choice::length("clearance", "t √β", "gap between punch and die at the full travel"),
        HOLDER_PRESSURE,
    ],
    text: include_str!("conical_cup.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [mouth, angle, height, flange] = ["punch-radius", "angle", "height", "flange"].map(|key| inputs.value(key));
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    let bottom = mouth - height * angle.tan();
    let nose_width = nose.value * (0.5 * (FRAC_PI_2 - angle)).tan();
    let what = || {
        let (degrees, [height, mouth, bottom, nose]) =
            (angle.to_degrees(), [height, mouth, bottom, nose_width].map(plain));
        format!(
            "a wall at {degrees:.1}° to the axis and {height} deep narrows from {mouth} at the mouth to {bottom} at the bottom, \
             where the nose takes {nose}"
        )
    };
    let help = "make --height, --angle or --nose smaller, or --punch-radius larger";
    ensure(angle < 80f64.to_radians() && bottom >= nose_width, what, help)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let blank_for = |height: f64, clearance: f64| {
        let bottom = mouth - height * angle.tan();
        let edge = mouth + clearance + shoulder.value + flange;
        let side = height / angle.cos();
        rules::blank_of(PI * bottom * bottom + PI * side * (bottom + mouth) + PI * (edge * edge - mouth * mouth))
    };
    let ratio = draw_ratio(|height| blank_for(height, t), height, mouth, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let why =
        "half of D, D² = d₁² + 2 s (d₁ + d₂) + D_f² − d₂²: bottom, cone of side s and flange keep their area (Guldin)";
    let blank = Picked::by(blank_for(height, clearance.value), why);
    let throat = throat(mouth, &clearance);
    let flat = [throat.value + shoulder.value, blank.value];
    let mut sizes = sheet.values(false);
    sizes.elements(blank.value, shoulder.value.min(nose.value), 1);
    sizes.set("warning", warning(ratio), "");
    sizes.set("diameter", plain(2.0 * mouth), "");
    sizes.set("profile", punch(bottom - nose_width, mouth, height, nose.value, angle), &nose.reason("nose: "));
    sizes.lengths([("blank", &blank), ("travel", &Picked::by(height, "the depth that is wanted"))]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    let pressure = round_pressure(inputs, sheet, blank.value / mouth, mouth, flat);
    sizes.holder(Geometry::Axisymmetric, flat, &pressure)?;
    Ok(sizes)
}

/// Flat, nose, cone up to the mouth, and a straight wall below it.
fn punch(flat: f64, mouth: f64, depth: f64, nose: f64, angle: f64) -> String {
    let nose_end = Point::new(flat + nose * angle.cos(), -nose + nose * angle.sin());
    let steps = [
        (Point::new(flat, 0.0), None),
        (nose_end, Some((Point::new(flat, -nose), false))),
        (Point::new(mouth, -depth), None),
        (Point::new(mouth, -4.0 * depth), None),
    ];
    profile_text(Point::zeros(), &steps, mm)
}
