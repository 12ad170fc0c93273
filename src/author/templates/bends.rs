//! Strips bent in plane strain: a V in air or pressed home, a U between punch and die, and a clamped strip that is stretched too.

use super::{cup::BLANK, strips::corrected, strips::pad, *};
use crate::measure::Shape;

/// Blade or form block as TOML: a nose, and straight flanks at an angle to the sheet \[rad\].
fn wedge(nose: f64, turn: f64, flank: f64) -> String {
    let (sin, cos) = turn.sin_cos();
    let end = nose * Point::new(sin, cos - 1.0);
    let steps = [(end, Some((Point::new(0.0, -nose), false))), (end + flank * Point::new(cos, -sin), None)];
    profile_text(Point::zeros(), &steps, exact)
}

pub(super) fn v_bend(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, angle) = (sheet.thickness, inputs.value("angle"));
    let turn = 0.5 * (PI - angle);
    // "60 deg" is 59.99999999999999° once it has been a radian.
    let degrees = rounded(angle.to_degrees());
    let what = || format!("an angle of {degrees:.1}° between the legs is none that is bent over a V");
    ensure((60.0..=170.0).contains(&degrees), what, "--angle from 60 deg to 170 deg")?;
    let [nose, shoulder] = ["nose", "shoulder"].map(|key| inputs.pick(key, || rules::tool_radius(t)));
    let width = inputs.pick("width", || rules::v_width(nose.value));
    let (reach, wide) = (0.5 * width.value, plain(width.value));
    let why = format!("half of the V's width of {wide} less its shoulder{}", width.reason(", "));
    let throat = Picked::by(reach - shoulder.value, why);
    let help = "make --width larger, or --nose or --shoulder smaller";
    let what = || format!("a V {wide} wide between the centres of its shoulders has no room for punch and sheet");
    ensure(throat.value >= nose.value + t, what, help)?;
    // Straight legs from nose to shoulder.
    let radii = nose.value + shoulder.value + t;
    let travel = |turn: f64| radii + (reach * turn.sin() - radii) / turn.cos();
    let what = || format!("{degrees:.1}° takes {} of travel over a V {wide} wide: no bend", plain(travel(turn)));
    ensure(travel(turn) >= t, what, help)?;
    let leg = inputs.number("leg").unwrap_or(reach);
    let why = "longer than the way to the V's shoulders along the bent leg";
    let blank = Picked::nearest(reach / turn.cos() + leg, BLANK, why);
    let is_bottomed = inputs.is_on("bottom");
    let values = |[travel, _]: [f64; 2]| {
        let mut sizes = sheet.values(true);
        sizes.die(&blank, &throat, &shoulder, nose.value);
        sizes.set("degrees", format!("{:.0}", angle.to_degrees()), "");
        sizes.set("angle", format!("\"{degrees} deg\""), "");
        if is_bottomed {
            sizes.drop(&["throat", "shoulder"]);
            sizes.set("home", "", "");
            sizes.set("blade", wedge(nose.value, turn, blank.value), &nose.reason("nose: "));
            let travel = Picked::by(travel, "until the tools are closed at a thickness");
            sizes.lengths([("edge", &shoulder), ("travel", &travel)]);
        } else {
            sizes.set("air", "", "");
            let travel = Picked::by(travel, "runs of this case have the wanted angle there, before they spring back");
            sizes.lengths([("radius", &nose), ("travel", &travel)]);
        }
        Ok(sizes)
    };
    if is_bottomed {
        return values([travel(turn), 0.0]);
    }
    corrected("v-bend", 1, [travel(turn), 0.0], values, |_, bent| {
        Some([travel(turn) - travel(0.5 * (180.0 - Shape::of(bent).opening_angle()?).to_radians()), 0.0])
    })
}

pub(super) fn u_bend(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [half_width, leg]) = (sheet.thickness, inputs.values(["half-width", "leg"]));
    let nose = nose(inputs, sheet, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let length = half_width - nose.value + rules::quarter_bend(nose.value, t) + leg - t - nose.value;
    let blank = Picked::nearest(length, BLANK, "half of the bottom, the bend and the leg along the mid-surface");
    let throat = throat(half_width, &inputs.pick("clearance", || rules::strip_clearance(t)));
    let least = throat.value + shoulder.value + 2.0 * t;
    let what = || {
        let [leg, strip, least] = [leg, blank.value, least].map(plain);
        format!("a leg of {leg} makes a strip of {strip}, which hardly rests on the die's shoulder, up to {least}")
    };
    ensure(blank.value >= least, what, "make --leg larger, or --shoulder or --clearance smaller")?;
    let travel = rules::upright_travel(nose.value, shoulder.value, t);
    let mut sizes = sheet.values(true);
    sizes.die(&blank, &throat, &shoulder, nose.value);
    sizes.set("width", plain(2.0 * half_width), "");
    pad(&mut sizes, inputs, half_width - nose.value);
    sizes.lengths([("half_width", &Picked::input(half_width)), ("nose", &nose), ("travel", &travel)]);
    Ok(sizes)
}

pub(super) fn stretch_bend(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [angle, radius]) = (sheet.thickness, inputs.values(["angle", "radius"]));
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let (turn, degrees) = (0.5 * (PI - angle), rounded(angle.to_degrees()));
    let what = || format!("an angle of {degrees:.1}° between the legs is none that a clamped strip is bent to");
    ensure((60.0..=175.0).contains(&degrees), what, "--angle from 60 deg to 175 deg")?;
    // Clamps next to the block, and far away.
    let [least, most] = [turn / turn.sin() - 1.0, 1.0 / turn.cos() - 1.0];
    let why = "geometric mean of the least and the most that the angle allows";
    let stretch = inputs.pick("stretch", || Picked { value: (least * most).sqrt(), why: why.into() });
    let percent = |share: f64| format!("{} %", significant(100.0 * share, 3));
    let [low, high, wanted] = [least, most, stretch.value].map(percent);
    let what = || format!("a bend of {degrees:.1}° stretches a clamped strip by {low} to {high}, not by {wanted}");
    ensure(stretch.value > least && stretch.value < most, what, "give --stretch between, or another --angle")?;
    let radii = radius + shoulder.value + t;
    let reach = radii * (turn.tan() - turn) / (most - stretch.value);
    let what = || format!("clamps {} from the middle lack room for edges of {}", plain(reach), plain(shoulder.value));
    let help = "make --shoulder smaller, or --radius or --stretch larger, or --angle smaller";
    ensure(reach > shoulder.value + t, what, help)?;
    let why = format!("clamped where the shoulder ends, which stretches it by {wanted}{}", stretch.reason(", "));
    let throat = Picked::by(reach - shoulder.value, "up to the shoulder of the clamps");
    let mut sizes = sheet.values(true);
    sizes.die(&Picked::by(reach, why), &throat, &shoulder, radius);
    sizes.set("radius", plain(radius), "");
    sizes.set("degrees", degrees, "");
    sizes.set("punch", wedge(radius, turn + 0.15, reach), "");
    let travel = radii + (reach * turn.sin() - radii) / turn.cos();
    let travel = Picked::by(travel, "the legs have the wanted angle, before they spring back");
    sizes.lengths([("travel", &travel)]);
    Ok(sizes)
}
