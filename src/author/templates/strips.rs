//! Strips in plane strain: hat and box sections drawn with a holder, a hat pressed home, and a joggle.

use super::{cup::BLANK, *};
use crate::case::parse;
use crate::measure::part_height;
use crate::model::{Model, Role, tool_sizes::met};
use crate::numerics::interpolated;
use crate::solver::{self, solution::Frame};

const RUNS: usize = 4;
/// Room beside a wall for the tools of a restrike over the thickness \[–\], declared.
const SLIDES: f64 = 0.1;
const CORRECTED: &str = "as runs of this case need";

/// Values of a template for two sizes \[mm\] that runs of its first `stages` correct, each by what the part then `misses` \[mm\].
///
/// A case that does not run to its end keeps the first sizes.
pub(super) fn corrected(
    template: &str, stages: usize, first: [f64; 2], values: impl Fn([f64; 2]) -> Result<Values, CaseError>,
    misses: impl Fn(&Model, &Frame) -> Option<[f64; 2]>,
) -> Result<Values, CaseError> {
    let mut sizes = first;
    for _ in 0..RUNS {
        let Ok(case) = parse(&values(sizes)?.fill(find(template)?.text), template, &[]) else { break };
        let runs = solver::solve(&case.stages[..stages], &mut ());
        let end = runs.last().filter(|run| runs.len() == stages && run.stop.is_complete());
        let Some(missing) = end.and_then(|run| misses(&run.model, run.frames.last()?)) else { return values(first) };
        sizes = [sizes[0] + missing[0], sizes[1] + missing[1]];
    }
    values(sizes)
}

/// Sets a pad on the bottom's flat \[mm\], or keeps the note that there is none; and the tolerance of the angle.
pub(super) fn pad(sizes: &mut Values, inputs: &Inputs, flat: f64) {
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
    corrected("box-section", 1, [first[0] + trim.value, first[1]], values, |_, end| {
        let higher = height - part_height(end)?;
        Some(match flange {
            Some(flange) => [flat + flange + trim.value - end.nodes.last()?.r + higher, higher],
            None => [higher + trim.value, 0.0],
        })
    })
}

/// Steps of a tool from z = 0 on the symmetry plane, and the length of its step along the middle of its bends \[mm\]: a flat, a bend of `radius`, a
/// hollow one, and a flat up to `far` that begins `length` further out and is `depth` lower.
pub(super) fn stepped(
    flat: f64, [length, depth]: [f64; 2], [radius, hollow]: [f64; 2], far: f64,
) -> Result<(Vec<Step>, f64), CaseError> {
    let (radii, end) = (radius + hollow, flat + length);
    let bent = depth.min(radii);
    let least = (bent * (2.0 * radii - bent)).sqrt();
    let [long, deep, least_long] = [length, depth, least].map(plain);
    let what = || format!("a step {long} long and {deep} deep has no room for its bends, {least_long}");
    ensure(length >= least, what, "make --length larger, or --radius or --depth smaller")?;
    let straight = (length.powi(2) + depth.powi(2) - 2.0 * radii * depth).max(0.0).sqrt();
    let angle = length.atan2(radii - depth) - straight.atan2(radii);
    let (sin, cos) = angle.sin_cos();
    let [first, second] = [Point::new(flat, -radius), Point::new(end, hollow - depth)];
    let mut steps = vec![
        (Point::new(flat, 0.0), None),
        (first + radius * Point::new(sin, cos), Some((first, false))),
        (second - hollow * Point::new(sin, cos), None),
        (Point::new(end, -depth), Some((second, true))),
        (Point::new(far, -depth), None),
    ];
    if straight < 1e-6 {
        steps.remove(2);
    }
    Ok((steps, radii * angle + straight))
}

