//! Maximum force: Hill's localised and Swift's diffuse necking.
//!
//! A sheet that is strained in proportion is stable while its hardening outruns its loss of section,
//!
//! ```text
//! σ_y'/σ_y > H(β)      H: Considère 1, Hill (1 + β) dε₁/dε̄, Swift by its two forces
//! ```
//!
//! For σ = K (ε₀ + ε̄)^n the limit is ε̄ = n/H − ε₀; here it is found for any law.

use super::*;
use crate::material::flow::YieldCondition;
use crate::numerics::bisect;

/// Strains are searched up to this equivalent strain, in steps of [`STEP`] \[–\].
const LARGEST: f64 = 3.0;
const STEP: f64 = 1e-3;

/// Strain of the largest tension force, σ' = σ (A. Considère, 1885) \[–\]. Fails without a maximum.
pub fn uniform_strain(sheet: &Sheet) -> Result<f64, LawError> {
    limit(sheet, None, 1.0)
}

/// Equivalent strain at which σ_y'/σ_y has come down to `loss` \[–\]; by the power law where its exponent is given.
fn limit(sheet: &Sheet, n: Option<f64>, loss: f64) -> Result<f64, LawError> {
    if let Some(n) = n {
        return Ok(n / loss);
    }
    let stable = |strain: f64| {
        let law = sheet.hardening(strain);
        law.slope > loss * law.stress
    };
    if !stable(1e-6) {
        let help = "give points, or marciniak_kuczynski where a rate law holds the sheet together";
        return Err(LawError::new("the hardening law hardly hardens: its force falls from the start", help));
    }
    let Some(i) = (1..=(LARGEST / STEP) as usize).find(|i| !stable(STEP * *i as f64)) else {
        let what = format!("the hardening law has no load maximum up to a strain of {LARGEST}");
        return Err(LawError::new(what, "give n, or points"));
    };
    let [low, high] = bisect(STEP * (i - 1) as f64, STEP * i as f64, 50, stable);
    Ok(0.5 * (low + high))
}

/// A proportional path of strain ratio β: by unit of equivalent strain and of equivalent stress \[–\].
#[derive(Clone, Copy, Debug)]
pub(super) struct Proportional {
    /// dε₁/dε̄ and dε₂/dε̄.
    pub strain: [f64; 2],
    /// σ₁/σ_y and σ₂/σ_y.
    pub stress: [f64; 2],
}

impl Proportional {
    pub fn new(criterion: YieldCriterion, beta: f64) -> Self {
        let unit = 1.0 / criterion.equivalent_increment([1.0, beta, 0.0]);
        let [s1, s2, _] = criterion.stress([1.0, beta, 0.0]);
        Self { strain: [unit, beta * unit], stress: [s1, s2] }
    }
}

/// Ratios from tension to plane strain, and to equi-biaxial stretching unless that is [overrated](overrates_biaxial).
pub(super) fn ratios(criterion: YieldCriterion, left: usize, right: usize) -> impl Iterator<Item = f64> {
    let right = if overrates_biaxial(criterion) { 0 } else { right };
    // β of uniaxial tension, by the meaning of r̄.
    let tension = -criterion.ratio() / (1.0 + criterion.ratio());
    let drawn = (0..=left).map(move |i| tension * (1.0 - i as f64 / left as f64));
    drawn.chain((1..=right).map(move |i| i as f64 / right as f64))
}

/// Hill's localised necking: a neck along the line that does not stretch, where σ_y'/σ_y = (1 + β) dε₁/dε̄.
///
/// For a power law ε₁ + ε₂ = n. With β > 0 the curve goes on as [`Swift`]'s, which meets it in plane strain.
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
        let what = "Hill's localised necking on the left, Swift's diffuse necking on the right,";
        curve("Hill and Swift", self.n, sheet, what, |path| match path.strain {
            [_, minor] if minor > 0.0 => diffuse(path),
            [major, minor] => major + minor,
        })
    }
}

/// Swift's diffuse necking: both forces are at their maxima, dσ₁ = σ₁ dε₁ and dσ₂ = σ₂ dε₂, so that
///
/// ```text
/// σ_y'/σ_y = s₁ (dε₁/dε̄)² + s₂ (dε₂/dε̄)²       s = σ/σ_y
/// ```
///
/// For a power law of the isotropic sheet ε₁ = n in tension, in plane strain and in equi-biaxial stretching: a lower bound.
///
/// Source: H. W. Swift, J. Mech. Phys. Solids 1 (1952) 1–18 (not read; derived here from the two forces).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swift {
    /// Exponent of a power law in place of the sheet's own \[–\].
    pub n: Option<f64>,
}

impl Swift {
    pub(super) fn curve(&self, sheet: &Sheet) -> Result<Curve, LawError> {
        curve("Swift", self.n, sheet, "Swift's diffuse necking", diffuse)
    }
}

fn diffuse(Proportional { strain: [e1, e2], stress: [s1, s2] }: &Proportional) -> f64 {
    s1 * e1 * e1 + s2 * e2 * e2
}

fn curve(
    name: &'static str, n: Option<f64>, sheet: &Sheet, what: &str, loss: impl Fn(&Proportional) -> f64,
) -> Result<Curve, LawError> {
    let criterion = sheet.material.yield_criterion;
    let point = |beta: f64| {
        let path = Proportional::new(criterion, beta);
        let strain = limit(sheet, n, loss(&path))?;
        Ok([path.strain[1] * strain, path.strain[0] * strain])
    };
    let points = ratios(criterion, 20, 20).map(point).collect::<Result<_, _>>()?;
    let law = n.map_or("the hardening law of the sheet".into(), |n| {
        format!("a power law of n = {n}, as given", n = Amount::number(n).to(Digits::Given(6)))
    });
    Ok(Curve::new(name, points, vec![format!("Forming limit: {what} by {law}.")])?.computed(sheet))
}
