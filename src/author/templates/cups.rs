//! Cups with a flange left: hemispherical, or conical.

use super::{sizes::Draw, *};
use rules::LIMITING_RATIO;
use std::f64::consts::FRAC_PI_2;

const ONE_DRAW: (f64, &str) = (LIMITING_RATIO, "the limit of one draw");

pub(super) fn hemispherical(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [radius, height, flange]) = (sheet.thickness, inputs.values(["punch-radius", "height", "flange"]));
    let what = || format!("a depth of {} is less than half the punch's radius: no cup, but a dome", plain(height));
    ensure(height >= 0.5 * radius, what, "make --height larger, or stretch it: stampflow new stretch-dome")?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let middle = radius + 0.5 * t;
    let blank_for = |height: f64, clearance: f64| {
        let edge = radius + clearance + shoulder.value + flange;
        rules::blank_of(2.0 * PI * middle * height + PI * (edge * edge - middle * middle))
    };
    // The blank and the clearance depend on each other: the ratio is that of a clearance t.
    let ratio = draw_ratio(|h| blank_for(h, t), [0.5 * radius, height], radius, ONE_DRAW, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let why = "half of D, D² = 4 d h + D_f² − d²: the mid-surface keeps its area (Guldin), flange diameter D_f";
    let blank = Picked::nearest(blank_for(height, clearance.value), 0.05, why);
    let draw = Draw { punch: radius, corner: f64::INFINITY, ratio, clearance, shoulder, blank };
    let (mut sizes, _) = draw.values(inputs, sheet)?;
    sizes.lengths([("radius", &Picked::input(radius)), ("travel", &Picked::by(height, "the depth that is wanted"))]);
    Ok(sizes)
}

pub(super) fn conical(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [mouth, angle, height, flange] = inputs.values(["punch-radius", "angle", "height", "flange"]);
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    let bottom = mouth - height * angle.tan();
    let nose_width = nose.value * (0.5 * (FRAC_PI_2 - angle)).tan();
    let what = || {
        let [height, mouth, bottom, nose] = [height, mouth, bottom, nose_width].map(plain);
        let angle = angle.to_degrees();
        format!("a wall at {angle:.1}° and {height} deep narrows from {mouth} to {bottom}, where the nose takes {nose}")
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
    let ratio = draw_ratio(|height| blank_for(height, t), [0.0, height], mouth, ONE_DRAW, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let why = "half of D, D² = d₁² + 2 s (d₁ + d₂) + D_f² − d₂²: bottom, cone s and flange keep their area (Guldin)";
    let blank = Picked::nearest(blank_for(height, clearance.value), 0.05, why);
    let draw = Draw { punch: mouth, corner: nose.value, ratio, clearance, shoulder, blank };
    let (mut sizes, _) = draw.values(inputs, sheet)?;
    sizes.set("profile", cone(bottom - nose_width, mouth, height, nose.value, angle), &nose.reason("nose: "));
    sizes.lengths([("travel", &Picked::by(height, "the depth that is wanted"))]);
    Ok(sizes)
}

fn cone(flat: f64, mouth: f64, depth: f64, nose: f64, angle: f64) -> String {
    let nose_end = Point::new(flat + nose * angle.cos(), -nose + nose * angle.sin());
    let steps = [
        (Point::new(flat, 0.0), None),
        (nose_end, Some((Point::new(flat, -nose), false))),
        (Point::new(mouth, -depth), None),
        (Point::new(mouth, -4.0 * depth), None),
    ];
    profile_text(Point::zeros(), &steps, mm)
}
