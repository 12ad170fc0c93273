//! Contact points and the tangent of their forces.

use crate::contact::{ContactForce, ContactPoint};
use crate::element::surface::Station;
use crate::element::{Node, Vector6};
use crate::geometry::Point;
use crate::numerics::block_tridiagonal::System;
use nalgebra::{Matrix3, SMatrix, Vector3};

/// Position of a contact point \[mm\], and the thickness of the sheet there \[mm\].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ContactPosition {
    pub position: Point,
    pub thickness: f64,
}

impl ContactPosition {
    /// Position of a station of the element between nodes `a` and `b`; `rise` is half its thickness difference.
    pub fn new(station: &Station, a: &Node, b: &Node, thickness: f64, rise: f64) -> Self {
        Self { position: station.position(a, b), thickness: thickness + station.xi * rise }
    }

    /// Gap of a tool at this distance from the mid-surface \[mm\].
    pub fn gap(&self, distance: f64) -> f64 {
        distance - 0.5 * self.thickness
    }
}

/// Contact point within reach of a tool.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactCandidate {
    pub index: usize,
    pub point: ContactPoint,
    /// Derivative of the gap by the thickness \[–\].
    pub by_thickness: f64,
}

/// Forces F on the position x of a contact point and Q on its element's thickness t, and their derivatives.
///
/// ```text
/// dg = n·dx + h dt,  h = −½ of the area of the mid-surface over that of the face
/// F = N n + T τ,  ∂F/∂x = ∂F/∂g⊗n + ((∂T/∂s + N c) τ − T c n)⊗τ,  ∂F/∂t = h ∂F/∂g
/// Q = h N,        ∂Q/∂x = h ∂N/∂g n,                              ∂Q/∂t = h² ∂N/∂g
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct ContactForceTangent {
    /// F_r, F_z, Q \[N, or N/mm\].
    pub force: Vector3<f64>,
    /// Derivatives of these forces (rows) by r, z, t (columns).
    pub matrix: Matrix3<f64>,
}

impl ContactForceTangent {
    /// Tangent of a force whose gap changes with the thickness by `by_thickness`, h.
    pub fn new(contact: &ContactForce, by_thickness: f64) -> Self {
        let (n, tau, c, h) = (contact.facing, contact.along(), contact.curvature, by_thickness);
        let by_gap = n * contact.by_gap + tau * contact.friction_by_gap;
        let on_tau = contact.friction_by_slip * contact.slip_turn + contact.normal * c;
        let by_position = by_gap * n.transpose() + (tau * on_tau - n * (contact.tangential * c)) * tau.transpose();
        let (force, on_gap) = (contact.force(), h * contact.by_gap);
        let mut matrix = Matrix3::zeros();
        matrix.fixed_view_mut::<2, 2>(0, 0).copy_from(&by_position);
        matrix.fixed_view_mut::<2, 1>(0, 2).copy_from(&(by_gap * h));
        matrix.fixed_view_mut::<1, 2>(2, 0).copy_from(&(n * on_gap).transpose());
        matrix[(2, 2)] = h * on_gap;
        Self { force: Vector3::new(force.x, force.y, h * contact.normal), matrix }
    }

    /// True if a tool acts here.
    pub fn acts(&self) -> bool {
        self.force.z != 0.0 || self.matrix.m33 != 0.0
    }

    /// Adds the columns and rows of the tool's displacement along z, the `shared`-th of the shared unknowns: the forces
    /// depend on it as on the point's z, with the opposite sign.
    pub fn follow(&self, e: usize, slope: &SMatrix<f64, 3, 6>, shared: usize, system: &mut System) {
        let column = slope.tr_mul(&self.matrix.column(1));
        let row = slope.tr_mul(&self.matrix.row(1).transpose());
        for (node, first) in [(e, 0), (e + 1, 3)] {
            system.columns[node][shared] += column.fixed_rows::<3>(first);
            system.rows[node][shared] += row.fixed_rows::<3>(first);
        }
        system.corner[(shared, shared)] -= self.matrix.m22;
    }
}

/// Derivatives of a contact point's position and its element's thickness (rows r, z, t) by the element's freedoms.
pub(super) fn slope(station: &Station, a: &Node, b: &Node, thickness: &Vector6) -> SMatrix<f64, 3, 6> {
    let mut slope = SMatrix::<f64, 3, 6>::zeros();
    slope.fixed_rows_mut::<2>(0).copy_from(&station.slope(a, b));
    slope.set_row(2, &thickness.transpose());
    slope
}
