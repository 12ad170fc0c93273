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

use crate::forming_limit::Sheet;
use crate::forming_limit::instability::Proportional;
use crate::forming_limit::plane::Plane;
use nalgebra::{Matrix2, Vector2};

/// Strain rate of the groove over that of the sheet at which the sheet counts as necked \[–\].
pub const CRITICAL: f64 = 10.0;
/// Largest equivalent strain that is searched \[–\].
pub const LARGEST: f64 = 4.0;
/// Smallest step of equivalent strain \[–\]; there the limit has been found to as much.
const SMALLEST: f64 = 1e-7;
/// Stress across a groove over the yield stress below which it is not pulled apart \[–\]: it lies along the pull.
const PULLED: f64 = 0.1;
/// Accepted residual over the force across the groove \[–\], and most iterations.
const TOLERANCE: f64 = 1e-11;
const ITERATIONS: usize = 40;

/// The equations lost their solution before the groove was necking.
#[derive(Clone, Copy, Debug)]
pub struct Failure {
    /// Equivalent strain of the sheet \[–\], and strain rate of the groove over that of the sheet.
    pub strain: f64,
    pub ratio: f64,
}

/// A sheet with a groove, strained in proportion.
pub struct Groove<'a> {
    /// f₀ \[–\].
    imperfection: f64,
    /// ε̄̇ of the sheet \[1/s\].
    strain_rate: f64,
    sheet: &'a Sheet<'a>,
    path: Proportional,
    plane: Plane,
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

struct Demand {
    /// Δε_tt.
    along: f64,
    /// Forces per width over f₀ t₀ \[MPa\]: across the groove, and along it.
    force: [f64; 2],
    duration: f64,
}

impl<'a> Groove<'a> {
    /// A groove of `imperfection` times the sheet's thickness, whose normal lies at `angle` \[rad\] from the major strain at the start.
    pub fn new(imperfection: f64, strain_rate: f64, sheet: &'a Sheet<'a>, beta: f64, angle: f64) -> Self {
        let plane = Plane::of(sheet.material);
        Self { imperfection, strain_rate, sheet, path: Proportional::new(plane, beta), plane, tangent: angle.tan() }
    }

    /// Equivalent strain of the sheet when the groove necks; `None` where it does not.
    pub fn neck(&self, step: f64) -> Result<Option<f64>, Failure> {
        let ([across, _], shear) = self.in_groove(self.path.strain, 0.0);
        let mut now = Strained { sheet: 0.0, groove: 0.0, thickness: 0.0, rate: Vector2::new(across, 2.0 * shear) };
        // Of the last step that was taken, and of the fastest that was tried.
        let (mut ratio, mut fastest) = (1.0, 1.0_f64);
        let mut step = step;
        while step > SMALLEST {
            if self.in_groove(self.path.stress, now.sheet).0[0] < PULLED {
                return Ok(None);
            }
            let next = self.advance(&now, step).map(|next| (next, (next.groove - now.groove) / step));
            fastest = next.map_or(fastest, |(_, faster)| fastest.max(faster));
            match next {
                Some((next, faster)) if faster < CRITICAL => {
                    (now, ratio) = (next, faster);
                    if now.sheet > LARGEST {
                        return Ok(None);
                    }
                }
                _ => step *= 0.5,
            }
        }
        // Without a solution that necks the equations have failed, not the sheet.
        if fastest >= CRITICAL { Ok(Some(now.sheet)) } else { Err(Failure { strain: now.sheet, ratio }) }
    }

    /// Both at the end of a step of `step`; `None` where the groove cannot bear the sheet's force.
    fn advance(&self, now: &Strained, step: f64) -> Option<Strained> {
        let sheet = now.sheet + step;
        let duration = step / self.strain_rate;
        let [_, along] = self.in_groove(self.path.strain, sheet).0;
        let ([stress, _], shear) = self.in_groove(self.path.stress, sheet);
        let thinning = (self.path.strain[0] + self.path.strain[1]) * sheet;
        let force = self.yield_stress(sheet, self.strain_rate) * (-thinning).exp() / self.imperfection;
        let demand = Demand { along: along * step, force: [force * stress, force * shear], duration };
        let mut x = now.rate * step;
        let h = 1e-7 * step;
        for _ in 0..ITERATIONS {
            let r = self.residual(now, &demand, x)?;
            let (increment, _) = self.plane.turned(x[0], demand.along, x[1]);
            if r.amax() < TOLERANCE {
                let thickness = now.thickness - x[0] - demand.along;
                return Some(Strained { sheet, groove: now.groove + increment, thickness, rate: x / step });
            }
            let column = |along: Vector2<f64>| Some((self.residual(now, &demand, x + h * along)? - r) / h);
            let jacobian = Matrix2::from_columns(&[column(Vector2::x())?, column(Vector2::y())?]);
            let move_by = jacobian.try_inverse()? * -r;
            // No further than the groove strains: beyond, the difference quotients mean nothing.
            x += move_by * (0.5 * increment.max(step) / move_by.amax()).min(1.0);
            if !x.iter().all(|x| x.is_finite()) {
                return None;
            }
        }
        None
    }

    /// Missing part of the sheet's forces in the groove, over the force across it \[–\].
    fn residual(&self, now: &Strained, demand: &Demand, x: Vector2<f64>) -> Option<Vector2<f64>> {
        let (increment, [pull, slip]) = self.plane.turned(x[0], demand.along, x[1]);
        if increment.is_nan() || increment <= 0.0 {
            return None;
        }
        let yields = self.yield_stress(now.groove + increment, increment / demand.duration);
        let thin = (now.thickness - x[0] - demand.along).exp();
        let [wanted, along] = demand.force;
        Some(Vector2::new(yields * thin * pull / wanted - 1.0, (yields * thin * slip - along) / wanted))
    }

    /// Across, along (nn, tt) and shear (nt) components of principal values, at an equivalent strain of the sheet.
    fn in_groove(&self, [first, second]: [f64; 2], sheet: f64) -> ([f64; 2], f64) {
        let [e1, e2] = self.path.strain;
        let tan = self.tangent * ((e1 - e2) * sheet).exp();
        let cos2 = 1.0 / (1.0 + tan * tan);
        let (sin2, product) = (1.0 - cos2, tan * cos2);
        ([cos2 * first + sin2 * second, sin2 * first + cos2 * second], product * (second - first))
    }

    fn yield_stress(&self, strain: f64, rate: f64) -> f64 {
        let factor = self.sheet.material.rate.map_or(1.0, |law| law.at(rate).value);
        self.sheet.hardening(strain).stress * factor
    }
}
