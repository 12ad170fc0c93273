//! A cup with a hemispherical bottom and a flange.

use super::sizes::round_pressure;
use super::*;
use std::f64::consts::PI;

pub(super) const TEMPLATE: Template = Template {
    name: "hemispherical-cup",
    about: "a cup with a hemispherical bottom, drawn to a wanted depth with a flange left",
    own: &[
        Choice::length("punch-radius", "30 mm", "radius of the punch and its nose").or_diameter("punch-diameter"),
        Choice::length("height", "32 mm", "depth: the punch's travel, up to the flange"),
        Choice::length("flange", "6 mm", "width of flat flange left at the end"),
        SHOULDER,
        CLEARANCE,
        HOLDER_PRESSURE,
    ],
    text: include_str!("hemispherical_cup.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [radius, height, flange] = ["punch-radius", "height", "flange"].map(|key| inputs.value(key));
    let what = || format!("a depth of {} is less than half the punch's radius: no cup, but a dome", plain(height));
    ensure(height >= 0.5 * radius, what, "make --height larger, or stretch it: stampflow new stretch-dome")?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let middle = radius + 0.5 * t;
    let blank_for = |height: f64, clearance: f64| {
        let edge = radius + clearance + shoulder.value + flange;
        rules::blank_of(2.0 * PI * middle * height + PI * (edge * edge - middle * middle))
    };
    // The blank and the clearance depend on each other: the ratio is that of a clearance t.
    let ratio = draw_ratio(|height| blank_for(height, t), height, radius, "a smaller --flange")?;
    let clearance = inputs.pick("clearance", || rules::drawing_clearance(t, ratio));
    let why = "half of D, D² = 4 d h + D_f² − d²: the mid-surface keeps its area (Guldin), flange diameter D_f";
    let blank = Picked::by(blank_for(height, clearance.value), why);
    let throat = throat(radius, &clearance);
    let flat = [throat.value + shoulder.value, blank.value];
    let mut sizes = sheet.values(false);
    sizes.elements(blank.value, shoulder.value, 1);
    sizes.set("warning", warning(ratio), "");
    sizes.set("diameter", plain(2.0 * radius), "");
    sizes.lengths([("blank", &blank), ("radius", &Picked::input(radius))]);
    sizes.lengths([("travel", &Picked::by(height, "the depth that is wanted"))]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    let pressure = round_pressure(inputs, sheet, blank.value / radius, radius, flat);
    sizes.holder(Geometry::Axisymmetric, flat, &pressure)?;
    Ok(sizes)
}
