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
    rate: [f64; 2],
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
        let mut now = Strained { sheet: 0.0, groove: 0.0, thickness: 0.0, rate: [across, 2.0 * shear] };
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
        let mut x = now.rate.map(|rate| rate * step);
        let scale = 1e-7 * step;
        for _ in 0..ITERATIONS {
            let r = self.residual(now, &demand, x)?;
            if r[0].abs().max(r[1].abs()) < TOLERANCE {
                let (increment, _) = self.plane.turned(x[0], demand.along, x[1]);
                return Some(Strained {
                    sheet,
                    groove: now.groove + increment,
                    thickness: now.thickness - x[0] - demand.along,
                    rate: x.map(|x| x / step),
                });
            }
            let a = self.residual(now, &demand, [x[0] + scale, x[1]])?.map(|v| v / scale);
            let b = self.residual(now, &demand, [x[0], x[1] + scale])?.map(|v| v / scale);
            let [a, b] = [[a[0] - r[0] / scale, a[1] - r[1] / scale], [b[0] - r[0] / scale, b[1] - r[1] / scale]];
            let determinant = a[0] * b[1] - a[1] * b[0];
            let mut move_by = [-(r[0] * b[1] - r[1] * b[0]) / determinant, -(a[0] * r[1] - a[1] * r[0]) / determinant];
            // No further than the groove strains: beyond, the difference quotients mean nothing.
            let most = 0.5 * self.plane.turned(x[0], demand.along, x[1]).0.max(step);
            let far = move_by[0].abs().max(move_by[1].abs());
            if far > most {
                move_by = move_by.map(|m| m * most / far);
            }
            x = [x[0] + move_by[0], x[1] + move_by[1]];
            if !(x[0].is_finite() && x[1].is_finite()) {
                return None;
            }
        }
        None
    }

    /// Missing part of the sheet's forces in the groove, over the force across it \[–\].
    fn residual(&self, now: &Strained, demand: &Demand, [across, shear]: [f64; 2]) -> Option<[f64; 2]> {
        let (increment, [pull, slip]) = self.plane.turned(across, demand.along, shear);
        if increment.is_nan() || increment <= 0.0 {
            return None;
        }
        let yields = self.yield_stress(now.groove + increment, increment / demand.duration);
        let thin = (now.thickness - across - demand.along).exp();
        let [wanted, along] = demand.force;
        Some([yields * thin * pull / wanted - 1.0, (yields * thin * slip - along) / wanted])
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
