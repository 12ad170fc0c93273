//! Elasticity and yield condition as matrices of the plane and the transverse shear.

use crate::material::hill48::SHEAR_INVERSE;
use crate::material::hosford::ordered;
use crate::material::yield_condition::Triple;
use crate::material::{Elastic, Hosford, YieldCriterion};

/// Most iterations: bisection alone needs fifty.
pub(super) const MOST: usize = 80;
/// Step after which the next one is round-off \[–\]: Newton's method is of second order.
pub(super) const CLOSE: f64 = 1e-8;

/// Symmetric matrix of the plane and the transverse shear: ss, sθ, θθ, γγ.
pub(super) type Orthotropic = [f64; 4];

pub(super) fn times([ss, st, tt, gg]: Orthotropic, [s, t, g]: Triple) -> Triple {
    [ss * s + st * t, st * s + tt * t, gg * g]
}

pub(super) fn inverse([ss, st, tt, gg]: Orthotropic) -> Orthotropic {
    let determinant = ss * tt - st * st;
    [tt / determinant, -st / determinant, ss / determinant, 1.0 / gg]
}

/// Elastic matrix and yield condition of a sheet.
#[derive(Clone, Copy, Debug)]
pub struct Operators {
    /// D \[MPa\].
    pub(super) stiffness: Orthotropic,
    /// D⁻¹ \[1/MPa\].
    pub(super) compliance: Orthotropic,
    /// P of Hill's condition of the same r̄ \[–\].
    pub(super) quadratic: Orthotropic,
    /// `None` for Hill's condition.
    pub(super) hosford: Option<Hosford>,
}

impl Operators {
    /// Operators of a sheet with these elastic constants and yield condition.
    pub fn new(elastic: Elastic, criterion: YieldCriterion) -> Self {
        let [sum, difference, shear] = elastic.moduli();
        let stiffness = [0.5 * (sum + difference), 0.5 * (sum - difference), 0.5 * (sum + difference), shear];
        let hosford = match criterion {
            YieldCriterion::Hill48(_) => None,
            YieldCriterion::Hosford(hosford) => Some(hosford),
        };
        let quadratic = [1.0, -criterion.quadratic().coupling, 1.0, SHEAR_INVERSE];
        Self { stiffness, compliance: inverse(stiffness), quadratic, hosford }
    }

    /// m D⁻¹ + Δp P.
    pub(super) fn flexibility(&self, m: f64, increment: f64, p: Orthotropic) -> Orthotropic {
        std::array::from_fn(|j| m * self.compliance[j] + increment * p[j])
    }

    /// P at n = S D⁻¹ η by Newton's method for the ratio x of n, which rises with that of η from −1 to 1.
    ///
    /// `near` is a ratio close to the root, and becomes the root.
    pub(super) fn curvature(
        &self,
        hosford: &Hosford,
        eta: Triple,
        m: f64,
        increment: f64,
        near: &mut Option<f64>,
    ) -> Orthotropic {
        let (major, minor, swapped) = ordered(eta);
        let ratio = if major == 0.0 { 0.0 } else { minor / major };
        let pull = times(self.compliance, [1.0, ratio, 0.0]);
        let p = |x: f64| {
            let [ss, st, tt] = hosford.curvature(x);
            [ss, st, tt, SHEAR_INVERSE]
        };
        let (mut low, mut high) = (-1.0, 1.0);
        let mut x = near.unwrap_or(ratio);
        for _ in 0..MOST {
            let flexibility = self.flexibility(m, increment, p(x));
            let [s, t, _] = times(self.stiffness, times(flexibility, [1.0, x, 0.0]));
            if t > ratio * s {
                high = x
            } else {
                low = x
            }
            let [s, t, _] = times(inverse(flexibility), pull);
            let (next, last) = (t / s, x);
            x = if next >= low && next <= high { next } else { 0.5 * (low + high) };
            if (x - last).abs() <= CLOSE {
                break;
            }
        }
        *near = Some(x);
        let [ss, st, tt, gg] = p(x);
        if swapped { [tt, st, ss, gg] } else { [ss, st, tt, gg] }
    }
}
