//! Contact of the sheet's faces with rigid tools: gap, pressure, friction, tangent.
//!
//! ```text
//! g = d(x) − t/2               gap between the tool and the sheet's face (current thickness)
//! N = a p(g + λ)               normal force on the area a of a contact point, smoothed penalty p
//! T = −a τ(p, s)               friction against the slip s relative to the tool
//! ```
//!
//! The virtual work is F·δx + Q δt: Q is the mean normal stress of the pressure on one face.

pub mod friction;
pub mod penalty;

use crate::geometry::{Point, turned};
use crate::numerics::ValueAndSlope;
use friction::{Friction, Sliding};
use nalgebra::{Matrix3, Vector3};
use penalty::Penalty;

/// Point of the mid-surface within reach of a tool.
#[derive(Clone, Copy, Debug)]
pub struct ContactPoint {
    /// Normal n from the tool to the sheet; the tangent τ is n turned by +90°.
    pub facing: Point,
    /// Curvature c of the distance \[1/mm\].
    pub curvature: f64,
    /// Gap between the tool and the sheet's face \[mm\].
    pub gap: f64,
    /// Derivative h of the gap by the thickness \[–\]: −½ of the mid-surface's area over that of the face.
    pub by_thickness: f64,
    /// Displacement in the step relative to the tool \[mm\].
    pub relative: Point,
    /// Area a of the face that belongs to the point \[mm², or mm per mm of depth\].
    pub area: f64,
    /// Pressure carried from the last iteration \[MPa\]; zero gives the consistent tangent.
    pub carried: f64,
    /// Shift λ ≤ 0 of the augmented Lagrangian \[mm\].
    pub shift: f64,
    /// Shear yield stress of the sheet \[MPa\].
    pub shear_yield: f64,
}

/// Forces F on the position x of a contact point and Q on its element's thickness t, and their derivatives.
///
/// ```text
/// dg = n·dx + h dt,  ds = (1 − c n·Δx) τ·dx,  dn = c τ (τ·dx),  dτ = −c n (τ·dx)
/// F = N n + T τ,  ∂F/∂x = ∂F/∂g⊗n + ((∂T/∂s ds/dx + N c) τ − T c n)⊗τ,  ∂F/∂t = h ∂F/∂g
/// Q = h N,        ∂Q/∂x = h ∂N/∂g n,                                   ∂Q/∂t = h² ∂N/∂g
/// ```
#[derive(Clone, Copy, Debug)]
pub struct ContactForce {
    /// Slip s of the step along τ \[mm\].
    pub slip: f64,
    /// Pressure \[MPa\] and the slope dp/dg of the matrix \[N/mm³\].
    pub pressure: ValueAndSlope,
    /// Normal force N ≥ 0 \[N, or N/mm\].
    pub normal: f64,
    /// Friction T along τ \[N, or N/mm\].
    pub tangential: f64,
    /// F_r, F_z, Q \[N, or N/mm\].
    pub force: Vector3<f64>,
    /// Derivatives of these forces (rows) by r, z, t (columns).
    pub matrix: Matrix3<f64>,
}

impl ContactPoint {
    /// Force on the point in a step of a `duration` \[s\] with the regularisation s₀ = `scale` of the slip \[mm\]; zero out of reach.
    pub fn force(&self, penalty: &Penalty, friction: &Friction, scale: f64, duration: f64) -> ContactForce {
        let Self { facing: n, curvature: c, by_thickness: h, relative, area, shear_yield, .. } = *self;
        let pressure = penalty.towards(self.gap + self.shift, self.carried);
        let (tau, slip) = (turned(n), n.perp(&relative));
        let friction = friction.at(&Sliding { pressure: pressure.value, slip, scale, duration, shear_yield });
        let (normal, tangential) = (area * pressure.value, -(area * friction.value));
        let normal_by_gap = area * pressure.slope;
        let by_gap = n * normal_by_gap - tau * (normal_by_gap * friction.by_pressure);
        let on_tau = normal * c - area * friction.by_slip * (1.0 - c * n.dot(&relative));
        let by_position = by_gap * n.transpose() + (tau * on_tau - n * (tangential * c)) * tau.transpose();
        let (force, on_gap) = (n * normal + tau * tangential, h * normal_by_gap);
        let mut matrix = Matrix3::zeros();
        matrix.fixed_view_mut::<2, 2>(0, 0).copy_from(&by_position);
        matrix.fixed_view_mut::<2, 1>(0, 2).copy_from(&(by_gap * h));
        matrix.fixed_view_mut::<1, 2>(2, 0).copy_from(&(n * on_gap).transpose());
        matrix[(2, 2)] = h * on_gap;
        ContactForce { slip, pressure, normal, tangential, force: force.push(h * normal), matrix }
    }
}
