//! A number that knows what it measures.

use super::error::QuantityError;
use super::kind::Kind;
use super::parse::{parse, thicknesses};
use super::unit::FORCE;

/// A number whose dimension and range have been checked.
pub trait Dimensioned: Copy {
    /// What the type is called, measured in and limited to.
    const KIND: &'static Kind;

    /// Checks a number given in solver units.
    ///
    /// # Errors
    /// When it is not finite or out of range; `found` is quoted in the message.
    fn checked(value: f64, found: &str) -> Result<Self, QuantityError>;

    /// The number in the solver's unit ([`Kind::unit`]).
    fn value(self) -> f64;

    /// Further condition of the type, for schemas: a JSON-schema keyword and its bound.
    const BOUND: &'static [(&'static str, f64)] = &[];
}

/// Checks text against a type: number, unit, dimension, range.
pub(super) fn read<Q: Dimensioned>(text: &str) -> Result<Q, QuantityError> {
    let (kind, found) = (Q::KIND, text.trim());
    let parsed = parse(text).map_err(|error| match (error, thicknesses(text)) {
        (QuantityError::Thicknesses { .. }, Some(tonnes)) if kind.dimension == FORCE => {
            QuantityError::tonnes(found, tonnes, kind)
        }
        (error, _) => error,
    })?;
    // A bare 8 would be 800 %: who writes a percentage says so.
    let is_bare_share = kind.unit == "%" && !parsed.has_unit;
    if parsed.dimension == kind.dimension && !is_bare_share {
        return Q::checked(parsed.value, found);
    }
    let found = found.into();
    Err(match parsed.has_unit {
        true => QuantityError::WrongDimension { found, is: parsed.dimension, kind },
        false => QuantityError::MissingUnit { found, kind },
    })
}
