//! A contact point, and what tools do to it and through it to its element.

use crate::contact::{ContactForce, ContactPoint};
use crate::element::Node;
use crate::element::surface::{Slope, Station, of_node};
use crate::geometry::Point;
use crate::numerics::Real;
use crate::numerics::block_tridiagonal::System;
use crate::numerics::number::{Instructions, LANES, Lanes, add, scaled, values};
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
pub(super) struct Push<T = f64> {
    /// F \[N, or N/mm\].
    pub force: [T; 2],
    /// Q \[N, or N/mm\].
    pub squeeze: T,
    /// ∂F/∂r and ∂F/∂z.
    pub force_by_place: [[T; 2]; 2],
    pub force_by_thickness: [T; 2],
    pub squeeze_by_place: [T; 2],
    pub squeeze_by_thickness: T,
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
}

impl<T: Real> Push<T> {
    /// Of a force whose gap goes with the thickness by `by_thickness`, h.
    #[inline(always)]
    pub fn new(touch: &ContactForce<T>, by_thickness: T) -> Self {
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
            force_by_thickness: scaled(h, by_gap),
            squeeze_by_place: scaled(squeezing, n),
            squeeze_by_thickness: h * squeezing,
        }
    }

    /// Adds the forces on the motions of the point's element.
    #[inline(always)]
    pub fn load(&self, slope: &Slope<T>, thinning: &[T; 3], forces: &mut [T; 5]) {
        add(forces, motions(slope, self.force, thinning, self.squeeze));
    }

    /// Adds the derivatives of these forces: rows by forces, columns by motions.
    #[inline(always)]
    pub fn stiffen(&self, station: &Station, slope: &Slope<T>, thinning: &[T; 3], matrix: &mut [[T; 5]; 5]) {
        let [by_r, by_z] = self.force_by_place;
        let force_r = motions(slope, [by_r[0], by_z[0]], thinning, self.force_by_thickness[0]);
        let force_z = motions(slope, [by_r[1], by_z[1]], thinning, self.force_by_thickness[1]);
        let squeeze = motions(slope, self.squeeze_by_place, thinning, self.squeeze_by_thickness);
        // What F and Q do to each motion, as in `motions`.
        let ([along_r, along_z], bend) = (slope.by_difference, slope.by_bend);
        for j in 0..5 {
            let (r, z, q) = (force_r[j], force_z[j], squeeze[j]);
            matrix[0][j] = matrix[0][j] + (r * 0.5 + thinning[0] * q);
            matrix[1][j] = matrix[1][j] + z * 0.5;
            matrix[2][j] = matrix[2][j] + (along_r[0] * r + along_r[1] * z + thinning[1] * q);
            matrix[3][j] = matrix[3][j] + (along_z[0] * r + along_z[1] * z + thinning[2] * q);
            matrix[4][j] = matrix[4][j] + (bend[0] * r + bend[1] * z);
        }
        let second = station.second(self.force);
        for d in 0..2 {
            matrix[4][2 + d] = matrix[4][2 + d] + second[d];
            matrix[2 + d][4] = matrix[2 + d][4] + second[d];
        }
    }
}

/// Entries of several points.
pub(super) struct Pushes([[f64; LANES]; 12]);

impl Pushes {
    #[inline(always)]
    pub fn new<S: Instructions>(of: &Push<Lanes<S>>) -> Self {
        let ([f, g], [by_r, by_z], [u, v]) = (of.force, of.force_by_place, of.force_by_thickness);
        let (q, [p, s], w) = (of.squeeze, of.squeeze_by_place, of.squeeze_by_thickness);
        Self(values([f, g, by_r[0], by_r[1], by_z[0], by_z[1], u, v, q, p, s, w]))
    }

    /// Of the `k`-th point.
    #[inline(always)]
    pub fn at(&self, k: usize) -> Push {
        let v = &self.0;
        Push {
            force: [v[0][k], v[1][k]],
            force_by_place: [[v[2][k], v[3][k]], [v[4][k], v[5][k]]],
            force_by_thickness: [v[6][k], v[7][k]],
            squeeze: v[8][k],
            squeeze_by_place: [v[9][k], v[10][k]],
            squeeze_by_thickness: v[11][k],
        }
    }
}

/// How an element's differences count at its nodes.
pub(super) const FIRST: f64 = -1.0;
pub(super) const SECOND: f64 = 1.0;

/// v·∂x + w ∂t of a point by its element's motions; the thickness has the derivatives `thinning`, by r₁+r₂, r₂−r₁, z₂−z₁.
#[inline(always)]
fn motions<T: Real>(slope: &Slope<T>, v: [T; 2], thinning: &[T; 3], w: T) -> [T; 5] {
    let [r, z, along_r, along_z, bend] = slope.of(v);
    [r + w * thinning[0], z, along_r + w * thinning[1], along_z + w * thinning[2], bend]
}
