//! Strips in plane strain: a hat section drawn with a holder, a V bent in air, and a U bent between punch and die.

use super::air_bend::{Strip, travel};
use super::*;

pub(super) fn hat_section(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [half_width, height, flange] = inputs.values(["half-width", "height", "flange"]);
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
    sizes.die(&blank, &throat, &shoulder, nose.value);
    sizes.set("width", plain(2.0 * half_width), "");
    let release = if springback.is_some() { " and then let go." } else { ". For its spring-back give --springback." };
    sizes.set("release", release, "");
    sizes.lengths([("half_width", &Picked::input(half_width)), ("nose", &nose)]);
    sizes.lengths([("travel", &Picked::by(height, "the depth that is wanted"))]);
    let press = press.map(|force| ("press", newtons(force)));
    let tolerance = springback.map(|angle| ("springback", format!("\"{} deg\"", rounded(angle.to_degrees()))));
    let given = depth.map(|depth| ("depth", mm(depth))).into_iter().chain(press).chain(tolerance);
    given.for_each(|(name, value)| sizes.set(name, value, ""));
    let pressure = inputs.pick("holder-pressure", || rules::strip_pressure(sheet.tensile_strength));
    sizes.holder(Geometry::PlaneStrain, [throat.value + shoulder.value, blank.value], &pressure)?;
    Ok(sizes)
}

pub(super) fn v_bend(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let angle = inputs.value("angle");
    let turn = 0.5 * (std::f64::consts::PI - angle);
    // "60 deg" is 59.99999999999999° once it has been a radian.
    let degrees = rounded(angle.to_degrees());
    let what = || format!("an angle of {degrees:.1}° between the legs is none that is bent in air over a V");
    ensure((60.0..=170.0).contains(&degrees), what, "--angle from 60 deg to 170 deg")?;
    let [nose, shoulder] = ["nose", "shoulder"].map(|key| inputs.pick(key, || rules::tool_radius(t)));
    let width = inputs.pick("width", || rules::v_width(nose.value));
    let (reach, wide) = (0.5 * width.value, plain(width.value));
    let why = format!("half of the V's width of {wide} less its shoulder{}", width.reason(", "));
    let throat = Picked::by(reach - shoulder.value, why);
    let help = "make --width larger, or --nose or --shoulder smaller";
    let what =
        || format!("a V {wide} wide between the centres of its shoulders leaves no room for the punch and the sheet");
    ensure(throat.value >= nose.value + t, what, help)?;
    let strip = Strip { thickness: t, elastic: sheet.elastic(), hardening: &sheet.metal.hardening };
    let travel = Picked::by(
        travel(&strip, turn, reach, nose.value, shoulder.value),
        "where legs that bend freely from the nose to the shoulders have the wanted angle, before they spring back",
    );
    let what =
        || format!("an angle of {degrees:.1}° takes {} of travel over a V {wide} wide: no bend", plain(travel.value));
    ensure(travel.value > 0.0 && travel.value >= t, what, help)?;
    let leg = inputs.number("leg").unwrap_or(reach);
    let blank = Picked::by(reach / turn.cos() + leg, "longer than the way to the V's shoulders along the bent leg");
    let mut sizes = sheet.values(true);
    sizes.die(&blank, &throat, &shoulder, nose.value);
    sizes.set("degrees", format!("{:.0}", angle.to_degrees()), "");
    sizes.set("angle", format!("\"{degrees} deg\""), "");
    sizes.lengths([("radius", &nose), ("travel", &travel)]);
    Ok(sizes)
}

pub(super) fn u_bend(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [half_width, leg] = inputs.values(["half-width", "leg"]);
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
    let travel = rules::upright_travel(nose.value, shoulder.value, t);
    let mut sizes = sheet.values(true);
    sizes.die(&blank, &throat, &shoulder, nose.value);
    sizes.set("width", plain(2.0 * half_width), "");
    sizes.lengths([("half_width", &Picked::input(half_width)), ("nose", &nose), ("travel", &travel)]);
    Ok(sizes)
}
