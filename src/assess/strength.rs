//! Whether the hardening law is that of a sheet metal, or in a wrong unit.

use super::Finding;
use crate::model::Model;
use crate::rules::estimate::tensile_strength;
use crate::table::Unit;
use crate::units::mm;

/// Tensile strength above that of any cold-formed sheet \[MPa\].
const STRONGEST: f64 = 3000.0;
/// Tensile strength below that of any cold-formed sheet \[MPa\].
const WEAKEST: f64 = 10.0;

/// Whether the sheet is weaker than any; hot sheet, whose stress comes from the rate, may well be.
pub(super) fn is_weak(model: &Model) -> bool {
    tensile_strength(&model.material.hardening) < WEAKEST && model.material.rate.is_none()
}

/// A tensile strength that no sheet metal has.
pub(super) fn unusual(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material.hardening);
    let (found, advice) = if strength > STRONGEST {
        (format!("a tensile strength of {strength:.0} MPa is that of no sheet metal"), "check the law's units")
    } else if is_weak(model) {
        let found =
            format!("a tensile strength of {} MPa, below {WEAKEST} MPa, is that of no sheet metal", mm(strength));
        (found, "check the unit of the law's stresses")
    } else {
        return None;
    };
    Some(
        Finding::warning("strength", "Tensile strength", found)
            .against(strength, Unit::MPa, format!("{WEAKEST} to {STRONGEST} MPa"))
            .advice(advice),
    )
}
