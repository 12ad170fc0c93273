//! Why a text is not the quantity that is wanted.

use super::kind::Kind;
use super::spelling::closest;
use super::unit::{Dimension, UNITS, meant};

/// Why a text is not a quantity. The message's first line says what is wrong, the second what to write.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QuantityError {
    #[error("no number in {found:?}\nwrite a number and a unit, such as \"0.9 mm\"")]
    NoNumber { found: String },
    #[error("decimal comma in {found:?}\nwrite a point: \"{point}\"")]
    DecimalComma { found: String, point: String },
    #[error("{found} needs a unit\nwrite \"{}\"; {} may also be written {}", .kind.with_unit(.found), .kind.name, .kind.written())]
    MissingUnit { found: String, kind: &'static Kind },
    #[error("unknown unit `{unit}` in {found:?}\n{}", known(.closest))]
    UnknownUnit { found: String, unit: String, closest: Vec<&'static str> },
    #[error(
        "{found:?} cannot be read from {at:?} on\nunits are joined by * and /, powers written ^2: \"5.4 tonf_uk/in^2\""
    )]
    Malformed { found: String, at: String },
    #[error("{found:?} is {}, wanted {}\nwrite for example {}", .is.describe(), .kind.name, .kind.written())]
    WrongDimension { found: String, is: Dimension, kind: &'static Kind },
    #[error("{found} is out of range for {}\nits magnitude must be at most {} {}: check the unit", .kind.name, .kind.largest, .kind.unit)]
    TooLarge { found: String, kind: &'static Kind },
    #[error("must be positive, found {found}\nwrite for example {}", .kind.written())]
    NotPositive { found: String, kind: &'static Kind },
    #[error("must not be negative, found {found}\nwrite for example {}", .kind.written())]
    Negative { found: String, kind: &'static Kind },
    #[error("must lie between 0 and 1, found {found}\nit is a fraction, such as 0.1")]
    NotFraction { found: String },
}

impl QuantityError {
    pub(super) fn unknown_unit(found: &str, unit: &str) -> Self {
        let closest = match meant(unit) {
            Some(name) => vec![name],
            None => closest(unit, UNITS.iter().map(|known| known.0)),
        };
        Self::UnknownUnit { found: found.into(), unit: unit.into(), closest }
    }
}

fn known(closest: &[&str]) -> String {
    if closest.is_empty() {
        let all: Vec<&str> = UNITS.iter().map(|unit| unit.0).collect();
        format!("known units: {}", all.join(", "))
    } else {
        format!("did you mean {}?", closest.iter().map(|c| format!("`{c}`")).collect::<Vec<_>>().join(" or "))
    }
}
