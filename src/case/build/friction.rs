//! `friction` of a tool, or of its side of the sheet.

use super::material::only;
use crate::case::file::{self, ToolKeys};
use crate::case::{CaseError, source::Source};
use crate::model::{Friction, Role};

/// Given laws, by tool and by side of the sheet.
pub(super) struct Frictions<'a> {
    pub tools: [Option<file::Friction>; 3],
    sides: &'a file::Sides,
}

impl<'a> Frictions<'a> {
    pub fn new(file: &'a file::CaseFile) -> Self {
        let mut frictions = Self { tools: [None; 3], sides: &file.friction };
        file.tools.keys().for_each(|tool| frictions.add(&tool));
        frictions
    }

    /// Adds a tool's own law, if it has one.
    pub fn add(&mut self, tool: &ToolKeys) {
        let own = &mut self.tools[tool.role as usize];
        *own = tool.friction.or(*own);
    }

    /// Law of a tool: its own, that of its side, or, for a holder, the die's.
    pub fn law(&self, role: Role, source: &Source) -> Result<Friction, CaseError> {
        let tool = role.name();
        if let Some(law) = self.tools[role as usize] {
            return only(law.laws(), &format!("tools.{tool}.friction"), source);
        }
        let (side, key) = match role {
            Role::Punch | Role::Holder => (self.sides.punch_side, "punch_side"),
            Role::Die => (self.sides.die_side, "die_side"),
        };
        let (law, origin) = match (side, role) {
            (Some(law), _) => (only(law.laws(), &format!("friction.{key}"), source)?, "that of its side of the sheet"),
            (None, Role::Holder) => (source.silently(|| self.law(Role::Die, source))?, "the die's"),
            (None, _) => return Err(source.missing(&format!("tools.{tool}"), "friction")),
        };
        source.note(format!("the {tool}'s friction is {origin}, {law}"));
        Ok(law)
    }
}
