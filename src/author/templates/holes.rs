//! Sheets with a hole: the hole expansion test, and the collar.

use super::{strips::corrected, *};
use crate::measure::part_height;
use crate::units::Amount;

/// Half of the included angle of conical punches, 60° (ISO 16630, not read) \[rad\].
const HALF: f64 = PI / 6.0;

/// Cone \[rad to the axis\], corner and upright wall down to a depth, as TOML; and the depth where the wall begins \[mm\].
pub(super) fn cone(angle: f64, radius: f64, corner: f64, depth: f64) -> (String, f64) {
    let (sin, cos) = angle.sin_cos();
    let upright = (corner + (radius - corner) * cos) / sin;
    let center = Point::new(radius - corner, -upright);
    let steps = [
        (center + corner * Point::new(cos, sin), None),
        (Point::new(radius, -upright), Some((center, false))),
        (Point::new(radius, -upright - depth), None),
    ];
    (profile_text(Point::zeros(), &steps, exact), upright)
}

fn edge(sizes: &mut Values, inputs: &Inputs, hole: &Picked) -> Result<(), CaseError> {
    inputs.only_with("edge-scatter", "edge-limit")?;
    sizes.set("hole_diameter", mm(2.0 * hole.value), &hole.why);
    if let Some(limit) = inputs.number("edge-limit") {
        let [expansion, scatter] = [limit, inputs.value("edge-scatter")].map(|ratio| rounded(100.0 * ratio));
        let text = format!("{{ expansion = \"{expansion} %\", scatter = \"{scatter} %\" }}");
        sizes.set("edge_limit", text, "hole expansion ratio");
    }
    Ok(())
}

pub(super) fn hole_expansion(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [hole, throat]) = (sheet.thickness, inputs.values(["hole", "throat"]));
    let widest = throat - 2.0 * t;
    let what = || format!("a hole of {} leaves no room in a die of {}", plain(2.0 * hole), plain(2.0 * throat));
    ensure(hole >= t && widest >= 2.0 * hole, what, "make --throat larger, or --hole other: a thickness at least")?;
    let most = Amount::share(widest / hole - 1.0);
    let what = || format!("the die of Ø {} lets the hole expand by {most}, not to its edge limit", plain(2.0 * throat));
    let fits = inputs.number("edge-limit").is_none_or(|limit| 100.0 * limit < most.value);
    ensure(fits, what, "make --throat larger, or --hole or --edge-limit smaller")?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let (end, rim) = (throat + shoulder.value, Point::new(throat, -throat / HALF.tan()));
    let travel = inputs.pick("travel", || match inputs.number("edge-limit") {
        Some(_) => Picked::by((widest - hole) / HALF.tan(), "beyond the limit, as far as the die lets the cone"),
        None => Picked::by(inputs.value("travel"), "declared"),
    });
    let mut sizes = sheet.values(false);
    sizes.die(&Picked::by(2.0 * end, "twice what is formed, declared"), &Picked::input(throat), &shoulder, hole);
    sizes.elements(2.0 * end, f64::min(shoulder.value, hole), 1.4);
    edge(&mut sizes, inputs, &Picked::input(hole))?;
    sizes.set("punch", profile_text(Point::zeros(), &[(rim, None)], exact), "");
    sizes.set("clamp", newtons(inputs.value("clamp")), "");
    sizes.lengths([("holder", &Picked::by(end, "where the die's shoulder ends")), ("travel", &travel)]);
    Ok(sizes)
}

pub(super) fn collar(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [radius, height]) = (sheet.thickness, inputs.values(["radius", "height"]));
    let nose = nose(inputs, sheet, radius)?;
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    let clearance = inputs.pick("clearance", || Picked::by(t, "a thickness, the rim is thinner"));
    let shape = inputs.name("punch").unwrap_or("flat");
    let what = || format!("no punch is {shape}");
    ensure(["flat", "conical", "spherical"].contains(&shape), what, "--punch flat, conical or spherical")?;
    let throat = throat(radius, &clearance);
    let end = throat.value + shoulder.value;
    let upright = height - shoulder.value - t;
    let what = || format!("a height of {} leaves no wall above the die's shoulder", plain(height));
    ensure(upright >= t, what, "make --height larger or --shoulder smaller")?;
    // The middle keeps its length, an ironed wall its volume.
    let share = f64::min(1.0, clearance.value / t);
    let first = end - rules::quarter_bend(shoulder.value, t) - share * upright;
    let what = || format!("no hole is left for a collar {} high", plain(height));
    ensure(first >= t, what, "make --height or --shoulder smaller, or --radius larger")?;
    let values = |[hole, _]: [f64; 2]| {
        let (cone, upright) = cone(HALF, radius, nose.value, 4.0 * height);
        // Depth of its wall below where a punch is placed: a cone on the edge of the hole, others with their face on the sheet.
        let (punch, depth) = match shape {
            "conical" => (format!("profile = {cone}"), upright - hole / HALF.tan()),
            "spherical" => (format!("hemispherical = {{ radius = {} }}", mm(radius)), radius),
            _ => (format!("flat = {{ radius = {}, nose = {} }}", mm(radius), mm(nose.value)), nose.value),
        };
        let mut sizes = sheet.values(false);
        let blank = Picked::by(end, "clamped where the die's shoulder ends, as by a pad");
        sizes.die(&blank, &throat, &shoulder, nose.value);
        sizes.set("diameter", plain(2.0 * radius), "");
        sizes.set("wall_height", plain(height), "");
        sizes.set("punch", punch, "");
        edge(&mut sizes, inputs, &Picked::by(hole, "as runs of this case need for the height"))?;
        let travel = Picked::by(depth + height + 2.0 * t, "its wall comes 2 thicknesses past the rim");
        sizes.lengths([("travel", &travel)]);
        Ok(sizes)
    };
    corrected("collar", 1, [first, 0.0], values, |_, end| Some([share * (part_height(end)? - height), 0.0]))
}
