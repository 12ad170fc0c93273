//! Whether the hardening law is that of a sheet metal, or in a wrong unit.

use super::Finding;
use crate::assess::estimate::tensile_strength;
use crate::model::Model;
use crate::table::Unit;
use crate::units::Amount;

/// Tensile strength above that of any cold-formed sheet \[MPa\].
const STRONGEST: f64 = 3000.0;
/// Tensile strength below that of any cold-formed sheet \[MPa\].
const WEAKEST: f64 = 10.0;

/// Whether the sheet is weaker than any; hot sheet, whose stress comes from the rate, may well be.
pub(super) fn is_weak(model: &Model) -> bool {
    tensile_strength(&model.material) < WEAKEST && model.material.rate.is_none()
}

/// A tensile strength that no sheet metal has.
pub(super) fn unusual(model: &Model) -> Option<Finding> {
    let strength = tensile_strength(&model.material);
    let (found, advice) = if strength > STRONGEST {
        let found =
            format!("a tensile strength of {strength} is that of no sheet metal", strength = Amount::stress(strength));
        (found, "check the law's units")
    } else if is_weak(model) {
        let found = format!(
            "a tensile strength of {strength}, below {weakest}, is that of no sheet metal",
            strength = Amount::stress(strength),
            weakest = Amount::given_stress(WEAKEST)
        );
        (found, "check the unit of the law's stresses")
    } else {
        return None;
    };
    let limit = format!("{low} to {high}", low = Amount::given_stress(WEAKEST), high = Amount::given_stress(STRONGEST));
    let warning = Finding::warning("strength", "Tensile strength", found).against(strength, Unit::MPa, limit);
    let warning = if strength > STRONGEST { warning.at_most(STRONGEST, None) } else { warning.at_least(WEAKEST, None) };
    Some(warning.advice(advice))
}
