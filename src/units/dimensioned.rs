//! Numbers of known dimension.

use super::error::QuantityError;
use super::kind::Kind;
use super::parse::{parse, thicknesses};
use super::unit::{FORCE, factor};

/// A number whose dimension and range have been checked.
pub trait Dimensioned: Copy {
    /// Name, unit and range.
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

/// Reads text as a quantity: number, unit, dimension, range.
pub(super) fn read<Q: Dimensioned>(text: &str) -> Result<Q, QuantityError> {
    let (kind, found) = (Q::KIND, text.trim());
    if let Some(tonnes) = thicknesses(text).filter(|_| kind.dimension == FORCE) {
        let kilonewtons = 1e-3 * tonnes * factor("tonf").unwrap_or(f64::NAN);
        return Err(QuantityError::new(
            format!("{found:?} are thicknesses of the sheet, wanted {}", kind.name),
            format!("t is thicknesses of the sheet here: write {tonnes} tonf (tonnes-force) or {kilonewtons:.0} kN"),
        ));
    }
    let parsed = parse(text)?;
    // A bare 8 would be 800 %.
    let is_bare_share = kind.unit == "%" && !parsed.has_unit;
    if parsed.dimension == kind.dimension && !is_bare_share {
        return Q::checked(parsed.value, found);
    }
    Err(match parsed.has_unit {
        true => QuantityError::new(
            format!("{found:?} is {}, wanted {}", parsed.dimension.describe(), kind.name),
            format!("write for example {}", kind.written()),
        ),
        false => QuantityError::missing_unit(found, kind),
    })
}
