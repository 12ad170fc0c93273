//! Diffuse necking.

use super::instability::{Hardened, Proportional, hardening_note, ratios};
use super::plane::Plane;
use super::{Curve, Kind, Sheet};
use crate::material::law::LawError;

/// Swift's diffuse necking: both forces are at their maxima, dσ₁ = σ₁ dε₁ and dσ₂ = σ₂ dε₂, so that
///
/// ```text
/// σ_y'/σ_y = s₁ (dε₁/dε̄)² + s₂ (dε₂/dε̄)²       s = σ/σ_y
/// ```
///
/// For a power law of the isotropic sheet ε₁ = n in tension, in plane strain and in equi-biaxial stretching: a lower bound.
///
/// # References
/// H. W. Swift, Plastic instability under plane stress, J. Mech. Phys. Solids 1 (1952) 1–18 (not read; derived here from the
/// two forces).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swift {
    /// Exponent of a power law in place of the sheet's own \[–\].
    pub n: Option<f64>,
}

impl Swift {
    pub(super) fn curve(&self, sheet: &Sheet) -> Result<Curve, LawError> {
        let (plane, mut hardened) = (Plane::of(sheet.material), Hardened::new(sheet, self.n));
        let points = ratios(plane, 20, 20).map(|beta| point(plane, &mut hardened, beta));
        let points = points.collect::<Result<Vec<_>, _>>()?;
        let note = format!("Forming limit: Swift's diffuse necking by {law}.", law = hardening_note(self.n));
        Curve::new(Kind::Swift(*self), sheet, points, vec![note])
    }
}

/// Minor and major strain at the limit of a strain ratio.
pub(super) fn point(plane: Plane, hardened: &mut Hardened, beta: f64) -> Result<[f64; 2], LawError> {
    let Proportional { strain: [e1, e2], stress: [s1, s2] } = Proportional::new(plane, beta);
    let strain = hardened.limit(s1 * e1 * e1 + s2 * e2 * e2)?;
    Ok([e2 * strain, e1 * strain])
}
