//! A hat section drawn with a holder.

use super::sizes::newtons;
use super::*;
use crate::author::writer::mm;

const PRESSURE: &str = "1 % of the tensile strength";
const SPRINGBACK: &str = "tolerance of each wall's angle: the sheet is elastic too and let go, which takes longer";

pub(super) const TEMPLATE: Template = Template {
    name: "hat-section",
    about: "a hat section (plane strain) drawn to a wanted depth under a holder",
    own: &[
        Choice::length("half-width", "30 mm", "half-width of the punch"),
        Choice::length("height", "40 mm", "depth: the punch's travel, up to the flange"),
        Choice::length("flange", "20 mm", "width of flat flange left at the end"),
        NOSE,
        SHOULDER,
        STRIP_CLEARANCE,
        Choice { default: PRESSURE, ..HOLDER_PRESSURE },
        Choice::length("length", "forces per mm of depth", "length of the part, over which forces are given"),
        Choice::new("press", Kind::FORCE, "no press", "force of the press, such as 250 tonf; wants --length"),
        Choice::new("springback", Kind::ANGLE, "no spring-back", SPRINGBACK),
    ],
    text: include_str!("hat_section.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [half_width, height, flange] = ["half-width", "height", "flange"].map(|key| inputs.value(key));
    let nose = nose(inputs, sheet, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let least = nose.value + shoulder.value + t;
    let what = || format!("a depth of {} leaves no wall between nose and shoulder, {}", plain(height), plain(least));
    ensure(height >= least, what, "make --height larger, or --nose and --shoulder smaller")?;
    let [depth, press, springback] = ["length", "press", "springback"].map(|key| inputs.number(key));
    let what = || "--press is the force of the whole press, and nothing says how long the part is".to_owned();
    ensure(press.is_none() || depth.is_some(), what, "give --length too, such as --length \"60 in\"")?;
    let [nose_bend, shoulder_bend] = [&nose, &shoulder].map(|radius| rules::quarter_bend(radius.value, t));
    let blank = Picked::by(
        half_width - nose.value + nose_bend + (height - least) + shoulder_bend + flange,
        "bottom, two bends, wall and flange along the mid-surface, which keeps its length",
    );
    let throat = throat(half_width, &inputs.pick("clearance", || rules::strip_clearance(t)));
    let mut sizes = sheet.values(springback.is_some());
    sizes.elements(blank.value, shoulder.value.min(nose.value), 1);
    sizes.set("width", plain(2.0 * half_width), "");
    let release = if springback.is_some() { " and then let go." } else { ". For its spring-back give --springback." };
    sizes.set("release", release, "");
    sizes.lengths([("blank", &blank), ("half_width", &Picked::input(half_width)), ("nose", &nose)]);
    sizes.lengths([("travel", &Picked::by(height, "the depth that is wanted"))]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    depth.into_iter().for_each(|depth| sizes.set("depth", mm(depth), ""));
    press.into_iter().for_each(|force| sizes.set("press", newtons(force), ""));
    if let Some(tolerance) = springback {
        sizes.set("springback", format!("\"{} deg\"", rounded(tolerance.to_degrees())), "");
    }
    let pressure = inputs.pick("holder-pressure", || rules::strip_pressure(sheet.tensile_strength));
    sizes.holder(Geometry::PlaneStrain, [throat.value + shoulder.value, blank.value], &pressure)?;
    Ok(sizes)
}
