//! A tool made from the one on the other side of the sheet: its offset, or its mirror image.

use super::context::ToolContext;
use super::drawn::{Drawn, Origin};
use super::place;
use crate::case::file::{Section, SectionTable};
use crate::case::{CaseError, explain::missing};
use crate::geometry::{CavityError, Profile};
use crate::model::Role;
use crate::units::Quantity;

/// The die's face goes on for this many blank lengths [–].
const REACH: f64 = 20.0;

/// Sine of the angle to the sheet above which a line is a wall [–].
const STEEP: f64 = 0.5;

/// The tool that follows the outline of another at the distance `by`, turned round so that the sheet lies between.
pub(super) fn offset(
    of: Role,
    table: &SectionTable,
    role: Role,
    path: String,
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let (name, other) = (role.name(), of.name());
    if !matches!((role, of), (Role::Die, Role::Punch) | (Role::Punch, Role::Die)) {
        let what = format!("the {name} cannot be an offset of the {other}: punch and die close on each other");
        let help = match role {
            Role::Holder => "draw the holder, or write { mirror_of = \"die\" }",
            _ => "write offset_of = \"punch\" for the die, or offset_of = \"die\" for the punch",
        };
        return Err(context.source.error(&format!("{path}.offset_of"), what, help));
    }
    let by = table.by.ok_or_else(|| missing(context.source, &path, "by"))?.value();
    let original = source_of(of, role, &format!("{path}.offset_of"), context)?;
    if let Some(key) = [("shoulder", table.shoulder), ("closed_at", table.closed_at)].iter().find(|(_, v)| v.is_some())
        && (role == Role::Punch || table.shoulder.is_none())
    {
        let what = format!("`{}` belongs to a die made from a punch, with its shoulder", key.0);
        let help = "write { offset_of = \"punch\", by = .., shoulder = .., closed_at = .. } for the die, or drop it";
        return Err(context.source.error(&format!("{path}.{}", key.0), what, help));
    }
    let axis = match role {
        Role::Punch => original.last(),
        _ => original.first(),
    };
    if axis.x > 1e-6 {
        let what =
            format!("the {other} does not reach the axis, it begins at r = {:.4} mm: its offset is open", axis.x);
        return Err(context.source.error(&path, what, format!("draw the {name}, or give the {other} a bottom")));
    }
    let line = original.offset(by).map_err(|error| {
        let what = format!("the {other} has no offset of {by} mm: {error}");
        let help = format!("make `by` smaller or the hollow of the {other} wider (z = 0 is the flat sheet's middle)");
        context.source.error(&format!("{path}.by"), what, help)
    })?;
    if let Some(shoulder) = table.shoulder {
        return die_with_face(&line, shoulder.value(), table, &path, context, derived);
    }
    let end = line.last();
    let tangent = line.pieces()[line.pieces().len() - 1].tangent(true);
    if role == Role::Die && end.x < context.sheet.length && tangent.y < -STEEP {
        let what = format!(
            "the {other}'s wall goes down inside of the blank: its offset has no face for the sheet, only a \
                            wall at r = {:.3} mm",
            end.x
        );
        let help = "give the radius of the corner between wall and face, such as shoulder = \"6 mm\"";
        return Err(context.source.error(&path, what, help));
    }
    let drawn = Drawn { profile: line.reversed(), path, origin: Origin::Tool };
    let placed = place::place(drawn, role, context, &mut Vec::new())?;
    let travel = if role == Role::Die { placed.shift } else { -placed.shift };
    derived.push(format!("the {name} follows the {other} at {by} mm: they have closed at a travel of {travel:.4} mm"));
    Ok(placed.profile)
}

/// The die around a punch that has come to `closed_at`, with a face where the flat sheet lies.
fn die_with_face(
    line: &Profile,
    shoulder: f64,
    table: &SectionTable,
    path: &str,
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let depth = table.closed_at.map_or(context.travel, Quantity::value);
    let reach = REACH * context.sheet.length;
    let die = line.shifted(depth).cavity(0.5 * context.sheet.thickness, shoulder, reach).map_err(|error| {
        let (key, help) = match error {
            CavityError::Below { .. } => ("closed_at", "a cavity needs a travel of more than the thickness less `by`"),
            CavityError::Above { .. } => ("shoulder", "draw the punch's wall further down, or close the tools earlier"),
            CavityError::Shoulder { .. } => ("shoulder", "make it smaller than the cavity is deep"),
        };
        let key = if context.source.has(&format!("{path}.{key}")) { key } else { "shoulder" };
        context.source.error(&format!("{path}.{key}"), format!("the die around the punch: {error}"), help)
    })?;
    let (end, edge) = (die.vertices().next().map_or(0.0, |v| v.point.x), context.sheet.length);
    if end > edge {
        let what = format!("the die's shoulder ends at {end:.3} mm, beyond the blank's edge at {edge} mm");
        let help = "make it smaller: the blank must reach past the shoulder to rest on the die";
        return Err(context.source.error(&format!("{path}.shoulder"), what, help));
    }
    let by = table.by.map_or(0.0, Quantity::value);
    derived.push(format!("the die follows the punch at {by} mm: they have closed at a travel of {depth:.4} mm"));
    Ok(die)
}

/// The mirror image of a tool in the middle plane of the flat sheet.
pub(super) fn mirror(
    of: Role,
    role: Role,
    path: String,
    context: &ToolContext,
    derived: &mut Vec<String>,
) -> Result<Profile, CaseError> {
    let (name, other) = (role.name(), of.name());
    if !matches!((role, of), (Role::Die, Role::Holder) | (Role::Holder, Role::Die)) {
        let (what, help) = match (role, of) {
            (Role::Punch | Role::Die, Role::Punch | Role::Die) if role != of => (
                format!("the {name} cannot be the {other}'s mirror image: they would meet at once"),
                format!("for a counter-tool that closes on it write {{ offset_of = \"{other}\", by = \"1.2 mm\" }}"),
            ),
            _ => (
                format!("the {name} cannot be the {other}'s mirror image: they lie on the same side of the sheet"),
                "holder and die can be each other's mirror image".to_owned(),
            ),
        };
        return Err(context.source.error(&format!("{path}.mirror_of"), what, help));
    }
    let original = source_of(of, role, &format!("{path}.mirror_of"), context)?;
    derived.push(format!("the {name} is the {other}'s mirror image"));
    let drawn = Drawn { profile: original.mirrored(), path, origin: Origin::Tool };
    place::place(drawn, role, context, derived).map(|placed| placed.profile)
}

/// The tool that another is made from, which must not be made from that other one.
fn source_of(of: Role, role: Role, key: &str, context: &ToolContext) -> Result<Profile, CaseError> {
    let (name, other) = (role.name(), of.name());
    if let Some(Section::Table(table)) = context.section(of) {
        let theirs = table.offset_of.or(table.mirror_of);
        if theirs == Some(role) {
            let what = format!("the {name} is made from the {other}, which is made from the {name}");
            return Err(context.source.error(key, what, "give one of them a shape of its own"));
        }
    }
    (context.profile)(context, of)?.ok_or_else(|| {
        let what = format!("there is no {other} to make the {name} from");
        context.source.error(key, what, format!("add [tools.{other}]"))
    })
}
