//! A clamped sheet stretched over a hemispherical punch.

use super::*;

pub(super) const TEMPLATE: Template = Template {
    name: "stretch-dome",
    about: "a clamped sheet stretched over a hemispherical punch",
    own: &[
        Choice::length("punch-radius", "50 mm", "radius of the punch, half its diameter").or_diameter("punch-diameter"),
        Choice::length("height", "half the punch's radius", "height of the dome: the punch's travel"),
        SHOULDER,
        Choice::length("clearance", "2 thicknesses", "gap between punch and die"),
    ],
    text: include_str!("stretch_dome.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let radius = inputs.value("punch-radius");
    let travel = inputs.pick("height", || Picked::by(0.5 * radius, "half the punch's radius, declared"));
    let what = || format!("a dome {} high is higher than its punch's radius of {}", plain(travel.value), plain(radius));
    let help = "no clamped sheet stretches so far: draw it, stampflow new hemispherical-cup";
    ensure(travel.value <= radius, what, help)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let throat = throat(radius, &inputs.pick("clearance", || Picked::by(2.0 * t, "2 thicknesses, declared")));
    let blank = Picked::by(throat.value + shoulder.value, "clamped where the die's shoulder ends, as by a lock bead");
    let mut sizes = sheet.values(false);
    sizes.elements(blank.value, shoulder.value, 1);
    sizes.set("diameter", plain(2.0 * radius), "");
    sizes.lengths([("blank", &blank), ("radius", &Picked::input(radius)), ("travel", &travel)]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    Ok(sizes)
}
