//! The section: thickness points integrated through the thickness into forces and the element's matrix.

use super::Vector6;
use super::kinematics::{Current, EPS_S, EPS_T, GAMMA, Generalised, KAPPA_S, KAPPA_T, StrainDisplacement};
use crate::material::PointLaw;
use crate::material::flow::{Across, MEAN_SQUARE, StressUpdate, Symmetric, Triple};
use crate::numerics::lobatto::ThicknessPoint;
use nalgebra::Matrix3;

/// What is the same for every thickness point of a step.
#[derive(Clone, Copy, Debug)]
pub struct Law<'a, L> {
    /// The law of a thickness point.
    pub point: L,
    /// Of an element that bends; a membrane has one point, in the middle.
    pub points: &'a [ThicknessPoint],
    /// Least tension of a membrane over its yield force \[–\], in the matrix only (the residual is untouched): a flat
    /// membrane has no transverse stiffness before its first stretch.
    pub slack_tension: f64,
    /// Whether the matrix is left out.
    pub forces_alone: bool,
}

/// An element's internal forces and matrix.
#[derive(Clone, Copy, Debug)]
pub struct Internal {
    /// Bᵀ S \[N, N mm\].
    pub force: Vector6,
    /// Bᵀ C B + geometric stiffness: the block of each node with itself.
    pub own: [Matrix3<f64>; 2],
    /// Its block of the first node with the second; of the second with the first it is the transpose.
    pub across: Matrix3<f64>,
    /// ∂t of the current thickness by r₁+r₂, r₂−r₁ and z₂−z₁ \[–\].
    pub thickness_row: [f64; 3],
    /// Current thickness, by the volume that the step began with \[mm\].
    pub thickness: f64,
}

/// Entries of a [`Symmetric`] by strain and curvature: ss, sθ, θs, θθ, γs, γθ.
const STRAINS_BY_CURVATURES: [usize; 6] = [0, 1, 1, 2, 3, 4];

/// The point of a membrane.
const MIDDLE: [ThicknessPoint; 1] = [ThicknessPoint { xi: 0.0, weight: 1.0, half: 0.0 }];

/// Bᵀ S: forces of the nodes that go with resultants. Differences count −1 at the first and +1 at the second, sums +1 at
/// both.
#[inline]
fn nodal(g: &StrainDisplacement, s: &Generalised) -> Vector6 {
    let (e0, e1) = (g.along, g.across);
    let [fr, fz] = [0, 1].map(|d| s[EPS_S] * e0[d] + s[GAMMA] * e1[d]);
    let (f_sum, f_bend) = (g.hoop * s[EPS_T], g.bend * s[KAPPA_S]);
    let f_turn = g.turn * s[KAPPA_T] + g.shear * s[GAMMA];
    Vector6::new(f_sum - fr, -fz, f_turn - f_bend, f_sum + fr, fz, f_turn + f_bend)
}

/// Forces of an element's nodes that go with given stresses of its points \[N, N mm\].
pub fn forces(
    current: &Current,
    volume: f64,
    thickness: f64,
    points: &[ThicknessPoint],
    stress: impl Fn(usize) -> Triple,
) -> Vector6 {
    let mut s: Generalised = [0.0; 5];
    let points = if current.bends() { points } else { &MIDDLE };
    for (i, at) in points.iter().enumerate() {
        let (zeta, v, stress) = (0.5 * thickness * at.xi, volume * at.weight, stress(i));
        s[EPS_S] += v * stress[0];
        s[EPS_T] += v * stress[1];
        s[KAPPA_S] += zeta * v * stress[0];
        s[KAPPA_T] += zeta * v * stress[1];
        s[GAMMA] += v * stress[2];
    }
    nodal(&current.strain_displacement(), &s)
}

/// The matrices of the points integrated through the thickness with 1, ζ, ζ².
#[derive(Default)]
struct Stiffness {
    /// Membrane.
    c0: Symmetric,
    /// Coupling, strains by curvatures: ss, sθ, θs, θθ, γs, γθ.
    c1: [f64; 6],
    /// Bending: ss, sθ, θθ.
    c2: Triple,
}

