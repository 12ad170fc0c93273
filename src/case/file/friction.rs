//! `friction` of a tool, or of its side of the sheet.

use super::material::only;
use super::tools::ToolKeys;
use super::values::untagged;
use super::{CaseError, CaseFile, Deserialize, JsonSchema, Source};
use crate::contact::friction::FrictionTable;
use crate::material::law::Family;
use crate::model::{self, Role};
use crate::units::{Dimensioned, Fraction};
use serde::de::IntoDeserializer;

/// The friction law of one tool: Coulomb's coefficient, 0 to 1, or exactly one other law.
#[derive(Clone, Copy, Debug, JsonSchema)]
#[schemars(untagged)]
pub enum Friction {
    /// Coulomb's coefficient.
    Coefficient(Fraction),
    /// Another law with its parameters.
    Law(FrictionTable),
}

untagged!(
    [] Friction, "a plain number, such as 0.1, or a law, such as { tresca = { factor = 0.2 } }",
    number(number) => Fraction::deserialize(number.into_deserializer()).map(Friction::Coefficient),
    table => Friction::Law
);

/// Friction by the face of the sheet, for tools without their own, and the source of all friction numbers.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sides {
    /// Face that punch and holder touch: a coefficient, 0 to 1, or a law.
    punch_side: Option<Friction>,
    /// Face that the die touches: a coefficient, 0 to 1, or a law.
    die_side: Option<Friction>,
    /// Source of the coefficients of all tools: how they were measured, or author and year; left out if they are assumed.
    pub source: Option<String>,
}

/// Written laws, by tool and by side of the sheet.
pub struct Frictions<'a> {
    pub tools: [Option<Friction>; 3],
    sides: &'a Sides,
}

impl<'a> Frictions<'a> {
    pub fn new(file: &'a CaseFile) -> Self {
        let mut frictions = Self { tools: [None; 3], sides: &file.friction };
        file.tools.keys().for_each(|tool| frictions.add(&tool));
        frictions
    }

    pub fn add(&mut self, tool: &ToolKeys) {
        let own = &mut self.tools[tool.role as usize];
        *own = tool.friction.or(*own);
    }

    /// Law of a tool: its own, that of its side, or, for a holder, the die's.
    pub fn law(&self, role: Role, source: &Source) -> Result<model::Friction, CaseError> {
        let law = |law: Friction, path: &str| match law {
            Friction::Coefficient(coefficient) => Ok(coefficient.value().into()),
            Friction::Law(table) => only(model::Friction::named(table), None, path, source),
        };
        let tool = role.name();
        if let Some(own) = self.tools[role as usize] {
            return law(own, &format!("tools.{tool}.friction"));
        }
        let (side, path) = match role {
            Role::Punch | Role::Holder => (self.sides.punch_side, "friction.punch_side"),
            Role::Die => (self.sides.die_side, "friction.die_side"),
        };
        let (law, origin) = match (side, role) {
            (Some(side), _) => (law(side, path)?, "that of its side of the sheet"),
            (None, Role::Holder) => (source.silently(|| self.law(Role::Die, source))?, "the die's"),
            (None, _) => return Err(source.missing(&format!("tools.{tool}"), "friction")),
        };
        source.note(format!("the {tool}'s friction is {origin}, {law}"));
        Ok(law)
    }
}
