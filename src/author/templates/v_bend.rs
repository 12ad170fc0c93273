//! A strip bent in air over a V, and let go.

use super::air_bend::{self, Strip};
use super::inputs::{Choice, Inputs, Kind, Rule, Value};
use super::rules::{self, Picked};
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{Tools, bend, round_punch};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;
use crate::units::rounded;

pub(super) const TEMPLATE: Template = Template::new(
    "v-bend",
    "a strip (plane strain) bent in air to a wanted angle, and its spring-back",
    OPTIONS,
    write,
);

const OPTIONS: &[Choice] = &[
    Choice::new(
        "angle",
        Kind::Angle,
        Value("90 deg"),
        "angle between the legs under load; released they open by some degrees, as the run says",
    ),
    Choice::length("nose", Rule("6 thicknesses"), "radius of the punch's nose"),
    Choice::length("width", Rule("6 noses"), "whole width of the V, between the centres of its shoulders"),
    Choice::length("shoulder", Rule("6 thicknesses"), "radius of the V's shoulders"),
    Choice::length("leg", Rule("half the V"), "length of each leg beyond the V's shoulder"),
];

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    let t = sheet.thickness;
    let angle = inputs.value("angle");
    let turn = 0.5 * (std::f64::consts::PI - angle);
    let [least, most] = [60.0, 170.0];
    // "60 deg" is 59.99999999999999° once it has been a radian.
    if !(least..=most).contains(&rounded(angle.to_degrees())) {
        let what =
            format!("an angle of {:.1}° between the legs is none that is bent in air over a V", angle.to_degrees());
        return Err(CaseError::bare(what, format!("--angle from {least} deg to {most} deg")));
    }
    let nose = inputs.pick("nose", || rules::tool_radius(t));
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let width = inputs.pick("width", || rules::v_width(nose.value));
    let reach = 0.5 * width.value;
    let throat = Picked::by(
        reach - shoulder.value,
        format!("half of the V's width of {} less its shoulder{}", plain(width.value), width.reason(", ")),
    );
    if throat.value < nose.value + t {
        let what = format!(
            "a V {} wide between the centres of its shoulders leaves no room for the punch and the sheet",
            plain(width.value)
        );
        return Err(CaseError::bare(what, "make --width larger, or --nose or --shoulder smaller".into()));
    }
    let leg = inputs.given("leg").unwrap_or(reach);
    let strip = Strip { thickness: t, elastic: sheet.elastic(), stress: &|strain| sheet.stress(strain) };
    let travel = Picked::by(
        air_bend::travel(&strip, turn, reach, nose.value, shoulder.value),
        "where legs that bend freely from the nose to the shoulders have the wanted angle, before they spring back",
    );
    if travel.value <= 0.0 || travel.value < t {
        let what = format!(
            "an angle of {:.1}° takes {} of travel over a V {} wide: no bend",
            angle.to_degrees(),
            plain(travel.value),
            plain(width.value)
        );
        return Err(CaseError::bare(what, "make --width larger, or --nose or --shoulder smaller".into()));
    }
    // From the middle to where the straight leg meets the shoulder's circle, and the leg's end.
    let blank = Picked::by(reach / turn.cos() + leg, "longer than the way to the V's shoulders along the bent leg");
    let tools =
        Tools { geometry: Geometry::PlaneStrain, punch: round_punch(&nose), travel, throat, shoulder, holder: None };

    let mut page = begin(
        "One half of a strip that is bent in air over a V and then let go. The punch is a blade with a round nose.",
        &format!("V-bend, {:.0}°", angle.to_degrees()),
        Geometry::PlaneStrain,
        &sheet.notes("a made-up bend"),
    );
    bend(&mut page, &sheet, &blank, nose.value, &tools);
    let wanted = format!("angle = \"{} deg\"", rounded(angle.to_degrees()));
    page.proposal(&[
        "The wanted angle after release and its tolerance: the verdict then judges it, and says how far to over-bend.",
        "[springback]",
        &wanted,
        "tolerance = \"1 deg\"",
    ]);
    Ok(page.text())
}
