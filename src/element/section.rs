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

/// The matrices of the points integrated through the thickness with 1, ζ, ζ²: in fours, which are added in one go.
#[derive(Default)]
struct Stiffness {
    /// By ε_s, ε_θ, κ_s, κ_θ; the rows of the curvatures without the columns of the strains.
    plane: [[f64; 4]; 4],
    /// Of γ with these.
    shear: [f64; 4],
    /// Of γ with itself.
    own_shear: f64,
}

impl Stiffness {
    /// Adds a point at ζ that stands for the volume `v`.
    #[inline(always)]
    fn add(&mut self, zeta: f64, v: f64, tangent: &Symmetric) {
        let [ss, st, tt, sg, tg, gg] = tangent.map(|c| v * c);
        let strains = [[ss, st, zeta * ss, zeta * st], [st, tt, zeta * st, zeta * tt]];
        let shear = [sg, tg, zeta * sg, zeta * tg];
        for j in 0..4 {
            for i in 0..2 {
                self.plane[i][j] += strains[i][j];
                self.plane[i + 2][j] += zeta * strains[i][j];
            }
            self.shear[j] += shear[j];
        }
        self.own_shear += gg;
    }

    /// Adds a point that stands in the middle of a part of the thickness of 2 `half`.
    #[inline(always)]
    fn add_part(&mut self, zeta: f64, half: f64, v: f64, part: &Across) {
        let [ss, st, tt, shear] = part.metric.map(|k| v * k);
        let square = zeta * zeta + MEAN_SQUARE * half * half;
        let mut own = [
            [ss, st, zeta * ss, zeta * st],
            [st, tt, zeta * st, zeta * tt],
            [0.0, 0.0, square * ss, square * st],
            [0.0, 0.0, square * st, square * tt],
        ];
        if let Some(coupling) = part.coupling {
            let [xx, xy, yy] = coupling.map(|k| half * v * k);
            for (i, row) in [[xx, xy], [xy, yy]].into_iter().enumerate() {
                for j in 0..2 {
                    own[i][j + 2] += row[j];
                    own[i + 2][j + 2] += 2.0 * zeta * row[j];
                }
            }
        }
        // g and h by the strains and the curvatures.
        let both = |g: &[f64; 5]| [g[0], g[1], zeta * g[0] + half * g[2], zeta * g[1] + half * g[3]];
        let [g, h] = part.outer;
        let h = h.map(|h| v * h);
        let (p, q) = (both(&g), both(&h));
        for i in 0..4 {
            for j in 0..4 {
                self.plane[i][j] += own[i][j] + (p[i] * q[j] + q[i] * p[j]);
            }
        }
        for j in 0..4 {
            self.shear[j] += g[4] * q[j] + h[4] * p[j];
        }
        self.own_shear += shear + 2.0 * g[4] * h[4];
    }
}

impl<L: PointLaw> Law<'_, L> {
    /// Forces and matrix of an element of `volume` \[mm³\] whose thickness was `thickness` \[mm\] at the start of the step.
    ///
    /// `before` are the points as the step finds them, `iterates` what they remember (moved on), `updates` their results
    /// (written); of a membrane's the first.
    #[inline(always)]
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
            // No closure: it would be compiled by itself.
            let across =
                if part { self.point.respond_across(&before[i], &mut iterates[i], strain, spread) } else { None };
            let update = match across {
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

        let Stiffness { plane: [by_s, by_t, by_bend, by_turn], shear, own_shear } = c;
        let (from_s, from_g) = (both(by_s[EPS_S], shear[EPS_S]), both(shear[EPS_S], own_shear));
        let rr = rr + e0[0] * from_s[0] + e1[0] * from_g[0];
        let rz = rz + e0[0] * from_s[1] + e1[0] * from_g[1];
        let zz = zz + e0[1] * from_s[1] + e1[1] * from_g[1];
        let hoop = both(by_s[EPS_T], shear[EPS_T]).map(|v| g.hoop * v);
        let bend = both(by_s[KAPPA_S], shear[KAPPA_S]).map(|v| g.bend * v);
        let turn_s = both(by_s[KAPPA_T], shear[KAPPA_T]);
        let turn = [g.turn * turn_s[0] + g.shear * from_g[0], g.turn * turn_s[1] + g.shear * from_g[1]];
        let hoop_hoop = g.hoop * g.hoop * by_t[EPS_T] + k.hoop;
        let hoop_bend = g.hoop * g.bend * by_t[KAPPA_S];
        let hoop_turn = g.hoop * (g.turn * by_t[KAPPA_T] + g.shear * shear[EPS_T]);
        let bend_bend = g.bend * g.bend * by_bend[KAPPA_S];
        let bend_turn = g.bend * (g.turn * by_bend[KAPPA_T] + g.shear * shear[KAPPA_S]);
        let turn_turn = g.turn * (g.turn * by_turn[KAPPA_T] + 2.0 * g.shear * shear[KAPPA_T])
            + g.shear * g.shear * own_shear
            + k.turn;

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
