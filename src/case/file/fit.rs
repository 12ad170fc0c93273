//! Checks that blank and tools fit together and do not collide.

use super::{drive::travel_key, *};
use crate::model::tool_sizes::{extent, gap, room, throat, widens};

/// Rounding error of sums of decimals \[–\].
const ROUNDED: f64 = 1e-6;
/// Overlap of tools from rounded drawings over the thickness \[–\].
const OVERLAP: f64 = 1e-3;
/// Largest travel over the blank's radius \[–\].
const DEEPEST: f64 = 3.0;
/// Clearance over the thickness below which no sheet is ironed in one draw \[–\].
const LEAST_CLEARANCE: f64 = 0.7;
/// Travel over the thickness below which nothing is formed \[–\].
const SHALLOWEST: f64 = 1e-3;

pub fn check(model: &Model, source: &Source) -> Result<()> {
    let (t, length, travel) = (rounded(model.blank.thickness), rounded(model.blank.length), rounded(model.travel));
    let (travel_key, punch) = (travel_key(source), model.tool(Role::Punch));
    let what = format!("a travel of {travel} mm is more than {DEEPEST} times the blank's {length} mm");
    source.require(model.travel <= DEEPEST * length, travel_key, what, "check the unit")?;
    let what = format!("a travel of {travel} mm is next to nothing for a sheet of {t} mm");
    source.require(punch.is_none() || model.travel >= SHALLOWEST * t, travel_key, what, "check the unit")?;
    if model.blank.meridian.is_some() {
        let is_held = [model.blank.inner_edge, model.blank.edge].iter().any(|edge| *edge != Edge::Free);
        let help = "write inner_edge = \"guided\" for an end in its seat, or draw a die that it stands against";
        let what = "nothing holds the sheet against the punch";
        return source.require(is_held || model.tool(Role::Die).is_some(), "blank.thickness", what, help);
    }
    let Some(die) = model.tool(Role::Die) else {
        return if model.blank.edge == Edge::Free { Err(source.missing("tools", "die")) } else { Ok(()) };
    };
    if let Some(wall) = punch.map(|punch| extent(punch).1).filter(|wall| *wall <= model.blank.hole) {
        let [wall, hole] = [wall, model.blank.hole].map(|half| rounded(2.0 * half));
        let what = format!("the punch Ø {wall} mm passes the hole Ø {hole} mm and never touches the sheet");
        let key = if source.has("blank.hole") { "blank.hole" } else { "blank.hole_diameter" };
        return Err(source.error(key, what, format!("a hole below Ø {wall} mm, or a wider punch")));
    }
    let key = |tool: &str, key: &str| {
        format!("tools.{tool}.{}", if source.has(&format!("tools.{tool}.profile")) { "profile" } else { key })
    };
    let throat = throat(die);
    if let Some((throat, punch)) = throat.zip(punch) {
        clearance(model, [punch, die], (throat, &key("die", "throat")), source)?;
    }
    let end = shoulder_end(die);
    if let Some(throat) = throat.filter(|_| end > length * (1.0 + ROUNDED)) {
        let what = format!("the die's shoulder ends at {end:.3} mm, beyond the blank's edge at {length} mm");
        let (half, smaller) = match throat < length {
            true => ("shoulder", format!("a shoulder of at most {:.3} mm", length - throat)),
            false => ("throat", format!("a throat of less than {length} mm")),
        };
        let help = format!(
            "the blank must reach past throat {throat:.3} mm + shoulder {:.3} mm to rest on the die: {smaller}, or a blank \
             with its edge at {end:.3} mm or more, {:.3} mm across",
            end - throat,
            2.0 * end
        );
        return Err(source.error(&key("die", half), what, help));
    }
    let Some(holder) = model.tool(Role::Holder) else { return Ok(()) };
    let inner = extent(holder).0;
    let own_key =
        key("holder", if model.geometry == Geometry::Axisymmetric { "inner_radius" } else { "inner_half_width" });
    if let Some(throat) = throat.filter(|throat| inner < throat * (1.0 - ROUNDED)) {
        let what = format!("the holder reaches into the die's throat: inner edge {inner:.3} mm, throat {throat:.3} mm");
        return Err(source.error(&own_key, what, format!("at least {throat:.3} mm")));
    }
    let what = format!("the holder begins at {inner:.3} mm, beyond the blank's edge at {length} mm");
    source.require(inner < length, &own_key, what, "make it smaller, or drop it")
}

fn clearance(model: &Model, [punch, die]: [&Tool; 2], throat: (f64, &str), source: &Source) -> Result<()> {
    let (throat, throat_key) = throat;
    let t = rounded(model.blank.thickness);
    let least = LEAST_CLEARANCE * t;
    if widens(punch, model.travel) {
        let (distance, at) = gap(punch, die, model.travel);
        let what = format!(
            "the sheet does not fit between punch and die at the travel of {} mm: they are {distance:.3} mm apart at {} for \
             a thickness of {t} mm",
            rounded(model.travel),
            place_of(at)
        );
        let [whole, ironed] = [t, least].map(|least| room(punch, die, least, model.travel));
        let help = format!("a travel of {whole:.2} mm leaves room for the sheet; up to {ironed:.2} mm it is ironed");
        // Tools that overlap are reported as a collision.
        return source.require(!(0.0..least).contains(&distance), travel_key(source), what, help);
    }
    let wall = extent(punch).1;
    let clearance = throat - wall;
    let what = format!(
        "the sheet does not fit between punch and die: punch {wall:.3} mm, throat {throat:.3} mm, clearance {clearance:.3} mm \
         for a thickness of {t} mm"
    );
    let help = format!("{:.3} mm leaves room for the sheet; down to {:.3} mm it is ironed", wall + t, wall + least);
    source.require(clearance >= least * (1.0 - ROUNDED), throat_key, what, help)
}

pub fn collisions(model: &Model, source: &Source) -> Result<()> {
    let allowed = -OVERLAP * model.blank.thickness;
    let overlap = |a: &Tool, b: &Tool, travel: f64| Some(gap(a, b, travel)).filter(|gap| gap.0 < allowed);
    let by = |(distance, at): (f64, Point)| format!("by {:.3} mm at {} (z = 0 is the sheet)", -distance, place_of(at));
    let [punch, die, holder, pad] = [Role::Punch, Role::Die, Role::Holder, Role::Pad];
    for (a, b) in [(punch, holder), (punch, die), (holder, die), (pad, die)] {
        let (Some(first), Some(second)) = (model.tool(a), model.tool(b)) else { continue };
        let (name, other) = (a.name(), b.name());
        if let Some(gap) = overlap(first, second, 0.0) {
            let what = format!("{name} and {other} overlap where they touch the flat sheet, {}", by(gap));
            let help = format!("move the {name} and the {other} apart, or check their radii");
            return Err(source.error(&format!("tools.{other}"), what, help));
        }
        if let Some(gap) = overlap(first, second, model.travel).filter(|_| a == Role::Punch) {
            let free = room(first, second, allowed, model.travel);
            let what = format!("at the travel of {} mm the punch is in the {other}, {}", model.travel, by(gap));
            let help = format!("they meet at a travel of {free:.2} mm: shorten the travel, or check the {other}");
            return Err(source.error(travel_key(source), what, help));
        }
    }
    Ok(())
}
