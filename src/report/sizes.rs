//! Section at the start with its dimensions, of every stage that brings tools of its own.

use super::*;
use crate::geometry::{Arc, Piece, Point};
use crate::model::{Motion, tool_sizes::throat};
use crate::table::worded;

/// Roundings of one tool that are given; of a curve of more arcs the smallest radius is.
const ROUNDINGS: usize = 8;
/// Radii that differ by less are one \[–\].
const ALIKE: f64 = 1e-4;
/// Distance that counts as none \[mm\].
const NONE: f64 = 1e-6;

/// Sizes of blank and tools, loads, beads and travels; of a later stage, which begins with `start`, without the blank.
pub fn dimensions(model: &Model, start: Option<&Frame>) -> Vec<Dimension> {
    let blank = &model.blank;
    let mut found = Vec::new();
    if start.is_none() {
        let at = |share: f64| Point::new(blank.node(share * blank.length)[0], blank.node(share * blank.length)[1]);
        let outside = 0.5 * if blank.is_open() { blank.thickness } else { 0.0 } * Point::x();
        found.push(wide(model, "Blank", Amount::set, at(1.0) + outside));
        found.push(plain("Thickness", Amount::size(blank.thickness), at(0.8)));
        let length = || plain("Length along the sheet", Amount::set(blank.length), at(0.5));
        found.extend(blank.meridian.as_ref().map(|_| length()));
    }
    for (i, tool) in model.tools.iter().enumerate() {
        let moved = start.and_then(|frame| frame.tool_displacement.get(i)).copied().unwrap_or_default();
        let outline = tool.profile.polyline(0.01);
        let name = capitalised(model.name_of(tool.role));
        let across = |name: &str, r: f64| {
            // The wall's end at the sheet: walls are drawn far away from it.
            let heights = outline.iter().filter(|point| (point.x - r).abs() < NONE).map(|point| point.y);
            let height = heights.min_by(|a, b| a.abs().total_cmp(&b.abs())).unwrap_or(0.0);
            wide(model, name, Amount::drawn, Point::new(r, height) + moved)
        };
        match tool.role {
            Role::Die => {
                let of = if model.is_stretch_bent() { "Clamps, inner".into() } else { name.clone() + " throat" };
                found.extend(throat(tool).map(|r| across(&of, r)));
                let land = tool.profile.land().zip(tool.profile.pieces().iter().rev().nth(1));
                found.extend(land.map(|([land, _], piece)| {
                    plain("Die land", Amount::drawn(land), 0.5 * (piece.first() + piece.last()) + moved)
                }));
            }
            Role::Holder => found.push(across("Holder inner", extent(tool).0)),
            Role::Punch | Role::Pad | Role::Upper(_) | Role::Lower(_) => found.push(across(&name, extent(tool).1)),
        }
        found.extend(roundings(tool, moved, &name));
        found.extend(load(model, tool, moved, &name));
        let travel = tool.motion.displacement(model.travel, model.travel).y;
        if travel != 0.0 && model.travel > 0.0 {
            let of = if tool.role == Role::Punch { "Travel".to_owned() } else { format!("{name} travel") };
            let tip = outline.iter().map(|p| -tool.role.side() * p.y).fold(f64::NEG_INFINITY, f64::max);
            let tip = -tool.role.side() * tip + moved.y + travel;
            found.push(plain(&of, Amount::set(travel), Point::new(0.25 * extent(tool).1.min(blank.length), tip)));
        }
    }
    let beads = model.beads.iter().map(|bead| Point::new(bead.at, -0.5 * blank.thickness));
    found.extend(beads.map(|at| wide(model, "Draw bead", Amount::drawn, at)));
    found
}

fn plain(of: &str, amount: Amount, at: Point) -> Dimension {
    Dimension { name: of.into(), text: format!("{of} {amount}"), amount, at }
}

fn wide(model: &Model, of: &str, amount: fn(f64) -> Amount, at: Point) -> Dimension {
    let (kind, sign) = worded(model.geometry, ("diameter", "Ø"), ("width", "width"));
    let amount = amount(2.0 * at.x);
    Dimension { name: format!("{of} {kind}"), text: format!("{of} {sign} {amount}"), amount, at }
}

/// The radii of a tool, those that are alike together; of a curve of many arcs the smallest.
fn roundings(tool: &Tool, moved: Point, name: &str) -> Vec<Dimension> {
    let mut found: Vec<(String, usize, Arc)> = Vec::new();
    // Arcs that are one rounding of the sheet's side come together, hollows as they are.
    for arc in tool.profile.corners().chain(tool.profile.pieces().iter().filter_map(Piece::hollow)) {
        let name = format!("{name}{}", place(tool.role, &arc));
        match found.iter_mut().find(|(n, _, a)| *n == name && (a.radius / arc.radius - 1.0).abs() < ALIKE) {
            Some((_, alike, _)) => *alike += 1,
            None => found.push((name, 1, arc)),
        }
    }
    if found.len() > ROUNDINGS {
        found.sort_by(|a, b| a.2.radius.total_cmp(&b.2.radius));
        found.truncate(1);
        found[0].0 = format!("{of} least", of = found[0].0);
    }
    let radius = |(of, alike, arc): (String, usize, Arc)| {
        let (amount, at) = (Amount::drawn(arc.radius), arc.at(0.5) + moved);
        let several = (alike > 1).then(|| (format!(", {alike} times"), format!("{alike} × ")));
        let (times, sign) = several.unwrap_or_default();
        Dimension { name: format!("{of} radius{times}"), text: format!("{of} {sign}R {amount}"), amount, at }
    };
    found.into_iter().map(radius).collect()
}

fn place(role: Role, arc: &Arc) -> &'static str {
    let on_axis = [arc.at(0.0), arc.at(1.0)].iter().any(|end| end.x.abs() < NONE);
    match (role, arc.sweep < 0.0) {
        (Role::Punch, true) if on_axis => " crown",
        (Role::Punch, true) => " nose",
        (Role::Die, true) => " shoulder",
        (Role::Die, false) if on_axis => " bottom",
        (Role::Holder, true) => "",
        (_, true) => " edge",
        (_, false) => " hollow",
    }
}

fn load(model: &Model, tool: &Tool, moved: Point, name: &str) -> Option<Dimension> {
    let (inner, outer) = extent(tool);
    let middle = 0.5 * (inner + outer.min(model.blank.length.max(inner)));
    let (of, amount) = match &tool.motion {
        Motion::Gap(gap) => ("gap", Amount::drawn(*gap)),
        Motion::Pressed(press) => ("force", Amount::given_force(press.force.largest(), model.extent().force_unit())),
        Motion::Fixed | Motion::Travel | Motion::Path(_) | Motion::Course(_) => return None,
    };
    let at = Point::new(middle, 0.5 * tool.role.side() * model.blank.thickness) + moved;
    Some(plain(&format!("{name} {of}"), amount, at))
}

pub(super) fn section(heading: String, model: &Model, start: Option<&Frame>, dimensions: &[Dimension]) -> Section {
    let rows = dimensions.iter().map(|dimension| {
        let (value, unit) = dimension.amount.parts();
        [dimension.name.clone(), value, unit.to_owned()]
    });
    let chart = dimensioned(format!("{heading} at the start"), model, start, dimensions);
    let content = html! {
        (figure(&chart, "the section at the start with its dimensions"))
        (table(&["Dimension", "Value", "Unit"], rows))
    };
    (heading, content)
}