pub(super) fn joggle(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [depth, flat]) = (sheet.thickness, inputs.values(["depth", "flat"]));
    let radius = inputs.pick("radius", || rules::tool_radius(t));
    let gap = inputs.pick("clearance", || Picked::by(1.05 * t, "1.05 thicknesses, a declared rule of thumb"));
    // Sum of the radii of the bends' middle lines.
    let length = inputs.number("length").unwrap_or(f64::max(4.0 * depth, 2.0 * radius.value + gap.value));
    let [end, hollow] = [flat + length, radius.value + gap.value];
    let tool = |step: f64| stepped(flat, [length, step], [radius.value, hollow], end + 4.0 * flat);
    let values = |[blank, step]: [f64; 2]| {
        let blank = Picked::nearest(blank, BLANK, CORRECTED);
        let mut sizes = sheet.values(true);
        sizes.elements(blank.value, radius.value, 1.0);
        sizes.set("profile", profile_text(Point::zeros(), &tool(step)?.0, exact), &radius.reason("radius: "));
        sizes.set("depth", plain(depth), "");
        sizes.set("length", plain(length), "");
        let travel = Picked::by(step + t - gap.value, "until the tools are closed");
        sizes.lengths([("blank", &blank), ("clearance", &gap), ("travel", &travel)]);
        Ok(sizes)
    };
    corrected("joggle", 2, [2.0 * flat + tool(depth)?.1, depth], values, |_, part| {
        let middle: Vec<_> = part.nodes.iter().map(|node| (node.r, node.z)).collect();
        Some([end + flat - part.nodes.last()?.r, depth - interpolated(&middle, flat) + interpolated(&middle, end)])
    })
}

pub(super) fn hat_section(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [half_width, height, flange]) = (sheet.thickness, inputs.values(["half-width", "height", "flange"]));
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
    inputs.only_with("restrike", "springback")?;
    if let Some(radius) = inputs.number("restrike") {
        let bend = nose.value.min(shoulder.value);
        let what = || format!("a restrike to {} sharpens no bend of {}", plain(radius), plain(bend));
        ensure(radius < bend, what, "make --restrike smaller, or --nose and --shoulder larger")?;
        sizes.elements(blank.value, radius, 1.0);
        sizes.set("pad_too", inputs.number("pad-pressure").map_or("", |_| ", \"pad\""), "");
        restrike(&mut sizes, radius, [half_width, throat.value, height, blank.value], t)?;
    }
    Ok(sizes)
}

/// Sets the tools that press nose and shoulder to a radius \[mm\], and how far the punch goes until they are closed at a
/// thickness: they begin where they touch the sheet, which a run of the draw tells.
fn restrike(sizes: &mut Values, radius: f64, [punch, throat, depth, far]: [f64; 4], t: f64) -> Result<(), CaseError> {
    let (hollow, free) = (radius + t, SLIDES * t);
    let [punch, throat] = [punch - free, throat + free];
    let tool = |wall: f64, bends: [f64; 2]| stepped(wall - bends[0], [radius + hollow, depth], bends, far);
    let (punch, die) = (tool(punch, [radius, hollow])?.0, tool(throat, [hollow, radius])?.0);
    let ends: Vec<_> = std::iter::once(Point::zeros()).chain(die.iter().map(|step| step.0)).collect();
    let inward = |(step, to): (&Step, &Point)| (*to, step.1.map(|(center, left)| (center, !left)));
    let die: Vec<_> = die.iter().zip(&ends).rev().map(inward).collect();
    let why = format!("{SLIDES} thicknesses narrower than that of the draw, the die wider: both slide into the part");
    sizes.set("struck", profile_text(Point::zeros(), &punch, exact), &why);
    sizes.set("struck_die", profile_text(ends[die.len()], &die, exact), "");
    sizes.lengths([("restrike", &Picked::input(radius)), ("move", &Picked::input(depth))]);
    let stages = parse(&sizes.fill(find("hat-section")?.text), "hat-section", &[])?.stages;
    let runs = solver::solve(&stages[..1], &mut ());
    let nodes = runs.last().and_then(|run| run.frames.last()).map_or(&[][..], |frame| &frame.nodes);
    let sheet: Vec<_> = nodes.iter().map(|node| (Point::new(node.r, node.z), 0.5 * node.thickness)).collect();
    let met =
        |role: Role| stages[1].model.tool(role).map_or(0.0, |tool| met(&tool.profile, role.side(), &sheet, [t, 0.0]));
    let way = depth + met(Role::Die) - met(Role::Punch) - 0.02 * t;
    sizes.lengths([("move", &Picked::by(way, "until the tools are closed at 1.02 thicknesses"))]);
    Ok(())
}
