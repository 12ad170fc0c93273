//! `friction` of a tool, or of its side of the sheet.

use crate::case::file::{self, Friction as Given};
use crate::case::{CaseError, explain::missing, source::Source};
use crate::contact::friction::{PressureDependent, Stribeck, Tresca};
use crate::model::{Friction, Role};
use crate::units::Quantity;

/// The laws that are written, by tool and by side of the sheet.
pub(super) struct Frictions {
    tools: [Option<Given>; 3],
    sides: file::Sides,
}

impl Frictions {
    pub fn of(file: &file::CaseFile) -> Self {
        let file::Tools { punch, die, holder, .. } = &file.tools;
        let punch = punch.as_ref().and_then(|tool| tool.friction);
        let die = die.as_ref().and_then(|tool| tool.friction);
        let holder = holder.as_ref().and_then(|tool| tool.friction);
        Self { tools: [punch, die, holder], sides: file.friction }
    }

    /// The law that a tool has of its own.
    pub fn own(&mut self, role: Role) -> &mut Option<Given> {
        &mut self.tools[role as usize]
    }
}

/// The law of a tool: its own, that of its side, or, for a holder, the die's.
pub(super) fn of(
    role: Role,
    written: &Frictions,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Friction, CaseError> {
    let table = format!("tools.{}", role.name());
    if let Some(law) = written.tools[role as usize] {
        return convert(law, source, &format!("{table}.friction"));
    }
    let (side, key) = match role {
        Role::Punch | Role::Holder => (written.sides.punch_side, "punch_side"),
        Role::Die => (written.sides.die_side, "die_side"),
    };
    if let Some(law) = side {
        let law = convert(law, source, &format!("friction.{key}"))?;
        derived.push(format!("the {}'s friction is that of its side of the sheet, {law}", role.name()));
        return Ok(law);
    }
    if role == Role::Holder {
        let law = of(Role::Die, written, source, &mut Vec::new())?;
        derived.push(format!("the holder's friction is the die's, {law}"));
        return Ok(law);
    }
    Err(missing(source, &table, "friction"))
}

fn convert(given: Given, source: &Source, path: &str) -> Result<Friction, CaseError> {
    let laws = match given {
        Given::Coulomb(coefficient) => return Ok(coefficient.value().into()),
        Given::Law(laws) => laws,
    };
    let found = [
        laws.pressure_dependent.map(|l| {
            Friction::PressureDependent(PressureDependent {
                coefficient: l.coefficient.value(),
                reference: l.reference.value(),
                exponent: l.exponent.value(),
            })
        }),
        laws.stribeck.map(|l| {
            Friction::Stribeck(Stribeck {
                at_rest: l.at_rest.value(),
                sliding: l.sliding.value(),
                speed: l.speed.value(),
                viscous: l.viscous.map_or(0.0, Quantity::value),
            })
        }),
        laws.tresca.map(|l| {
            Friction::Tresca(Tresca {
                factor: l.factor.value(),
                coefficient: l.coefficient.map_or(Tresca::BOUND, Quantity::value),
            })
        }),
    ];
    let mut found = found.into_iter().flatten();
    match (found.next(), found.next()) {
        (Some(law), None) => Ok(law),
        (None, _) => Err(source.error(
            path,
            "`friction` names no law",
            "write a coefficient, such as friction = 0.1, or one of pressure_dependent, stribeck, tresca",
        )),
        (Some(_), Some(_)) => Err(source.error(path, "`friction` names more than one law", "keep one of them")),
    }
}
