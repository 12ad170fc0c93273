//! Clamped sheets: stretched over a dome, bulged by oil, or cupped in Erichsen's test.

use super::*;

/// Radius of Erichsen's specimen and of the die's edge \[mm\] (ISO 20482).
const SPECIMEN: f64 = 45.0;
const EDGE: f64 = 0.75;
/// Thickest sheet of Erichsen's tools \[mm\].
const THICKEST: f64 = 2.0;

pub(super) fn stretch_dome(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
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
    sizes.die(&blank, &throat, &shoulder, f64::INFINITY);
    sizes.set("diameter", plain(2.0 * radius), "");
    sizes.lengths([("radius", &Picked::input(radius)), ("travel", &travel)]);
    Ok(sizes)
}

pub(super) fn bulge(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let t = sheet.thickness;
    let opening = inputs.value("opening");
    inputs.either(["height", "pressure"])?;
    let height = inputs.number("height").unwrap_or(0.4 * opening);
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    // Even biaxial stress over yield stress; at the same plastic work the strain is smaller by it.
    let biaxial = sheet.metal.yield_criterion.biaxial_factor();
    let stress = |strain: f64| biaxial * sheet.metal.hardening.at(strain / biaxial).stress;
    let pressure_at = |height: f64| rules::bulge_pressure(opening, height, t, stress);
    let why =
        format!("p = 2 σ t/R of a spherical cap {} high, t₀/t = (1 + h²/a²)² (Hill 1950, not read)", plain(height));
    let pressure = inputs.pick("pressure", || Picked::by(pressure_at(height), why));
    let largest = (1..=100).map(|i| pressure_at(0.01 * f64::from(i) * opening)).fold(0.0, f64::max);
    let what = || {
        let (height, pressure) = (plain(height), pressure.value);
        format!(
            "the sheet bears {largest:.2} MPa at most: a dome {height} high and a pressure of {pressure:.2} MPa are beyond that, \
             it would burst"
        )
    };
    let is_rising = height <= opening && pressure_at(height) >= pressure_at(0.98 * height);
    ensure(is_rising && pressure.value < largest, what, "make --height or --pressure smaller")?;
    let blank = Picked::by(opening + shoulder.value, "clamped where the die's shoulder ends");
    let mut sizes = sheet.values(false);
    sizes.die(&blank, &Picked::input(opening), &shoulder, f64::INFINITY);
    sizes.set("diameter", plain(2.0 * opening), "");
    sizes.set("pressure", format!("\"{} MPa\"", rounded(pressure.value)), &pressure.why);
    Ok(sizes)
}

pub(super) fn erichsen(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let thickness = plain(sheet.thickness);
    let what = || format!("the ball of 20 mm and its die are for sheets up to {}, found {thickness}", plain(THICKEST));
    let help = "make --thickness smaller; for a thick sheet stampflow new stretch-dome";
    ensure(sheet.thickness <= THICKEST, what, help)?;
    let mut sizes = sheet.values(false);
    sizes.elements(SPECIMEN, EDGE, 1);
    sizes.set("size", &thickness, "");
    sizes.set("clamp", newtons(inputs.value("clamp")), "");
    Ok(sizes)
}
