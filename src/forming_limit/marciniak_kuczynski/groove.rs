//! The sheet (A) and its groove (B), side by side.
//!
//! ```text
//! n, t: across and along the groove; n turns by tan φ = tan φ₀ exp(ε₁ − ε₂)
//! Δε_tt is the same in both;  σ_nn t and σ_nt t are the same in both
//! unknown: Δε_nn and Δγ_nt of the groove, for a step Δε̄ of the sheet
//! σ_y at the end of the step; Newton's method with differences
//! ```
//!
//! Stresses of the groove's strains are those of the sheet's yield condition, in their own principal directions.

use super::MarciniakKuczynski;
use crate::forming_limit::{Sheet, instability::Proportional};
use crate::material::{YieldCriterion, flow::YieldCondition, law::LawError};
use nalgebra::{Matrix2, Vector2};

/// Smallest step of equivalent strain \[–\]; there the limit has been found to as much.
const SMALLEST: f64 = 1e-7;
/// Stress across a groove over the yield stress below which it is not pulled apart \[–\]: it lies along the pull.
const PULLED: f64 = 0.1;
/// Accepted residual over the force across the groove \[–\], and most iterations.
const TOLERANCE: f64 = 1e-11;
const ITERATIONS: usize = 40;

/// A sheet with a groove, strained in proportion.
pub struct Groove<'a> {
    parameters: MarciniakKuczynski,
    sheet: &'a Sheet<'a>,
    path: Proportional,
    criterion: YieldCriterion,
    tangent: f64,
}

#[derive(Clone, Copy)]
struct Strained {
    /// Equivalent strains of sheet and groove \[–\].
    sheet: f64,
    groove: f64,
    /// ln(t/t₀) of the groove \[–\].
    thickness: f64,
    /// Δε_nn and Δγ_nt of the groove per Δε̄ of the sheet, in the last step.
    rate: Vector2<f64>,
}

impl<'a> Groove<'a> {
    /// A groove whose normal lies at `angle` \[rad\] from the major strain at the start, for a strain ratio `beta`.
    pub fn new(parameters: MarciniakKuczynski, sheet: &'a Sheet<'a>, beta: f64, angle: f64) -> Self {
        let criterion = sheet.material.yield_criterion;
        Self { parameters, sheet, path: Proportional::new(criterion, beta), criterion, tangent: angle.tan() }
    }

    /// Equivalent strain when the groove necks; `None` where it does not. Fails when the equations lose their solution.
    pub fn neck(&self, mut step: f64) -> Result<Option<f64>, LawError> {
        let ([across, _], shear) = self.in_groove(self.path.strain, 0.0);
        let mut now = Strained { sheet: 0.0, groove: 0.0, thickness: 0.0, rate: Vector2::new(across, 2.0 * shear) };
        // Of the last step that was taken, and of the fastest that was tried.
        let (mut ratio, mut fastest) = (1.0, 1.0_f64);
        while step > SMALLEST {
            if self.in_groove(self.path.stress, now.sheet).0[0] < PULLED {
                return Ok(None);
            }
            let next = self.advance(&now, step).map(|next| (next, (next.groove - now.groove) / step));
            fastest = next.map_or(fastest, |(_, faster)| fastest.max(faster));
            match next {
                Some((next, faster)) if faster < MarciniakKuczynski::CRITICAL => {
                    (now, ratio) = (next, faster);
                    if now.sheet > MarciniakKuczynski::LARGEST {
                        return Ok(None);
                    }
                }
                _ => step *= 0.5,
            }
        }
        // Without a solution that necks the equations have failed, not the sheet.
        if fastest >= MarciniakKuczynski::CRITICAL {
            return Ok(Some(now.sheet));
        }
        let (strain, beta) = (now.sheet, self.path.strain[1] / self.path.strain[0]);
        let what = format!(
            "the groove's equations have no solution beyond an equivalent strain of {strain:.4}, where it strains \
             {ratio:.1} times as fast as the sheet, at a strain ratio of {beta:.3}"
        );
        Err(LawError::new(what, "use hill or points; an imperfection nearer to 1 may help"))
    }

