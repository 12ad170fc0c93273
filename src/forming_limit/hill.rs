//! Localised necking on the left.

use super::instability::{Hardened, Proportional, hardening_note, ratios};
use super::plane::Plane;
use super::{Curve, Kind, Sheet, swift};
use crate::material::law::LawError;

/// Hill's localised necking: a neck along the line that does not stretch, where σ_y'/σ_y = (1 + β) dε₁/dε̄.
///
/// For a power law ε₁ + ε₂ = n. With β > 0 no line of the sheet keeps its length: there the curve goes on as
/// [`super::Swift`]'s, which meets it in plane strain.
///
/// # References
/// R. Hill, On discontinuous plastic states, with special reference to localized necking in thin sheets, J. Mech. Phys.
/// Solids 1 (1952) 19–30 (not read; derived here from the load normal to the neck). That both together are a usual pair:
/// W. Bleck et al., J. Mater. Process. Technol. 83 (1998) 223–230 (abstract read).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hill {
    /// Exponent of a power law in place of the sheet's own \[–\].
    pub n: Option<f64>,
}

impl Hill {
    pub(super) fn curve(&self, sheet: &Sheet) -> Result<Curve, LawError> {
        let plane = Plane::of(sheet.material);
        let mut hardened = Hardened::new(sheet, self.n);
        let point = |beta: f64| {
            if beta > 0.0 {
                return swift::point(plane, &mut hardened, beta);
            }
            let path = Proportional::new(plane, beta);
            let strain = hardened.limit(path.strain[0] + path.strain[1])?;
            Ok([path.strain[1] * strain, path.strain[0] * strain])
        };
        let points = ratios(plane, 20, 20).map(point).collect::<Result<_, _>>()?;
        let law = hardening_note(self.n);
        let notes = vec![format!(
            "Forming limit: Hill's localised necking on the left, Swift's diffuse necking on the right, by {law}."
        )];
        Curve::new(Kind::Hill(*self), sheet, points, notes)
    }
}
