//! A strip bent into a U between punch and die, and let go.

use super::*;

pub(super) const TEMPLATE: Template = Template {
    name: "u-bend",
    about: "a strip (plane strain) bent into a U without a holder, and its spring-back",
    own: &[
        Choice::length("half-width", "20 mm", "half-width of the punch"),
        Choice::length("leg", "25 mm", "height of the legs, outside of the bottom to their ends"),
        NOSE,
        SHOULDER,
        STRIP_CLEARANCE,
    ],
    text: include_str!("u_bend.toml"),
    sizes,
};

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [half_width, leg] = ["half-width", "leg"].map(|key| inputs.value(key));
    let nose = nose(inputs, sheet, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let blank = Picked::by(
        half_width - nose.value + rules::quarter_bend(nose.value, t) + leg - t - nose.value,
        "half of the bottom, the bend and the leg along the mid-surface, which keeps its length",
    );
    let throat = throat(half_width, &inputs.pick("clearance", || rules::strip_clearance(t)));
    let least = throat.value + shoulder.value + 2.0 * t;
    let what = || {
        let [leg, strip, least] = [leg, blank.value, least].map(plain);
        format!("a leg of {leg} makes a strip of {strip}, which hardly rests on the die's shoulder, up to {least}")
    };
    ensure(blank.value >= least, what, "make --leg larger, or --shoulder or --clearance smaller")?;
    let mut sizes = sheet.values(true);
    sizes.elements(blank.value, shoulder.value.min(nose.value), 1);
    sizes.set("width", plain(2.0 * half_width), "");
    sizes.lengths([("blank", &blank), ("half_width", &Picked::input(half_width)), ("nose", &nose)]);
    sizes.lengths([("travel", &rules::upright_travel(nose.value, shoulder.value, t))]);
    sizes.lengths([("throat", &throat), ("shoulder", &shoulder)]);
    Ok(sizes)
}
