//! A contact point, and what tools do to it and through it to its element.

use crate::contact::{ContactForce, ContactPoint};
use crate::element::Node;
use crate::element::surface::{Slope, Station, of_node};
use crate::geometry::Point;
use crate::numerics::block_tridiagonal::System;
use nalgebra::Vector3;

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

/// What tools do to a contact point: the forces F on its position x and Q on its element's thickness t, and their
/// derivatives.
///
/// ```text
/// dg = n·dx + h dt,  h = −½ of the area of the mid-surface over that of the face
/// F = N n + T τ,  ∂F/∂x = ∂F/∂g⊗n + ((∂T/∂s + N c) τ − T c n)⊗τ,  ∂F/∂t = h ∂F/∂g
/// Q = h N,        ∂Q/∂x = h ∂N/∂g n,                              ∂Q/∂t = h² ∂N/∂g
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Push {
    /// F \[N, or N/mm\].
    pub force: [f64; 2],
    /// Q \[N, or N/mm\].
    pub squeeze: f64,
    /// ∂F/∂r and ∂F/∂z.
    pub force_by_place: [[f64; 2]; 2],
    pub force_by_thickness: [f64; 2],
    pub squeeze_by_place: [f64; 2],
    pub squeeze_by_thickness: f64,
}

impl Push {
    /// Of both.
    #[inline(always)]
    pub fn add(&mut self, other: &Self) {
        self.squeeze += other.squeeze;
        self.squeeze_by_thickness += other.squeeze_by_thickness;
        for d in 0..2 {
            self.force[d] += other.force[d];
            self.force_by_place[0][d] += other.force_by_place[0][d];
            self.force_by_place[1][d] += other.force_by_place[1][d];
            self.force_by_thickness[d] += other.force_by_thickness[d];
            self.squeeze_by_place[d] += other.squeeze_by_place[d];
        }
    }

    /// Whether a tool does anything here.
    #[inline(always)]
    pub fn acts(&self) -> bool {
        self.squeeze != 0.0 || self.squeeze_by_thickness != 0.0
    }

    /// Adds the columns and rows of the tool's displacement along z, the `shared`-th of the shared unknowns: the forces feel
    /// it like a move of the point, but for the sign.
    #[inline(always)]
    pub fn follow(&self, e: usize, slope: &Slope, thinning: &[f64; 3], shared: usize, system: &mut System) {
        let [by_r, by_z] = self.force_by_place;
        let column = motions(slope, by_z, thinning, self.squeeze_by_place[1]);
        let row = motions(slope, [by_r[1], by_z[1]], thinning, self.force_by_thickness[1]);
        for (i, node) in [(e, FIRST), (e + 1, SECOND)] {
            system.columns[i][shared] += Vector3::from(of_node(node, &column));
            system.rows[i][shared] += Vector3::from(of_node(node, &row));
        }
        system.corner[(shared, shared)] -= by_z[1];
    }

    /// Of a force whose gap goes with the thickness by `by_thickness`, h.
    #[inline(always)]
    pub fn new(touch: &ContactForce, by_thickness: f64) -> Self {
        let (n, tau, c, h) = (touch.facing, touch.along(), touch.curvature, by_thickness);
        let (on_tau, on_n) = (touch.drag_by_slip * touch.slip_turn + touch.normal * c, touch.tangential * c);
        let by_gap =
            [n[0] * touch.by_gap + tau[0] * touch.drag_by_gap, n[1] * touch.by_gap + tau[1] * touch.drag_by_gap];
        let by_move = [tau[0] * on_tau - n[0] * on_n, tau[1] * on_tau - n[1] * on_n];
        let squeezing = h * touch.by_gap;
        Self {
            force: touch.force(),
            squeeze: h * touch.normal,
            force_by_place: [
                [by_gap[0] * n[0] + by_move[0] * tau[0], by_gap[1] * n[0] + by_move[1] * tau[0]],
                [by_gap[0] * n[1] + by_move[0] * tau[1], by_gap[1] * n[1] + by_move[1] * tau[1]],
            ],
            force_by_thickness: by_gap.map(|f| h * f),
            squeeze_by_place: n.map(|n| squeezing * n),
            squeeze_by_thickness: h * squeezing,
        }
    }

    /// Adds the forces on the motions of the point's element.
    #[inline(always)]
    pub fn load(&self, slope: &Slope, thinning: &[f64; 3], forces: &mut [f64; 5]) {
        for (force, own) in forces.iter_mut().zip(motions(slope, self.force, thinning, self.squeeze)) {
            *force += own;
        }
    }

    /// Adds the derivatives of these forces: rows by forces, columns by motions.
    #[inline(always)]
    pub fn stiffen(&self, station: &Station, slope: &Slope, thinning: &[f64; 3], matrix: &mut [[f64; 5]; 5]) {
        let [by_r, by_z] = self.force_by_place;
        let force_r = motions(slope, [by_r[0], by_z[0]], thinning, self.force_by_thickness[0]);
        let force_z = motions(slope, [by_r[1], by_z[1]], thinning, self.force_by_thickness[1]);
        let squeeze = motions(slope, self.squeeze_by_place, thinning, self.squeeze_by_thickness);
        // What F and Q do to each motion, as in `motions`.
        let ([along_r, along_z], bend) = (slope.by_difference, slope.by_bend);
        for j in 0..5 {
            let (r, z, q) = (force_r[j], force_z[j], squeeze[j]);
            matrix[0][j] += 0.5 * r + thinning[0] * q;
            matrix[1][j] += 0.5 * z;
            matrix[2][j] += along_r[0] * r + along_r[1] * z + thinning[1] * q;
            matrix[3][j] += along_z[0] * r + along_z[1] * z + thinning[2] * q;
            matrix[4][j] += bend[0] * r + bend[1] * z;
        }
        let second = station.second(self.force);
        for d in 0..2 {
            matrix[4][2 + d] += second[d];
            matrix[2 + d][4] += second[d];
        }
    }
}

/// How an element's differences count at its nodes.
pub(super) const FIRST: f64 = -1.0;
pub(super) const SECOND: f64 = 1.0;

/// v·∂x + w ∂t of a point by its element's motions; the thickness has the derivatives `thinning`, by r₁+r₂, r₂−r₁, z₂−z₁.
#[inline(always)]
fn motions(slope: &Slope, v: [f64; 2], thinning: &[f64; 3], w: f64) -> [f64; 5] {
    let [r, z, along_r, along_z, bend] = slope.of(v);
    [r + w * thinning[0], z, along_r + w * thinning[1], along_z + w * thinning[2], bend]
}