    /// Both at the end of a step of `step`; `None` where the groove cannot bear the sheet's force.
    fn advance(&self, now: &Strained, step: f64) -> Option<Strained> {
        let (sheet, duration) = (now.sheet + step, step / self.parameters.strain_rate);
        let along = self.in_groove(self.path.strain, sheet).0[1] * step;
        let ([stress, _], shear) = self.in_groove(self.path.stress, sheet);
        let thinning = (self.path.strain[0] + self.path.strain[1]) * sheet;
        let yield_stress = self.yield_stress(sheet, self.parameters.strain_rate);
        // Per width over f₀ t₀ [MPa].
        let force = yield_stress * (-thinning).exp() / self.parameters.imperfection;
        let [across_force, along_force] = [force * stress, force * shear];
        // Missing part of the sheet's forces in the groove, over the force across it.
        let residual = |x: Vector2<f64>| {
            let (increment, [pull, slip]) = self.turned(x[0], along, x[1]);
            let yields = self.yield_stress(now.groove + increment, increment / duration);
            let thin = (now.thickness - x[0] - along).exp();
            let (pull, slip) = (yields * thin * pull, yields * thin * slip);
            (increment > 0.0).then(|| Vector2::new(pull / across_force - 1.0, (slip - along_force) / across_force))
        };
        let mut x = now.rate * step;
        let h = 1e-7 * step;
        for _ in 0..ITERATIONS {
            let r = residual(x)?;
            let (increment, _) = self.turned(x[0], along, x[1]);
            if r.amax() < TOLERANCE {
                let thickness = now.thickness - x[0] - along;
                return Some(Strained { sheet, groove: now.groove + increment, thickness, rate: x / step });
            }
            let column = |along: Vector2<f64>| Some((residual(x + h * along)? - r) / h);
            let move_by = Matrix2::from_columns(&[column(Vector2::x())?, column(Vector2::y())?]).try_inverse()? * -r;
            // No further than the groove strains: beyond, the difference quotients mean nothing.
            x += move_by * (0.5 * increment.max(step) / move_by.amax()).min(1.0);
            if !x.iter().all(|x| x.is_finite()) {
                return None;
            }
        }
        None
    }

    /// Across, along (nn, tt) and shear (nt) components of principal values, at an equivalent strain of the sheet.
    fn in_groove(&self, [first, second]: [f64; 2], sheet: f64) -> ([f64; 2], f64) {
        let [e1, e2] = self.path.strain;
        let tan = self.tangent * ((e1 - e2) * sheet).exp();
        let cos2 = 1.0 / (1.0 + tan * tan);
        let (sin2, product) = (1.0 - cos2, tan * cos2);
        ([cos2 * first + sin2 * second, sin2 * first + cos2 * second], product * (second - first))
    }

    /// Equivalent strain increment \[–\], and σ_nn and σ_nt over the yield stress \[–\], of Δε_nn, Δε_tt and Δγ_nt.
    fn turned(&self, nn: f64, tt: f64, shear: f64) -> (f64, [f64; 2]) {
        let (mean, half, slip) = (0.5 * (nn + tt), 0.5 * (nn - tt), 0.5 * shear);
        let radius = half.hypot(slip);
        let principal = [mean + radius, mean - radius, 0.0];
        let [s1, s2, _] = self.criterion.stress(principal);
        // Where both strains are alike, so are the stresses, and no direction stands out.
        let (cos, sin) = if radius > 0.0 { (half / radius, slip / radius) } else { (1.0, 0.0) };
        let (middle, apart) = (0.5 * (s1 + s2), 0.5 * (s1 - s2));
        (self.criterion.equivalent_increment(principal), [middle + apart * cos, apart * sin])
    }

    fn yield_stress(&self, strain: f64, rate: f64) -> f64 {
        self.sheet.hardening(strain).stress * self.sheet.material.rate.map_or(1.0, |law| law.at(rate).value)
    }
}
