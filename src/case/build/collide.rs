//! Whether tools run into each other, where they start and at the full travel.

use super::motion::travel_key;
use super::values::place_of;
use crate::case::{CaseError, source::Source};
use crate::model::tool_sizes::{Gap, gap, room};
use crate::model::{Model, Role, Tool};

/// Drawings are rounded: tools may overlap by this share of the thickness [–].
const ROUNDED: f64 = 1e-3;

pub(super) fn check(model: &Model, source: &Source) -> Result<(), CaseError> {
    let t = model.blank.thickness;
    let overlap = |a: &Tool, b: &Tool, travel: f64| Some(gap(a, b, travel)).filter(|gap| gap.distance < -ROUNDED * t);
    for (a, b) in [(Role::Punch, Role::Holder), (Role::Punch, Role::Die), (Role::Holder, Role::Die)] {
        let (Some(first), Some(second)) = (model.tool(a), model.tool(b)) else { continue };
        let (name, other) = (a.name(), b.name());
        let words = |Gap { distance, at }: Gap| {
            format!("by {:.3} mm at {} (z = 0 is the flat sheet's middle)", -distance, place_of(at))
        };
        if let Some(gap) = overlap(first, second, 0.0) {
            let what = format!("{name} and {other} overlap where they touch the flat sheet, {}", words(gap));
            let help = format!("move the {name} and the {other} apart, or check their radii");
            return Err(source.error(&format!("tools.{other}"), what, help));
        }
        if a != Role::Punch {
            continue;
        }
        if let Some(gap) = overlap(first, second, model.travel) {
            let free = room(first, second, -ROUNDED * t, model.travel);
            let what = format!("at the travel of {} mm the punch is in the {other}, {}", model.travel, words(gap));
            let help = format!("they meet at a travel of {free:.2} mm: shorten the travel, or check the {other}");
            return Err(source.error(travel_key(source), what, help));
        }
    }
    Ok(())
}