impl Stiffness {
    /// Adds a point at ζ that stands for the volume `v`.
    #[inline]
    fn add(&mut self, zeta: f64, v: f64, tangent: &Symmetric) {
        let c = tangent.map(|c| v * c);
        for j in 0..6 {
            self.c0[j] += c[j];
            self.c1[j] += zeta * c[STRAINS_BY_CURVATURES[j]];
        }
        for j in 0..3 {
            self.c2[j] += zeta * zeta * c[j];
        }
    }

    /// Adds a point that stands in the middle of a part of the thickness of 2 `half`.
    #[inline]
    fn add_part(&mut self, zeta: f64, half: f64, v: f64, part: &Across) {
        let Self { c0, c1, c2 } = self;
        let [ss, st, tt, shear] = part.metric.map(|k| v * k);
        let [xx, xy, yy] = part.coupling.map(|k| half * v * k);
        let square = zeta * zeta + MEAN_SQUARE * half * half;
        for (j, (k, x)) in [(ss, xx), (st, xy), (tt, yy)].into_iter().enumerate() {
            c0[j] += k;
            c2[j] += square * k + 2.0 * zeta * x;
        }
        c0[5] += shear;
        for (j, (k, x)) in [(ss, xx), (st, xy), (st, xy), (tt, yy)].into_iter().enumerate() {
            c1[j] += zeta * k + x;
        }
        // g and h by the strains, and by the curvatures.
        let [g, h] = part.outer;
        let h = h.map(|h| v * h);
        let [gk, hk] = [g, h].map(|g| [zeta * g[0] + half * g[3], zeta * g[1] + half * g[4]]);
        for (j, (a, b)) in [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)].into_iter().enumerate() {
            c0[j] += g[a] * h[b] + h[a] * g[b];
        }
        for (j, (a, b)) in [(0, 0), (0, 1), (1, 0), (1, 1), (2, 0), (2, 1)].into_iter().enumerate() {
            c1[j] += g[a] * hk[b] + h[a] * gk[b];
        }
        for (j, (a, b)) in [(0, 0), (0, 1), (1, 1)].into_iter().enumerate() {
            c2[j] += gk[a] * hk[b] + hk[a] * gk[b];
        }
    }
}

