//! A strip bent in air over a V, and let go.

use super::air_bend::{Strip, travel};
use super::*;

const ANGLE: &str = "angle between the legs under load; released they open by some degrees, as the run says";

pub(super) const TEMPLATE: Template = Template {
    name: "v-bend",
    about: "a strip (plane strain) bent in air to a wanted angle, and its spring-back",
    own: &[
        Choice::new("angle", Kind::ANGLE, "90 deg", ANGLE),
        Choice::length("nose", "6 thicknesses", "radius of the punch's nose"),
        Choice::length("width", "6 noses", "whole width of the V, between the centres of its shoulders"),
        Choice::length("shoulder", "6 thicknesses", "radius of the V's shoulders"),
        Choice::length("leg", "half the V", "length of each leg beyond the V's shoulder"),
    ],
    text: include_str!("v_bend.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let angle = inputs.value("angle");
    let turn = 0.5 * (std::f64::consts::PI - angle);
    // "60 deg" is 59.99999999999999° once it has been a radian.
    let degrees = rounded(angle.to_degrees());
    let what = || format!("an angle of {degrees:.1}° between the legs is none that is bent in air over a V");
    ensure((60.0..=170.0).contains(&degrees), what, "--angle from 60 deg to 170 deg")?;
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let width = inputs.pick("width", || rules::v_width(nose.value));
    let reach = 0.5 * width.value;
    let why = format!("half of the V's width of {} less its shoulder{}", plain(width.value), width.reason(", "));
    let throat = Picked::by(reach - shoulder.value, why);
    let help = "make --width larger, or --nose or --shoulder smaller";
    let what = || {
        let width = plain(width.value);
        format!("a V {width} wide between the centres of its shoulders leaves no room for the punch and the sheet")
    };
    ensure(throat.value >= nose.value + t, what, help)?;
    let strip = Strip { thickness: t, elastic: sheet.elastic(), hardening: &sheet.metal.hardening };
    let travel = Picked::by(
        travel(&strip, turn, reach, nose.value, shoulder.value),
        "where legs that bend freely from the nose to the shoulders have the wanted angle, before they spring back",
    );
    let what = || {
        let [travel, width] = [travel.value, width.value].map(plain);
        format!("an angle of {degrees:.1}° takes {travel} of travel over a V {width} wide: no bend")
    };
    ensure(travel.value > 0.0 && travel.value >= t, what, help)?;
    let leg = inputs.number("leg").unwrap_or(reach);
    let blank = Picked::by(reach / turn.cos() + leg, "longer than the way to the V's shoulders along the bent leg");
    let mut sizes = sheet.values(true);
    sizes.elements(blank.value, shoulder.value.min(nose.value), 1);
    sizes.set("degrees", format!("{:.0}", angle.to_degrees()), "");
    sizes.set("angle", format!("\"{degrees} deg\""), "");
    sizes.lengths([("blank", &blank), ("radius", &nose), ("travel", &travel)]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    Ok(sizes)
}
