//! A contact point, and what tools do to it and through it to its element.

use crate::contact::{ContactForce, ContactPoint};
use crate::element::surface::Station;
use crate::element::{Node, Vector6};
use crate::geometry::Point;
use crate::numerics::block_tridiagonal::System;
use nalgebra::{Matrix3, SMatrix, Vector3};

/// A contact point: where it is \[mm\], and how thick the sheet is there \[mm\].
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Place {
    pub position: Point,
    pub thickness: f64,
}

impl Place {
    /// Of a station of the element between nodes `a` and `b`; its second node is thicker than its middle by `rise`.
    pub fn new(station: &Station, a: &Node, b: &Node, thickness: f64, rise: f64) -> Self {
        Self { position: station.position(a, b), thickness: thickness + station.xi * rise }
    }

    /// Gap between the sheet's face here and a tool at this distance from the mid-surface \[mm\].
    pub fn gap(&self, distance: f64) -> f64 {
        distance - 0.5 * self.thickness
    }
}

/// A contact point within reach of a tool.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// Its number.
    pub index: usize,
    /// As the tool sees it.
    pub point: ContactPoint,
    /// By how much its gap goes with the thickness \[–\].
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
pub(super) struct ContactTangent {
    /// F_r, F_z, Q \[N, or N/mm\].
    pub force: Vector3<f64>,
    /// Derivatives of these forces (rows) by r, z, t (columns).
    pub matrix: Matrix3<f64>,
}

impl ContactTangent {
    /// Tangent of a force whose gap changes with the thickness by `by_thickness`, h.
    pub fn new(touch: &ContactForce, by_thickness: f64) -> Self {
        let (n, tau, c, h) = (touch.facing, touch.along(), touch.curvature, by_thickness);
        let (on_tau, on_n) = (touch.drag_by_slip * touch.slip_turn + touch.normal * c, touch.tangential * c);
        let by_gap = [0, 1].map(|d| n[d] * touch.by_gap + tau[d] * touch.drag_by_gap);
        let by_move = [0, 1].map(|d| tau[d] * on_tau - n[d] * on_n);
        let [rr, rz, zr, zz] = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| by_gap[i] * n[j] + by_move[i] * tau[j]);
        let ([r, z], on_gap) = (touch.force(), h * touch.by_gap);
        Self {
            force: Vector3::new(r, z, h * touch.normal),
            matrix: Matrix3::new(
                rr,
                rz,
                h * by_gap[0],
                zr,
                zz,
                h * by_gap[1],
                on_gap * n[0],
                on_gap * n[1],
                h * on_gap,
            ),
        }
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
