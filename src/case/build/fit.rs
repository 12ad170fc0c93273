//! Whether blank and tools fit together.

use super::motion::travel_key;
use super::values::place_of;
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::{Gap, extent, gap, room, shoulder_end, throat, widens};
use crate::model::{Edge, Model, Role};
use crate::units::rounded;

/// Rounded sums of decimals may miss by this share [–].
const ROUNDED: f64 = 1e-6;
/// No part is deeper than this many blank radii [–].
const DEEPEST: f64 = 3.0;
/// Clearance over the thickness below which no sheet is ironed in one draw [–].
const LEAST_CLEARANCE: f64 = 0.7;
/// A travel below this many thicknesses forms nothing [–].
const SHALLOWEST: f64 = 1e-3;

pub(super) fn check(model: &Model, source: &Source) -> Result<(), CaseError> {
    let (t, length) = (rounded(model.blank.thickness), rounded(model.blank.length));
    let key = |tool: &str, key: &str| {
        let drawn = source.has(&format!("tools.{tool}.profile"));
        format!("tools.{tool}.{}", if drawn { "profile" } else { key })
    };
    if model.travel > DEEPEST * length {
        let what =
            format!("a travel of {} mm is more than {DEEPEST} times the blank's {length} mm", rounded(model.travel));
        return Err(source.error(travel_key(source), what, "check the unit"));
    }
    if model.tool(Role::Punch).is_some() && model.travel < SHALLOWEST * t {
        let what = format!("a travel of {} mm is next to nothing for a sheet of {t} mm", rounded(model.travel));
        return Err(source.error(travel_key(source), what, "check the unit"));
    }
    let Some(die) = model.tool(Role::Die) else {
        return match model.blank.edge {
            Edge::Free => Err(source.missing("tools", "die")),
            _ => Ok(()),
        };
    };
    let throat = throat(die);
    if let (Some(_), Some(punch)) = (throat, model.tool(Role::Punch).filter(|punch| widens(punch, model.travel))) {
        let Gap { distance, at } = gap(punch, die, model.travel);
        // Tools that overlap are another matter.
        if (0.0..LEAST_CLEARANCE * t).contains(&distance) {
            let what = format!(
                "the sheet does not fit between punch and die at the travel of {} mm: they are {distance:.3} mm apart at {} \
                 for a thickness of {t} mm",
                rounded(model.travel),
                place_of(at)
            );
            let [whole, ironed] = [t, LEAST_CLEARANCE * t].map(|least| room(punch, die, least, model.travel));
            let help =
                format!("a travel of {whole:.2} mm leaves room for the sheet; up to {ironed:.2} mm it is ironed");
            return Err(source.error(travel_key(source), what, help));
        }
    } else if let (Some(throat), Some(punch)) = (throat, model.tool(Role::Punch)) {
        let wall = extent(punch).1;
        let clearance = throat - wall;
        if clearance < LEAST_CLEARANCE * t * (1.0 - ROUNDED) {
            let what = format!(
                "the sheet does not fit between punch and die: punch {wall:.3} mm, throat {throat:.3} mm, clearance \
                 {clearance:.3} mm for a thickness of {t} mm"
            );
            return Err(source.error(
                &key("die", "throat"),
                what,
                format!(
                    "{:.3} mm leaves room for the sheet; down to {:.3} mm it is ironed",
                    wall + t,
                    wall + LEAST_CLEARANCE * t
                ),
            ));
        }
    }
    let end = shoulder_end(die);
    if let Some(throat) = throat.filter(|_| end > length * (1.0 + ROUNDED)) {
        let what = format!("the die's shoulder ends at {end:.3} mm, beyond the blank's edge at {length} mm");
        let (shoulder, half) = (end - throat, if throat < length { "shoulder" } else { "throat" });
        let smaller = match half {
            "shoulder" => format!("a shoulder of at most {:.3} mm", length - throat),
            _ => format!("a throat of less than {length} mm"),
        };
        let edge = format!("a blank with its edge at {end:.3} mm or more, {:.3} mm across", 2.0 * end);
        let help = format!(
            "the blank must reach past throat {throat:.3} mm + shoulder {shoulder:.3} mm to rest on the die: {smaller}, or \
             {edge}"
        );
        return Err(source.error(&key("die", half), what, help));
    }
    if let Some(holder) = model.tool(Role::Holder) {
        let inner = extent(holder).0;
        let inner_key =
            if model.geometry == crate::model::Geometry::Axisymmetric { "inner_radius" } else { "inner_half_width" };
        if let Some(throat) = throat.filter(|throat| inner < throat * (1.0 - ROUNDED)) {
            let what =
                format!("the holder reaches into the die's throat: inner edge {inner:.3} mm, throat {throat:.3} mm");
            let help = format!("at least {throat:.3} mm");
            return Err(source.error(&key("holder", inner_key), what, help));
        }
        if inner >= length {
            let what = format!("the holder begins at {inner:.3} mm, beyond the blank's edge at {length} mm");
            return Err(source.error(&key("holder", inner_key), what, "make it smaller, or drop it"));
        }
    }
    Ok(())
}
