//! Strips in plane strain: hat and box sections drawn with a holder, a joggle, a V bent in air, and a U between punch and die.

use super::{cup::BLANK, *};
use crate::case::parse;
use crate::measure::{Shape, part_height};
use crate::numerics::interpolated;
use crate::solver::{self, solution::Frame};

const RUNS: usize = 4;
const CORRECTED: &str = "as runs of this case need";

/// Values of a template for two sizes \[mm\] that runs of its first `stages` correct, each by what the part then `misses` \[mm\].
///
/// A case that does not run to its end keeps the first sizes.
pub(super) fn corrected(
    template: &str, stages: usize, first: [f64; 2], values: impl Fn([f64; 2]) -> Result<Values, CaseError>,
    misses: impl Fn(&Frame) -> Option<[f64; 2]>,
) -> Result<Values, CaseError> {
    let mut sizes = first;
    for _ in 0..RUNS {
        let Ok(case) = parse(&values(sizes)?.fill(find(template)?.text), template, &[]) else { break };
        let runs = solver::solve(&case.stages[..stages], &mut ());
        let end = runs.last().filter(|run| runs.len() == stages && run.stop.is_complete());
        let Some(missing) = end.and_then(|run| misses(run.frames.last()?)) else { return values(first) };
        sizes = [sizes[0] + missing[0], sizes[1] + missing[1]];
    }
    values(sizes)
}

/// Sets a pad on the bottom's flat \[mm\], or keeps the note that there is none; and the tolerance of the angle.
fn pad(sizes: &mut Values, inputs: &Inputs, flat: f64) {
    if let Some(angle) = inputs.number("springback") {
        sizes.set("springback", format!("\"{} deg\"", rounded(angle.to_degrees())), "");
    }
    match inputs.number("pad-pressure") {
        Some(pressure) => {
            sizes.lengths([("pad", &Picked::by(flat, "the bottom's flat"))]);
            sizes.set("pad_pressure", format!("\"{} MPa\"", rounded(pressure)), "");
        }
        None => sizes.set("no_pad", "", ""),
    }
}

/// Box section that is as high, and whose flange is as wide, as was wanted.
pub(super) fn box_section(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let ([half_width, height], flange) = (inputs.values(["half-width", "height"]), inputs.number("flange"));
    let nose = nose(inputs, sheet, half_width)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let least = nose.value + shoulder.value + 2.0 * t;
    let what = || format!("a height of {} leaves no wall between nose and shoulder, {}", plain(height), plain(least));
    ensure(height >= least, what, "make --height larger, or --nose and --shoulder smaller")?;
    let throat = throat(half_width, &inputs.pick("clearance", || rules::strip_clearance(t)));
    let pressure = inputs.pick("holder-pressure", || rules::strip_pressure(sheet.tensile_strength));
    let flat = throat.value + shoulder.value;
    let trim = inputs.pick("trim", || Picked::by(2.0 * t, "2 thicknesses"));
    let upright = half_width - 2.0 * nose.value + rules::quarter_bend(nose.value, t) + height - t;
    let (size, until, first) = if let Some(flange) = flange {
        let bend = rules::quarter_bend(shoulder.value, t) - shoulder.value - t;
        (format!("with a flange of {}", plain(flange)), CORRECTED, [upright + bend + flange, height - t])
    } else {
        let travel = height + trim.value + shoulder.value + 2.0 * t;
        ("drawn through the die".to_owned(), "far enough for the walls to leave the shoulder", [upright, travel])
    };
    let values = |[blank, travel]: [f64; 2]| {
        let blank = Picked::nearest(blank, BLANK, CORRECTED);
        let mut sizes = sheet.values(false);
        sizes.die(&blank, &throat, &shoulder, nose.value);
        sizes.set("width", plain(2.0 * half_width), "");
        sizes.set("size", format!("{} high, {size}", plain(height)), "");
        sizes.set("trim", plain(trim.value), "");
        pad(&mut sizes, inputs, half_width - nose.value);
        if flange.is_none() {
            sizes.set("through", true, "");
        }
        let travel = Picked::nearest(travel, 0.1, until);
        sizes.lengths([("half_width", &Picked::input(half_width)), ("nose", &nose), ("travel", &travel)]);
        sizes.holder(Geometry::PlaneStrain, [flat, blank.value], &pressure)?;
        Ok(sizes)
    };
    corrected("box-section", 1, [first[0] + trim.value, first[1]], values, |end| {
        let higher = height - part_height(end)?;
        Some(match flange {
            Some(flange) => [flat + flange + trim.value - end.nodes.last()?.r + higher, higher],
            None => [higher + trim.value, 0.0],
        })
    })
}

