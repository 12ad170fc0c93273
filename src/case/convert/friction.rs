//! `friction` of a tool, or of its side of the sheet.

use crate::case::file::{self, Friction as Given};
use crate::case::{CaseError, explain::missing, source::Source};
use crate::contact::friction::{PressureDependent, Stribeck, Tresca};
use crate::model::{Friction, Role};
use crate::units::Quantity;

/// The law of a tool: its own, that of its side, or, for a holder, the die's.
pub(super) fn of(
    role: Role,
    file: &file::CaseFile,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Friction, CaseError> {
    let tools = &file.tools;
    let own = match role {
        Role::Punch => tools.punch.as_ref().and_then(|t| t.friction),
        Role::Die => tools.die.as_ref().and_then(|t| t.friction),
        Role::Holder => tools.holder.as_ref().and_then(|t| t.friction),
    };
    let table = format!("tools.{}", role.name());
    if let Some(law) = own {
        return convert(law, source, &format!("{table}.friction"));
    }
    let (side, key) = match role {
        Role::Punch | Role::Holder => (file.friction.punch_side, "punch_side"),
        Role::Die => (file.friction.die_side, "die_side"),
    };
    if let Some(law) = side {
        let law = convert(law, source, &format!("friction.{key}"))?;
        derived.push(format!("the {}'s friction is that of its side of the sheet, {law}", role.name()));
        return Ok(law);
    }
    if role == Role::Holder {
        let law = of(Role::Die, file, source, &mut Vec::new())?;
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
