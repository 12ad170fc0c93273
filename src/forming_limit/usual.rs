//! Forming limit of a sheet whose case gives none: computed, never measured.
//!
//! Keeler and Brazier for mild steel, Hill and Swift for every other metal.

use super::*;
use std::ops::RangeInclusive;

/// Young's modulus of steel \[MPa\], and largest n of ferritic sheet \[–\]: declared. They count where no crystal is given.
const STEEL: RangeInclusive<f64> = 190e3..=220e3;
const FERRITE: f64 = 0.3;
/// Largest tensile strength of Keeler and Brazier's steels \[MPa\]: CR340Y/590T-DP (AHSS Insights, Forming Limit Curves).
const STRENGTH: f64 = 590.0;

impl Kind {
    /// Curve of a sheet whose case gives none. Fails when the hardening law has no load maximum, or begins with it.
    pub fn usual(sheet: &Sheet) -> Result<Curve, LawError> {
        let (material, n) = (sheet.material, uniform_strain(sheet)?);
        let is_ferritic = match material.yield_criterion {
            YieldCriterion::Hosford(hosford) => hosford.exponent() == 6.0,
            YieldCriterion::Hill48(_) => {
                n <= FERRITE && material.elastic.is_some_and(|elastic| STEEL.contains(&elastic.young))
            }
        };
        let is_mild = sheet.hardening(n).stress * (-n).exp() <= STRENGTH;
        let is_known = is_ferritic && is_mild && sheet.thickness <= KeelerBrazier::THICKNESS;
        let kind = if is_known { Self::KeelerBrazier(KeelerBrazier::default()) } else { Self::Hill(Hill { n: None }) };
        let mut curve = Curve { is_usual: true, ..kind.curve(sheet)? };
        let declared = "declared: the case gives no forming limit; this one is computed, not measured";
        curve.notes.insert(0, format!("{declared}: {}", curve.name));
        Ok(curve)
    }
}
