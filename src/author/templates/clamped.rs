//! Clamped sheets: stretched over a dome, bulged by oil, free or into a die, embossed, or cupped in Erichsen's test.

use super::{strips::stepped, *};

/// Radius of Erichsen's specimen and of the die's edge \[mm\] (ISO 20482).
const SPECIMEN: f64 = 45.0;
const EDGE: f64 = 0.75;
/// Thickest sheet of Erichsen's tools \[mm\].
const THICKEST: f64 = 2.0;

pub(super) fn stretch_dome(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, radius) = (sheet.thickness, inputs.value("punch-radius"));
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
    let (t, opening) = (sheet.thickness, inputs.value("opening"));
    inputs.either(["height", "pressure"])?;
    let height = inputs.number("height").unwrap_or(0.4 * opening);
    let shoulder = inputs.pick("shoulder", || rules::tool_radius(t));
    // Even biaxial stress over yield stress; at the same plastic work the strain is smaller by it.
    let biaxial = sheet.metal.yield_criterion.biaxial_factor();
    let stress = |strain: f64| biaxial * sheet.metal.hardening.at(strain / biaxial).stress;
    let pressure_at = |height: f64| rules::bulge_pressure(opening, height, t, stress);
    let why = format!("p = 2 σ t/R of a cap {} high, t₀/t = (1 + h²/a²)² (Hill 1950, not read)", plain(height));
    let pressure = inputs.pick("pressure", || Picked::by(pressure_at(height), why));
    let largest = (1..=100).map(|i| pressure_at(0.01 * f64::from(i) * opening)).fold(0.0, f64::max);
    let what = || {
        let (height, pressure) = (plain(height), pressure.value);
        format!("the sheet bears {largest:.2} MPa: with a dome {height} high or {pressure:.2} MPa it would burst")
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

pub(super) fn hydroform(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [opening, depth]) = (sheet.thickness, inputs.values(["opening", "depth"]));
    let [corner, shoulder] = ["corner", "shoulder"].map(|key| inputs.pick(key, || rules::tool_radius(t)));
    let (r, edge) = (corner.value, opening + shoulder.value);
    let [deep, least, wide] = [depth, r + shoulder.value, 2.0 * opening].map(plain);
    let what = || format!("a cavity {deep} deep and Ø {wide} has no room for the radii of edge and corner, {least}");
    let help = "make --corner or --shoulder smaller, or --depth larger";
    ensure(depth >= r + shoulder.value && r <= opening, what, help)?;
    let grown = (1.0 + 2.0 * depth / opening).ln();
    let why = "σ t/r of the corner, with the flow stress where the area has grown from disc to sharp-cornered cavity";
    let pressure = inputs.pick("pressure", || Picked::by(rules::filling_pressure(&sheet.metal, grown, t, r), why));
    let (down, into) = (Point::new(opening, shoulder.value), Point::new(opening, depth - r));
    let wall = (into.y > down.y + 1e-6).then_some((into, None));
    let onto = [(Point::new(edge, 0.0), None), (down, Some((Point::new(edge, down.y), false)))];
    let middle = Point::new(opening - r, into.y);
    let along = [(middle + r * Point::y(), Some((middle, true))), (Point::new(0.0, depth), None)];
    let steps: Vec<_> = onto.into_iter().chain(wall).chain(along).collect();
    let mut sizes = sheet.values(false);
    sizes.elements(edge, r.min(shoulder.value), 1.0);
    sizes.set("die", profile_text(Point::new(2.0 * edge, 0.0), &steps, exact), &corner.reason("corner: "));
    sizes.set("diameter", wide, "");
    sizes.set("deep", deep, "");
    sizes.set("pressure", format!("\"{} MPa\"", rounded(pressure.value)), &pressure.why);
    sizes.lengths([("blank", &Picked::by(edge, "clamped where the die's edge ends"))]);
    Ok(sizes)
}

pub(super) fn emboss(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [boss, depth]) = (sheet.thickness, inputs.values(["boss", "depth"]));
    let radius = inputs.pick("radius", || rules::tool_radius(t));
    let flat = inputs.pick("flat", || Picked::by(10.0 * t, "10 thicknesses around the boss, declared"));
    let (bends, far) = ([radius.value, radius.value + t], boss + flat.value);
    let [wide, deep] = [2.0 * boss, depth].map(plain);
    let shape = inputs.name("shape").unwrap_or("flat");
    ensure(["flat", "dome"].contains(&shape), || format!("no boss is {shape}"), "--shape flat or dome")?;
    let punch = if shape == "dome" {
        inputs.either(["shape", "length"])?;
        // Radius of the dome and of the hollow bend at its foot, whose centres and ends are in line.
        let both = (boss * boss + depth * depth) / (2.0 * depth);
        let dome = both - bends[1];
        let what = || format!("a dome Ø {wide} and {deep} deep lacks room for a bend at its foot, {}", plain(bends[1]));
        ensure(depth < boss && dome > bends[1], what, "make --depth or --radius smaller")?;
        let end = dome / both * Point::new(boss, -depth);
        let steps = [
            (end, Some((Point::new(0.0, -dome), false))),
            (Point::new(boss, -depth), Some((Point::new(boss, bends[1] - depth), true))),
            (Point::new(far, -depth), None),
        ];
        profile_text(Point::zeros(), &steps, exact)
    } else {
        let radii = bends[0] + bends[1];
        let bent = depth.min(radii);
        let length = inputs.number("length").unwrap_or(f64::max(2.0 * depth, (bent * (2.0 * radii - bent)).sqrt()));
        let what = || format!("a flank {} wide leaves no flat of a boss Ø {wide}", plain(length));
        ensure(length < boss, what, "make --boss larger, or --depth, --radius or --length smaller")?;
        profile_text(Point::zeros(), &stepped(boss - length, [length, depth], bends, far)?.0, exact)
    };
    let mut sizes = sheet.values(false);
    sizes.elements(far, radius.value, 1.0);
    sizes.set("profile", punch, &radius.reason("bends: "));
    sizes.set("diameter", wide, "");
    sizes.set("deep", deep, "");
    sizes.lengths([
        ("blank", &Picked { value: far, why: flat.why }),
        ("travel", &Picked::by(depth, "until the tools are closed at a thickness")),
    ]);
    Ok(sizes)
}

pub(super) fn erichsen(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let thickness = plain(sheet.thickness);
    let what = || format!("the ball of 20 mm and its die are for sheets up to {}, found {thickness}", plain(THICKEST));
    let help = "make --thickness smaller; for a thick sheet stampflow new stretch-dome";
    ensure(sheet.thickness <= THICKEST, what, help)?;
    let mut sizes = sheet.values(false);
    // A third of equal elements, and those around the die's edge, on its arc and one to each side.
    sizes.elements(SPECIMEN / 3.0 + PI * EDGE, EDGE, 1.0);
    sizes.set("size", &thickness, "");
    sizes.set("clamp", newtons(inputs.value("clamp")), "");
    Ok(sizes)
}
