//! Tubes: an end expanded, flared or nosed by a cone or turned inside out, and a middle bulged by oil under feed.

use super::{holes::cone, strips::corrected, *};
use crate::assess::folded;
use crate::measure::outside_diameters;
use crate::units::Amount;
use std::cell::Cell;

/// Share of the size that runs may miss before the last correction, declared \[–\].
const MISSED: f64 = 0.02;

/// Radius outside \[mm\] and values of the case but for its tools; `share` of the length is solved, with elements for a radius.
fn tube(inputs: &Inputs, sheet: &Sheet, share: f64, corner: f64, title: &str) -> Result<(f64, Values), CaseError> {
    let ([outside, length], t) = (inputs.values(["tube", "length"]), sheet.thickness);
    let [across, wall] = [2.0 * outside, t].map(plain);
    let what = || format!("a tube of Ø {across} has no room for two walls of {wall}");
    ensure(outside > 2.0 * t, what, "make --thickness smaller, or --tube larger")?;
    let mut sizes = sheet.values(false);
    sizes.set("title", format!("\"Tube Ø {across}, {title}\""), "");
    sizes.lengths([("diameter", &Picked::input(2.0 * outside)), ("length", &Picked::input(share * length))]);
    sizes.elements(share * length, corner, 1.0);
    Ok((outside, sizes))
}

fn formed(inputs: &Inputs, mut sizes: Values, punch: String, travel: &Picked) -> Result<Values, CaseError> {
    let (length, way) = (inputs.value("length"), plain(rounded_up(travel.value, 3)));
    let what = || format!("the tool would go {way} along a tube of {}", plain(length));
    ensure(travel.value < length, what, "make --length larger, or form less of it")?;
    sizes.set("punch", punch, "");
    sizes.lengths([("travel", travel)]);
    Ok(sizes)
}

pub(super) fn end(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [end, angle], land) = (sheet.thickness, inputs.values(["end", "angle"]), inputs.number("land"));
    let corner = inputs.pick("corner", || rules::tool_radius(t)).value;
    let verb = if end < inputs.value("tube") { "nosed" } else { "formed" };
    let (outside, sizes) = tube(inputs, sheet, 1.0, corner, &format!("end {verb} to Ø {}", plain(2.0 * end)))?;
    let what = || format!("nothing is formed: the tube and its end are both Ø {} outside", plain(2.0 * outside));
    ensure((end - outside).abs() > 0.1 * t, what, "another --end or --tube, by a tenth of the thickness at least")?;
    let what = || format!("a cone of {} to the axis is none", Amount::angle(angle.to_degrees()));
    ensure((0.05..1.4).contains(&angle), what, "--angle between 3° and 80°")?;
    let ((sin, cos), far) = (angle.sin_cos(), 2.0 * inputs.value("length"));
    // A wall that keeps its length goes up the cone by Δr/sin α, beyond the Δr/tan α of its height.
    let first = (end - outside).abs() * (0.5 * angle).tan();
    // Radius outside on the land, and travel beyond that of a wall that keeps its height.
    let values = |[end, further]: [f64; 2]| {
        let (punch, travel, why) = if let (true, Some(land)) = (end > outside, land) {
            let (punch, upright) = cone(angle, end - t, corner, far);
            (punch, upright - (outside - t) / angle.tan() + land, "up the cone and onto its land")
        } else if end > outside {
            let rim = 2.0 * end;
            let punch = profile_text(Point::zeros(), &[(Point::new(rim, -rim / angle.tan()), None)], exact);
            (punch, (end - outside) / angle.tan(), "until the end is as wide, by runs of this case")
        } else {
            // From the land up, round its corner and along the cone.
            let (center, mouth) = (Point::new(end + corner, 0.0), 1.5 * outside);
            let onto = center + corner * Point::new(-cos, sin);
            let rim = Point::new(mouth, onto.y + (mouth - onto.x) / angle.tan());
            let steps = [(Point::new(end, 0.0), None), (onto, Some((center, false))), (rim, None)];
            let punch = profile_text(Point::new(end, -far), &steps, exact);
            let depth = onto.y + (outside - onto.x) / angle.tan();
            (punch, depth + land.unwrap_or(0.0), "along the cone and through the land")
        };
        let most = if further > first { inputs.value("length") - t } else { f64::INFINITY };
        formed(inputs, sizes.clone(), punch, &Picked::by(most.min(travel + further), why))
    };
    let flare = if land.is_some() { 0.0 } else { (end - outside).signum() / sin };
    let tool = f64::from(land.is_some());
    let missed = Cell::new(0.0);
    let values = corrected("tube-end", 1, [end, first], values, |model, frame| {
        let missing = end - 0.5 * outside_diameters(frame).last()?;
        // Of a sheet that folds the verdict says so.
        missed.set(if folded(model, frame).is_some() { 0.0 } else { missing });
        Some([tool, flare].map(|share| share * missed.get()))
    })?;
    let reached = Amount::place(2.0 * (end - missed.get()));
    let what = || format!("in runs of this case the end comes to Ø {reached} only");
    ensure(missed.get().abs() < MISSED * end, what, "make --angle smaller, --end nearer to --tube or --length larger")?;
    Ok(values)
}

