//! Errors of quantities: reason and remedy.

use super::kind::Kind;
use super::spelling::closest;
use super::unit::{UNITS, display_name, meant};

/// Reason why a text is not the wanted quantity, and what to write instead.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what}\n{help}")]
pub struct QuantityError {
    /// Reason.
    pub what: String,
    /// Remedy.
    pub help: String,
    /// Text with a decimal point in place of its comma.
    pub with_point: Option<String>,
}

impl QuantityError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into(), with_point: None }
    }

    /// Number without the unit that its kind needs.
    pub(super) fn missing_unit(found: &str, kind: &Kind) -> Self {
        let help = format!("write \"{}\"; {} may also be written {}", kind.with_unit(found), kind.name, kind.written());
        Self::new(format!("{found} needs a unit"), help)
    }

    /// Magnitude that makes no sense.
    pub(super) fn too_large(found: &str, kind: &Kind) -> Self {
        let help = format!("its magnitude must be at most {} {}: check the unit", kind.largest, kind.unit);
        Self::new(format!("{found} is out of range for {}", kind.name), help)
    }

    /// Number on the wrong side of zero; `must` is "be positive" or "not be negative".
    pub(super) fn wrong_sign(must: &str, found: &str, kind: &Kind) -> Self {
        Self::new(format!("must {must}, found {found}"), format!("write for example {}", kind.written()))
    }

    pub(super) fn unknown_unit(found: &str, unit: &str) -> Self {
        let mut near = meant(unit);
        if near.is_empty() {
            near = closest(unit, UNITS.iter().map(|known| known.0));
        }
        let help = match near.is_empty() {
            true => format!("known units: {}", UNITS.map(|unit| unit.0).join(", ")),
            false => format!("did you mean {}?", near.into_iter().map(display_name).collect::<Vec<_>>().join(" or ")),
        };
        Self::new(format!("unknown unit `{unit}` in {found:?}"), help)
    }
}