/// Joggle whose step is as deep, and whose strip is as wide, as was wanted after release.
pub(super) fn joggle(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [depth, flat] = inputs.values(["depth", "flat"]);
    let radius = inputs.pick("radius", || rules::tool_radius(t));
    let gap = inputs.pick("clearance", || Picked::by(1.05 * t, "1.05 thicknesses, a declared rule of thumb"));
    // Sum of the radii of the bends' middle lines.
    let radii = 2.0 * radius.value + gap.value;
    let length = inputs.number("length").unwrap_or(f64::max(4.0 * depth, radii));
    let [end, hollow] = [flat + length, radius.value + gap.value];
    // Straight part between the bends and its angle to the flats, of tools whose step has this depth.
    let straight = |step: f64| (length.powi(2) + step.powi(2) - 2.0 * radii * step).max(0.0).sqrt();
    let angle = |step: f64| length.atan2(radii - step) - straight(step).atan2(radii);
    let values = |[blank, step]: [f64; 2]| {
        let bent = step.min(radii);
        let least = (bent * (2.0 * radii - bent)).sqrt();
        let [long, deep, least_long] = [length, step, least].map(plain);
        let what = || format!("a step {long} long and {deep} deep has no room for its bends, {least_long}");
        ensure(length >= least, what, "make --length larger, or --radius or --depth smaller")?;
        let (sin, cos) = angle(step).sin_cos();
        let [first, second] = [Point::new(flat, -radius.value), Point::new(end, hollow - step)];
        let steps = [
            (Point::new(flat, 0.0), None),
            (first + radius.value * Point::new(sin, cos), Some((first, false))),
            (second - hollow * Point::new(sin, cos), None),
            (Point::new(end, -step), Some((second, true))),
            (Point::new(end + 4.0 * flat, -step), None),
        ];
        let blank = Picked::nearest(blank, BLANK, CORRECTED);
        let mut sizes = sheet.values(true);
        sizes.elements(blank.value, radius.value, 1);
        sizes.set("profile", profile_text(Point::zeros(), &steps, exact), &radius.reason("radius: "));
        sizes.set("depth", plain(depth), "");
        sizes.set("length", plain(length), "");
        let travel = Picked::by(step + t - gap.value, "until the tools are closed");
        sizes.lengths([("blank", &blank), ("clearance", &gap), ("travel", &travel)]);
        Ok(sizes)
    };
    let first = 2.0 * flat + radii * angle(depth) + straight(depth);
    corrected("joggle", 2, [first, depth], values, |part| {
        let middle: Vec<_> = part.nodes.iter().map(|node| (node.r, node.z)).collect();
        Some([end + flat - part.nodes.last()?.r, depth - interpolated(&middle, flat) + interpolated(&middle, end)])
    })
}

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
    let length = half_width - nose.value + nose_bend + (height - least) + shoulder_bend + flange;
    let blank = Picked::nearest(length, BLANK, "bottom, two bends, wall and flange along the mid-surface");
    let throat = throat(half_width, &inputs.pick("clearance", || rules::strip_clearance(t)));
    let mut sizes = sheet.values(springback.is_some());
    sizes.die(&blank, &throat, &shoulder, nose.value);
    sizes.set("width", plain(2.0 * half_width), "");
    let release = if springback.is_some() { " and then let go." } else { ". For its spring-back give --springback." };
    sizes.set("release", release, "");
    sizes.lengths([("half_width", &Picked::input(half_width)), ("nose", &nose)]);
    sizes.lengths([("travel", &Picked::by(height, "the depth that is wanted"))]);
    let press = press.map(|force| ("press", newtons(force)));
    let given = depth.map(|depth| ("depth", mm(depth))).into_iter().chain(press);
    given.for_each(|(name, value)| sizes.set(name, value, ""));
    pad(&mut sizes, inputs, half_width - nose.value);
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
    // Straight legs from nose to shoulder.
    let radii = nose.value + shoulder.value + t;
    let travel = |turn: f64| radii + (reach * turn.sin() - radii) / turn.cos();
    let what = || format!("{degrees:.1}° takes {} of travel over a V {wide} wide: no bend", plain(travel(turn)));
    ensure(travel(turn) >= t, what, help)?;
    let leg = inputs.number("leg").unwrap_or(reach);
    let why = "longer than the way to the V's shoulders along the bent leg";
    let blank = Picked::nearest(reach / turn.cos() + leg, BLANK, why);
    let values = |[travel, _]: [f64; 2]| {
        let travel = Picked::by(travel, "runs of this case have the wanted angle there, before they spring back");
        let mut sizes = sheet.values(true);
        sizes.die(&blank, &throat, &shoulder, nose.value);
        sizes.set("degrees", format!("{:.0}", angle.to_degrees()), "");
        sizes.set("angle", format!("\"{degrees} deg\""), "");
        sizes.lengths([("radius", &nose), ("travel", &travel)]);
        Ok(sizes)
    };
    corrected("v-bend", 1, [travel(turn), 0.0], values, |bent| {
        let opening = Shape::of(bent).opening_angle()?;
        Some([travel(turn) - travel(0.5 * (180.0 - opening).to_radians()), 0.0])
    })
}

pub(super) fn u_bend(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let [half_width, leg] = inputs.values(["half-width", "leg"]);
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
