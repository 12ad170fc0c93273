//! A tool made from the one on the other side of the sheet: its offset, or its mirror image.

use super::context::ToolContext;
use super::drawn::{Drawn, Origin};
use super::place::{Placed, place};
use crate::case::CaseError;
use crate::case::file::{Section, SectionTable};
use crate::geometry::{CavityError, Profile};
use crate::model::Role;
use crate::units::Amount;
use crate::units::Dimensioned;

/// The die's face goes on for this many blank lengths [–].
const REACH: f64 = 20.0;

/// Sine of the angle to the sheet above which a line is a wall [–].
const STEEP: f64 = 0.5;

/// A tool to be made from the one on the other side of the sheet.
pub(super) struct Counter<'a> {
    pub role: Role,
    /// The tool that it is made from.
    pub of: Role,
    /// Key path of its section.
    pub path: String,
    pub context: &'a ToolContext<'a>,
}

impl Counter<'_> {
    /// The tool that follows the outline of the other at the distance `by`, turned round so that the sheet lies between.
    pub fn offset(self, table: &SectionTable, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
        let Self { role, of, ref path, context } = self;
        let (name, other) = (role.name(), of.name());
        if !matches!((role, of), (Role::Die, Role::Punch) | (Role::Punch, Role::Die)) {
            let what = format!("the {name} cannot be an offset of the {other}: punch and die close on each other");
            let help = match role {
                Role::Holder => "draw the holder, or write { mirror_of = \"die\" }",
                _ => "write offset_of = \"punch\" for the die, or offset_of = \"die\" for the punch",
            };
            return Err(self.error("offset_of", what, help));
        }
        let by = table.by.ok_or_else(|| context.source.missing(path, "by"))?.value();
        let original = self.original("offset_of")?;
        if let Some((key, _)) =
            [("shoulder", table.shoulder), ("closed_at", table.closed_at)].iter().find(|(_, v)| v.is_some())
            && (role == Role::Punch || table.shoulder.is_none())
        {
            let what = format!("`{key}` belongs to a die made from a punch, with its shoulder");
            let help =
                "write { offset_of = \"punch\", by = .., shoulder = .., closed_at = .. } for the die, or drop it";
            return Err(self.error(key, what, help));
        }
        let axis = match role {
            Role::Punch => original.last(),
            _ => original.first(),
        };
        if axis.x > 1e-6 {
            let what =
                format!("the {other} does not reach the axis, it begins at r = {:.4} mm: its offset is open", axis.x);
            return Err(context.source.error(path, what, format!("draw the {name}, or give the {other} a bottom")));
        }
        let line = original.offset(by).map_err(|error| {
            let what = format!("the {other} has no offset of {by} mm: {error}");
            let help =
                format!("make `by` smaller or the hollow of the {other} wider (z = 0 is the flat sheet's middle)");
            self.error("by", what, help)
        })?;
        if let Some(shoulder) = table.shoulder {
            let depth = table.closed_at.map_or(context.travel, Dimensioned::value);
            let die = self.die_with_face(&line, shoulder.value(), depth)?;
            derived.push(closed(self.role, self.of, by, depth));
            return Ok(die);
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
            return Err(context.source.error(path, what, help));
        }
        let placed = self.placed(line.reversed(), &mut Vec::new())?;
        let travel = if role == Role::Die { placed.shift } else { -placed.shift };
        derived.push(closed(role, of, by, travel));
        Ok(placed.profile)
    }

    /// The mirror image of the other tool in the middle plane of the flat sheet.
    pub fn mirror(self, derived: &mut Vec<String>) -> Result<Profile, CaseError> {
        let (name, other) = (self.role.name(), self.of.name());
        if !matches!((self.role, self.of), (Role::Die, Role::Holder) | (Role::Holder, Role::Die)) {
            let (what, help) = match (self.role, self.of) {
                (Role::Punch | Role::Die, Role::Punch | Role::Die) if self.role != self.of => (
                    format!("the {name} cannot be the {other}'s mirror image: they would meet at once"),
                    format!(
                        "for a counter-tool that closes on it write {{ offset_of = \"{other}\", by = \"1.2 mm\" }}"
                    ),
                ),
                _ => (
                    format!("the {name} cannot be the {other}'s mirror image: they lie on the same side of the sheet"),
                    "holder and die can be each other's mirror image".to_owned(),
                ),
            };
            return Err(self.error("mirror_of", what, help));
        }
        let original = self.original("mirror_of")?;
        derived.push(format!("the {name} is the {other}'s mirror image"));
        self.placed(original.mirrored(), derived).map(|placed| placed.profile)
    }

    fn error(&self, key: &str, what: String, help: impl Into<String>) -> CaseError {
        self.context.source.error(&format!("{}.{key}", self.path), what, help)
    }

    /// The tool that this one is made from, which must not be made from this one; `key` names it.
    fn original(&self, key: &str) -> Result<Profile, CaseError> {
        let (name, other) = (self.role.name(), self.of.name());
        if let Some(Section::Table(table)) = self.context.section(self.of)
            && table.offset_of.or(table.mirror_of) == Some(self.role)
        {
            let what = format!("the {name} is made from the {other}, which is made from the {name}");
            return Err(self.error(key, what, "give one of them a shape of its own"));
        }
        (self.context.profile)(self.context, self.of)?.ok_or_else(|| {
            let what = format!("there is no {other} to make the {name} from");
            self.error(key, what, format!("add [tools.{other}]"))
        })
    }

    /// The die around a punch that has gone by `depth` \[mm\], with a face where the flat sheet lies.
    fn die_with_face(&self, line: &Profile, shoulder: f64, depth: f64) -> Result<Profile, CaseError> {
        let sheet = &self.context.sheet;
        let reach = REACH * sheet.length;
        let die = line.shifted(depth).cavity(0.5 * sheet.thickness, shoulder, reach).map_err(|error| {
            let (key, help) = match error {
                CavityError::Below { .. } => {
                    ("closed_at", "a cavity needs a travel of more than the thickness less `by`")
                }
                CavityError::Above { .. } => {
                    ("shoulder", "draw the punch's wall further down, or close the tools earlier")
                }
                CavityError::Shoulder { .. } => ("shoulder", "make it smaller than the cavity is deep"),
            };
            let key = if self.context.source.has(&format!("{}.{key}", self.path)) { key } else { "shoulder" };
            self.error(key, format!("the die around the punch: {error}"), help)
        })?;
        let (end, edge) = (die.vertices().next().map_or(0.0, |v| v.point.x), sheet.length);
        if end > edge {
            let what = format!("the die's shoulder ends at {end:.3} mm, beyond the blank's edge at {edge} mm");
            let help = format!(
                "the blank must reach past the shoulder to rest on the die: make that {:.3} mm smaller",
                end - edge
            );
            return Err(self.error("shoulder", what, help));
        }
        Ok(die)
    }

    fn placed(self, profile: Profile, derived: &mut Vec<String>) -> Result<Placed, CaseError> {
        place(Drawn { profile, path: self.path, origin: Origin::Tool }, self.role, self.context, derived)
    }
}

/// What an offset makes of two tools: the travel at which they have closed.
fn closed(role: Role, of: Role, by: f64, travel: f64) -> String {
    format!(
        "the {tool} follows the {other} at {by}: they have closed at a travel of {travel}",
        tool = role.name(),
        other = of.name(),
        by = Amount::size(by),
        travel = Amount::size(travel)
    )
}