pub(super) fn inversion(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, outside) = (sheet.thickness, inputs.value("tube"));
    let knuckle = 0.5 * (t * (outside - 0.5 * t)).sqrt() + 0.5 * t;
    let why = "½ √(R t) of a free knuckle and half a wall, 6 thicknesses at least for shells";
    let free = || Picked::by(rounded_up(knuckle.max(rules::tool_radius(t).value), 2), why);
    let groove = inputs.pick("groove", free);
    let (r, guide, middle) = (groove.value, outside - t, groove.value - 0.5 * t);
    let (_, mut sizes) = tube(inputs, sheet, 1.0, r, "turned inside out")?;
    let what = || format!("a groove of R {} has no room for a wall of {}", plain(r), plain(t));
    ensure(r > t, what, "make --groove larger: a thickness at least")?;
    // Work of widening and of two bends, with friction round the groove, over that of the wall at yield.
    let work = (2.0 * middle / (outside - 0.5 * t)).ln_1p() + 0.5 * t / middle;
    let used = Amount::share((PI * inputs.value("friction")).exp() * work);
    let what = || format!("to turn round a groove of R {} takes {used} of what the tube's wall bears", plain(r));
    let help = format!("make --groove smaller: a free knuckle has R {}", plain(rounded_up(knuckle, 2)));
    ensure(used.value < 100.0, what, &help)?;
    sizes.set("groove", format!("R {}", plain(r)), "");
    let center = Some((Point::new(guide + r, 0.0), true));
    let far = 0.5 * inputs.value("length");
    let [bottom, outer] = [Point::new(guide + r, -r), Point::new(guide + 2.0 * r, 0.0)];
    let steps = [(Point::new(guide, 0.0), None), (bottom, center), (outer, center), (outer + far * Point::y(), None)];
    let punch = profile_text(Point::new(guide, far), &steps, exact);
    formed(inputs, sizes, punch, &Picked::by(inputs.value("travel"), "declared"))
}

pub(super) fn bulge(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let (t, [bulge, length, width, feed]) = (sheet.thickness, inputs.values(["bulge", "length", "width", "feed"]));
    let rise = bulge - inputs.value("tube");
    let what = || format!("a bulge of Ø {} is no wider than its tube", plain(2.0 * bulge));
    ensure(rise > 0.0, what, "make --bulge larger, or --tube smaller")?;
    let corner = Picked::by(rules::tool_radius(t).value.min(0.5 * rise), "6 thicknesses, or half the bulge's height");
    let (r, half) = (inputs.pick("corner", || corner).value, 0.5 * width);
    let (outside, mut sizes) = tube(inputs, sheet, 0.5, r, &format!("bulged to Ø {}", plain(2.0 * bulge)))?;
    let [corner, high, wide] = [r, rise, width].map(plain);
    let what = || format!("two corners of {corner} do not fit a bulge {high} high and {wide} wide");
    ensure(2.0 * r <= f64::min(rise, half), what, "make --corner smaller or --bulge larger")?;
    let what = || format!("a tube of {} is used up by its bulge and the feed", plain(length));
    ensure(0.5 * length > half + feed + r, what, "make --length larger, or --feed or --width smaller")?;
    let filling = |strain: f64, thickness: f64, r: f64| rules::filling_pressure(&sheet.metal, strain, thickness, r);
    let bulged = (bulge / outside).ln();
    let why = "σ t/r of the die's corner, with the flow stress of the bulge";
    let pressure = inputs.pick("pressure", || Picked::by(filling(bulged, t, r), why));
    let [out, into] = [Point::new(outside + r, -half - r), Point::new(bulge - r, -half + r)];
    let flank = (into.x - out.x > 1e-3).then_some((Point::new(into.x, -half), None));
    let onto = [(Point::new(outside, out.y), None), (Point::new(out.x, -half), Some((out, false)))];
    let along = [(Point::new(bulge, into.y), Some((into, true))), (Point::new(bulge, t), None)];
    let steps: Vec<_> = onto.into_iter().chain(flank).chain(along).collect();
    sizes.set("die", profile_text(Point::new(outside, -length), &steps, exact), "");
    let first = Picked::by(filling(0.02, t, outside), "σ t/R of the tube, so that it does not fold");
    let forming = Picked::by(filling(bulged, 1.2 * t, outside), "a fifth above σ t/R of the bulge, declared");
    for (name, pressure) in [("first", first), ("forming", forming), ("pressure", pressure)] {
        sizes.set(name, format!("\"{} MPa\"", rounded(pressure.value)), &pressure.why);
    }
    if feed > 0.0 {
        for (name, share) in [("begun", 0.02), ("fed", 0.999), ("feed", 1.0)] {
            sizes.set(name, exact(share * feed), "");
        }
    }
    sizes.set(if feed > 0.0 { "is_fed" } else { "is_free" }, "", "");
    Ok(sizes)
}