impl<L: PointLaw> Law<'_, L> {
    /// Forces and matrix of an element of `volume` \[mm³\] whose thickness was `thickness` \[mm\] at the start of the step.
    ///
    /// `before` are the points as the step finds them, `iterates` what they remember (moved on), `updates` their results
    /// (written); of a membrane's the first.
    #[inline]
    pub fn internal(
        &self,
        current: &Current,
        volume: f64,
        thickness: f64,
        before: &[L::PointState],
        iterates: &mut [L::Iterate],
        updates: &mut [StressUpdate],
    ) -> Internal {
        let e = &current.strain;
        let (mut s, mut c): (Generalised, _) = ([0.0; 5], Stiffness::default());
        let points = if current.bends() { self.points } else { &MIDDLE };
        for (i, at) in points.iter().enumerate() {
            let zeta = 0.5 * thickness * at.xi;
            let strain = [e[EPS_S] + zeta * e[KAPPA_S], e[EPS_T] + zeta * e[KAPPA_T], e[GAMMA]];
            let v = volume * at.weight;
            let half = 0.5 * thickness * at.half;
            let spread = [half * e[KAPPA_S], half * e[KAPPA_T]];
            let part = at.half > 0.0;
            let across = part.then(|| self.point.respond_across(&before[i], &mut iterates[i], strain, spread));
            let update = match across.flatten() {
                None => {
                    let update = self.point.respond(&before[i], &mut iterates[i], strain);
                    if !self.forces_alone {
                        c.add(zeta, v, &update.tangent);
                    }
                    update
                }
                Some(across) => {
                    s[KAPPA_S] += half * v * across.moment[0];
                    s[KAPPA_T] += half * v * across.moment[1];
                    if !self.forces_alone {
                        c.add_part(zeta, half, v, &across);
                    }
                    across.update
                }
            };
            let (vs, vt) = (v * update.stress[0], v * update.stress[1]);
            s[EPS_S] += vs;
            s[EPS_T] += vt;
            s[KAPPA_S] += zeta * vs;
            s[KAPPA_T] += zeta * vt;
            s[GAMMA] += v * update.stress[2];
            updates[i] = update;
        }
        let Stiffness { c0, c1, c2 } = c;
        // Forces and matrix of the element's five motions: differences d = (r, z), sum of r, difference and sum of θ.
        let g = current.strain_displacement();
        let force = nodal(&g, &s);
        let thickness = thickness * (-e[EPS_S] - e[EPS_T]).exp();
        let thickness_row = [g.hoop, g.along[0], g.along[1]].map(|by| -thickness * by);
        if self.forces_alone {
            let empty = Matrix3::zeros();
            return Internal { force, own: [empty; 2], across: empty, thickness_row, thickness };
        }
        let mut k = current.geometric_stiffness(&s);
        if !current.bends() && self.slack_tension > 0.0 {
            let tension = self.slack_tension * volume * updates[0].yield_stress;
            if s[EPS_S] < tension {
                let [x, y] = current.transverse();
                let missing = tension - s[EPS_S];
                k.difference[0] += missing * x * x;
                k.difference[1] += missing * x * y;
                k.difference[2] += missing * y * y;
            }
        }
        let (e0, e1) = (g.along, g.across);
        let both = |p: f64, q: f64| [p * e0[0] + q * e1[0], p * e0[1] + q * e1[1]];
        let [rr, rz, zz] = k.difference;

        let (from_s, from_g) = (both(c0[0], c0[3]), both(c0[3], c0[5]));
        let rr = rr + e0[0] * from_s[0] + e1[0] * from_g[0];
        let rz = rz + e0[0] * from_s[1] + e1[0] * from_g[1];
        let zz = zz + e0[1] * from_s[1] + e1[1] * from_g[1];
        let hoop = both(c0[1], c0[4]).map(|v| g.hoop * v);
        let bend = both(c1[0], c1[4]).map(|v| g.bend * v);
        let turn_s = both(c1[1], c1[5]);
        let turn = [g.turn * turn_s[0] + g.shear * from_g[0], g.turn * turn_s[1] + g.shear * from_g[1]];
        let hoop_hoop = g.hoop * g.hoop * c0[2] + k.hoop;
        let hoop_bend = g.hoop * g.bend * c1[2];
        let hoop_turn = g.hoop * (g.turn * c1[3] + g.shear * c0[4]);
        let bend_bend = g.bend * g.bend * c2[0];
        let bend_turn = g.bend * (g.turn * c2[1] + g.shear * c1[4]);
        let turn_turn = g.turn * (g.turn * c2[2] + 2.0 * g.shear * c1[5]) + g.shear * g.shear * c0[5] + k.turn;

        // Back to the nodes: differences count −1 at the first and +1 at the second, sums +1 at both.
        let own = [-1.0, 1.0].map(|i| {
            let r_turn = bend[0] + hoop_turn + i * (turn[0] + hoop_bend);
            let (r_z, z_turn) = (rz + i * hoop[1], bend[1] + i * turn[1]);
            let r_r = rr + hoop_hoop + 2.0 * i * hoop[0];
            let turn_turn = bend_bend + turn_turn + 2.0 * i * bend_turn;
            Matrix3::new(r_r, r_z, r_turn, r_z, zz, z_turn, r_turn, z_turn, turn_turn)
        });
        let (sums, mixed) = (hoop_turn - bend[0], turn[0] - hoop_bend);
        let across = Matrix3::new(
            hoop_hoop - rr,
            hoop[1] - rz,
            sums - mixed,
            -hoop[1] - rz,
            -zz,
            -turn[1] - bend[1],
            sums + mixed,
            turn[1] - bend[1],
            turn_turn - bend_bend,
        );
        Internal { force, own, across, thickness_row, thickness }
    }
}
