//! `friction` of a tool, or of its side of the sheet.

use super::material::prepared;
use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::material::law::Family;
use crate::model::{Friction, Role};

/// Given laws, by tool and by side of the sheet.
pub(super) struct Frictions {
    tools: [Option<file::Friction>; 3],
    sides: file::Sides,
}

impl Frictions {
    pub fn new(file: &file::CaseFile) -> Self {
        let file::Tools { punch, die, holder, .. } = &file.tools;
        let punch = punch.as_ref().and_then(|tool| tool.friction);
        let die = die.as_ref().and_then(|tool| tool.friction);
        let holder = holder.as_ref().and_then(|tool| tool.friction);
        Self { tools: [punch, die, holder], sides: file.friction.clone() }
    }

    /// Own law of a tool.
    pub fn own(&mut self, role: Role) -> &mut Option<file::Friction> {
        &mut self.tools[role as usize]
    }
}

/// Law of a tool: its own, that of its side, or, for a holder, the die's.
pub(super) fn law(role: Role, written: &Frictions, source: &Source) -> Result<Friction, CaseError> {
    let (table, tool) = (format!("tools.{}", role.name()), role.name());
    if let Some(law) = written.tools[role as usize] {
        return convert(law, source, &format!("{table}.friction"));
    }
    let (side, key) = match role {
        Role::Punch | Role::Holder => (written.sides.punch_side, "punch_side"),
        Role::Die => (written.sides.die_side, "die_side"),
    };
    if let Some(law) = side {
        let law = convert(law, source, &format!("friction.{key}"))?;
        source.note(format!("the {tool}'s friction is that of its side of the sheet, {law}"));
        return Ok(law);
    }
    if role != Role::Holder {
        return Err(source.missing(&table, "friction"));
    }
    let law = source.silently(|| self::law(Role::Die, written, source))?;
    source.note(format!("the holder's friction is the die's, {law}"));
    Ok(law)
}

fn convert(given: file::Friction, source: &Source, path: &str) -> Result<Friction, CaseError> {
    let (what, help) = match given.only() {
        Ok(law) => return prepared(law, None, path, source),
        Err(given) if given.is_empty() => {
            let names = Friction::NAMES.join(", ");
            ("names no law", format!("write a coefficient, such as friction = 0.1, or one of {names}"))
        }
        Err(_) => ("names more than one law", "keep one of them".into()),
    };
    Err(source.error(path, format!("`friction` {what}"), help))
}
