//! Tool made from the one on the other side of the sheet: its offset, or its mirror image.

use super::{section::Drawn, section::Origin, section::Section, section::SectionTable, *};
use crate::geometry::CavityError;

/// Length of the die's face over the blank's length \[–\].
const REACH: f64 = 20.0;
/// Sine of the angle to the sheet above which a line is a wall \[–\].
const STEEP: f64 = 0.5;

pub struct Counter<'a> {
    pub role: Role,
    /// Tool that it is made from.
    pub of: Role,
    /// Key path of its section.
    pub path: String,
    pub context: &'a ToolContext<'a>,
}

impl Counter<'_> {
    /// Tool that follows the outline of the other at the distance `by`, reversed so that the sheet lies between.
    pub fn offset(self, table: &SectionTable) -> Result<Profile> {
        let Self { role, of, ref path, context } = self;
        let (name, other, source) = (role.name(), of.name(), context.source);
        if !matches!((role, of), (Role::Die, Role::Punch) | (Role::Punch, Role::Die)) {
            let what = format!("the {name} cannot be an offset of the {other}: punch and die close on each other");
            let help = match role {
                Role::Holder => "draw the holder, or write { mirror_of = \"die\" }",
                _ => "write offset_of = \"punch\" for the die, or offset_of = \"die\" for the punch",
            };
            return Err(self.error("offset_of", what, help));
        }
        let by = table.by.ok_or_else(|| source.missing(path, "by"))?.value();
        let original = self.original("offset_of")?;
        if role == Role::Punch || table.shoulder.is_none() {
            let why = "belongs to a die made from a punch, with its shoulder";
            let help = "write { offset_of = \"punch\", by = .., shoulder = .., closed_at = .. }, or drop it";
            source.refuse(path, &["shoulder", "closed_at"], why, help)?;
        }
        let axis = if role == Role::Punch { original.last().x } else { original.first().x };
        let what = format!("the {other} does not reach the axis, it begins at r = {axis:.4} mm: its offset is open");
        source.require(axis <= 1e-6, path, what, format!("draw the {name}, or give the {other} a bottom"))?;
        let line = original.offset(by).map_err(|error| {
            let help = format!("make `by` smaller or the hollow of the {other} wider (z = 0: the flat sheet's middle)");
            self.error("by", format!("the {other} has no offset of {by} mm: {error}"), help)
        })?;
        let (die, closed_at) = if let Some(shoulder) = table.shoulder {
            let depth = table.closed_at.map_or(context.travel, Dimensioned::value);
            (self.die_with_face(&line, shoulder.value(), depth)?, depth)
        } else {
            let (end, tangent) = (line.last().x, line.pieces()[line.pieces().len() - 1].tangent(true));
            let has_face = role == Role::Punch || end >= context.blank.length || tangent.y >= -STEEP;
            let what = format!("a {other}'s wall goes down inside the blank, r = {end:.3} mm: its offset has no face");
            let help = "give the radius of the corner between wall and face, such as shoulder = \"6 mm\"";
            source.require(has_face, path, what, help)?;
            let (profile, shift) = source.silently(|| self.placed(line.reversed()))?;
            (profile, if role == Role::Die { shift } else { -shift })
        };
        let (by, travel) = (Amount::size(by), Amount::size(closed_at));
        source.note(format!("the {name} follows the {other} at {by}: they have closed at a travel of {travel}"));
        Ok(die)
    }

    pub fn mirror(self) -> Result<Profile> {
        let (name, other) = (self.role.name(), self.of.name());
        let (why, help) = match (self.role, self.of) {
            (Role::Die, Role::Holder) | (Role::Holder, Role::Die) => {
                self.context.source.note(format!("the {name} is the {other}'s mirror image"));
                return self.placed(self.original("mirror_of")?.mirrored()).map(|(profile, _)| profile);
            }
            (Role::Die, Role::Punch) | (Role::Punch, Role::Die) => {
                let instead = format!("{{ offset_of = \"{other}\", by = \"1.2 mm\" }}");
                ("they would meet at once", format!("for a counter-tool that closes on it write {instead}"))
            }
            _ => ("they lie on the same side of the sheet", "holder and die can be each other's mirror image".into()),
        };
        Err(self.error("mirror_of", format!("the {name} cannot be the {other}'s mirror image: {why}"), help))
    }

    fn error(&self, key: &str, what: String, help: impl Into<String>) -> CaseError {
        self.context.source.error(&format!("{}.{key}", self.path), what, help)
    }

    /// Section of the other tool, which must not be made from this one; `key` names it.
    fn original(&self, key: &str) -> Result<Profile> {
        let (name, other) = (self.role.name(), self.of.name());
        if let Some(Section::Table(table)) = self.context.keys(self.of).and_then(|tool| tool.profile)
            && table.offset_of.or(table.mirror_of) == Some(self.role)
        {
            let what = format!("the {name} is made from the {other}, which is made from the {name}");
            return Err(self.error(key, what, "give one of them a shape of its own"));
        }
        self.context.profile(self.of)?.ok_or_else(|| {
            self.error(key, format!("there is no {other} to make the {name} from"), format!("add [tools.{other}]"))
        })
    }

    /// Die around a punch that has moved by `depth` \[mm\], with a face where the flat sheet lies.
    fn die_with_face(&self, line: &Profile, shoulder: f64, depth: f64) -> Result<Profile> {
        let blank = self.context.blank;
        let die = line.shifted(depth).cavity(0.5 * blank.thickness, shoulder, REACH * blank.length);
        let die = die.map_err(|error| {
            use CavityError::{Above, Below, Shoulder};
            let (key, help) = match error {
                Below { .. } => ("closed_at", "a cavity needs a travel of more than the thickness less `by`"),
                Above { .. } => ("shoulder", "draw the punch's wall further down, or close the tools earlier"),
                Shoulder { .. } => ("shoulder", "make it smaller than the cavity is deep"),
            };
            let key = if self.context.source.has(&format!("{}.{key}", self.path)) { key } else { "shoulder" };
            self.error(key, format!("the die around the punch: {error}"), help)
        })?;
        let (end, edge) = (die.vertices().next().map_or(0.0, |v| v.point.x), blank.length);
        let what = format!("the die's shoulder ends at {end:.3} mm, beyond the blank's edge at {edge} mm");
        let (smaller, path) = (end - edge, format!("{}.shoulder", self.path));
        let help = format!("the blank must reach past the shoulder to rest on the die: make that {smaller:.3} mm less");
        self.context.source.require(end <= edge, &path, what, help)?;
        Ok(die)
    }

    fn placed(&self, profile: Profile) -> Result<(Profile, f64)> {
        Drawn { profile, path: self.path.clone(), origin: Origin::Tool }.placed(self.role, self.context)
    }
}
