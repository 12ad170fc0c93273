//! The section: thickness points integrated through the thickness into forces and the element's matrix.

mod column;

pub use column::{Alone, Answer, Column, Memory};

use super::Vector6;
use super::kinematics::{
    Current, EPS_S, EPS_T, GAMMA, Generalised, GeometricStiffness, KAPPA_S, KAPPA_T, StrainDisplacement,
};
use crate::material::flow::{Across, MEAN_SQUARE, Symmetric, Triple};
use crate::numerics::lobatto::ThicknessPoint;
use crate::numerics::number::{add, scaled};
use crate::numerics::{Real, elementary};

/// What is the same for every thickness point of a step.
#[derive(Clone, Copy, Debug)]
pub struct Law<'a> {
    /// Of an element that bends; a membrane has one point, in the middle.
    pub points: &'a [ThicknessPoint],
    /// Least tension of a membrane over its yield force \[–\], in the matrix only (the residual is untouched): a flat
    /// membrane has no transverse stiffness before its first stretch.
    pub slack_tension: f64,
    /// Whether the matrix is left out.
    pub forces_alone: bool,
}

/// An element as it is strained, or several side by side.
#[derive(Clone, Copy, Debug)]
pub struct Strained<T = f64> {
    /// Strain increments of the step \[–, 1/mm\].
    pub strain: Generalised<T>,
    /// Their derivatives.
    pub rows: StrainDisplacement<T>,
    /// Volume \[mm³, or mm² in plane strain\].
    pub volume: T,
    /// Thickness at the start of the step \[mm\].
    pub thickness: T,
}

impl<T: Real> Strained<T> {
    /// Of an element of `volume` \[mm³, or mm²\] that was `thickness` \[mm\] thick.
    #[inline(always)]
    pub fn new(current: &Current<T>, volume: T, thickness: T) -> Self {
        Self { strain: current.strain, rows: current.strain_displacement(), volume, thickness }
    }
}

/// An element's internal forces and matrix.
#[derive(Clone, Copy, Debug)]
pub struct Internal<T = f64> {
    /// Bᵀ S \[N, N mm\].
    pub force: [T; 6],
    /// Bᵀ C B + geometric stiffness.
    pub blocks: Option<Blocks<T>>,
    /// ∂t of the current thickness by r₁+r₂, r₂−r₁ and z₂−z₁ \[–\].
    pub thickness_row: [T; 3],
    /// Current thickness, by the volume that the step began with \[mm\].
    pub thickness: T,
}

/// The matrix of an element by its nodes, column after column.
#[derive(Clone, Copy, Debug)]
pub struct Blocks<T = f64> {
    /// Of each node with itself.
    pub own: [[T; 9]; 2],
    /// Of the first node with the second; of the second with the first it is the transpose.
    pub across: [T; 9],
}

/// The point of a membrane.
const MIDDLE: [ThicknessPoint; 1] = [ThicknessPoint { xi: 0.0, weight: 1.0, half: 0.0 }];

/// Bᵀ S: forces of the nodes that go with resultants. Differences count −1 at the first and +1 at the second, sums +1 at
/// both.
#[inline(always)]
fn nodal<T: Real>(g: &StrainDisplacement<T>, s: &Generalised<T>) -> [T; 6] {
    let (e0, e1) = (g.along, g.across);
    let (fr, fz) = (s[EPS_S] * e0[0] + s[GAMMA] * e1[0], s[EPS_S] * e0[1] + s[GAMMA] * e1[1]);
    let (f_sum, f_bend) = (g.hoop * s[EPS_T], g.bend * s[KAPPA_S]);
    let f_turn = g.turn * s[KAPPA_T] + g.shear * s[GAMMA];
    [f_sum - fr, -fz, f_turn - f_bend, f_sum + fr, fz, f_turn + f_bend]
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
    nodal(&current.strain_displacement(), &s).into()
}

/// The matrices of the points integrated through the thickness with 1, ζ, ζ².
struct Stiffness<T> {
    /// Membrane: ss, sθ, θθ.
    c0: Triple<T>,
    /// Coupling, strains by curvatures: ss, sθ, θs, θθ.
    c1: [T; 4],
    /// Bending: ss, sθ, θθ.
    c2: Triple<T>,
    /// Of γ with ε_s, ε_θ, κ_s, κ_θ and itself.
    shear: [T; 5],
}

impl<T: Real> Stiffness<T> {
    /// Of no points.
    #[inline(always)]
    fn none(zero: T) -> Self {
        Self { c0: [zero; 3], c1: [zero; 4], c2: [zero; 3], shear: [zero; 5] }
    }

    /// Adds a point at ζ that stands for the volume `v`.
    #[inline(always)]
    fn add(&mut self, zeta: T, v: T, tangent: &Symmetric<T>) {
        let Self { c0, c1, c2, shear } = self;
        let [ss, st, tt, sg, tg, gg] = scaled(v, *tangent);
        let [zss, zst, ztt] = [zeta * ss, zeta * st, zeta * tt];
        add(c0, [ss, st, tt]);
        add(c1, [zss, zst, zst, ztt]);
        add(c2, [zeta * zss, zeta * zst, zeta * ztt]);
        add(shear, [sg, tg, zeta * sg, zeta * tg, gg]);
    }

    /// Adds a point that stands in the middle of a part of the thickness of 2 `half`.
    #[inline(always)]
    fn add_part(&mut self, zeta: T, half: T, v: T, part: &Across<T>) {
        let Self { c0, c1, c2, shear } = self;
        let [ss, st, tt, own] = scaled(v, part.metric);
        let square = zeta * zeta + half * half * MEAN_SQUARE;
        // g and h by the strains and the curvatures.
        let [g, h] = part.outer;
        let h = scaled(v, h);
        let p = [g[0], g[1], zeta * g[0] + half * g[2], zeta * g[1] + half * g[3]];
        let q = [h[0], h[1], zeta * h[0] + half * h[2], zeta * h[1] + half * h[3]];
        add(c0, [ss + twice(p, q, 0), st + both(p, q, 0, 1), tt + twice(p, q, 1)]);
        let (zss, zst, ztt) = (zeta * ss, zeta * st, zeta * tt);
        let coupled = [both(p, q, 0, 2), both(p, q, 0, 3), both(p, q, 1, 2), both(p, q, 1, 3)];
        add(c1, [zss + coupled[0], zst + coupled[1], zst + coupled[2], ztt + coupled[3]]);
        add(c2, [square * ss + twice(p, q, 2), square * st + both(p, q, 2, 3), square * tt + twice(p, q, 3)]);
        for j in 0..4 {
            shear[j] = shear[j] + (g[4] * q[j] + h[4] * p[j]);
        }
        shear[4] = shear[4] + (own + g[4] * h[4] * 2.0);
        if let Some(coupling) = part.coupling {
            let [xx, xy, yy] = scaled(half * v, coupling);
            add(c1, [xx, xy, xy, yy]);
            add(c2, scaled(zeta * 2.0, [xx, xy, yy]));
        }
    }
}

/// Entry of p⊗q + q⊗p.
#[inline(always)]
fn both<T: Real>(p: [T; 4], q: [T; 4], i: usize, j: usize) -> T {
    p[i] * q[j] + q[i] * p[j]
}

/// The same on the diagonal.
#[inline(always)]
fn twice<T: Real>(p: [T; 4], q: [T; 4], i: usize) -> T {
    p[i] * q[i] * 2.0
}

impl Law<'_> {
    /// Forces and matrix of an element that bends or is a membrane, or of several of the same kind.
    #[inline(always)]
    pub fn internal<T: Real>(&self, element: &Strained<T>, bends: bool, column: &mut impl Column<T>) -> Internal<T> {
        let Strained { strain: e, rows: g, volume, thickness } = element;
        let zero = volume.constant(0.0);
        let (mut s, mut c) = ([zero; 5], Stiffness::none(zero));
        let mut yield_stress = zero;
        let points = if bends { self.points } else { &MIDDLE };
        for (i, at) in points.iter().enumerate() {
            let zeta = *thickness * (0.5 * at.xi);
            let strain = [e[EPS_S] + zeta * e[KAPPA_S], e[EPS_T] + zeta * e[KAPPA_T], e[GAMMA]];
            let v = *volume * at.weight;
            let half = *thickness * (0.5 * at.half);
            let spread = if at.half > 0.0 { Some([half * e[KAPPA_S], half * e[KAPPA_T]]) } else { None };
            let update = match column.respond(i, strain, spread) {
                Answer::Point(update) => {
                    if !self.forces_alone {
                        c.add(zeta, v, &update.tangent);
                    }
                    update
                }
                Answer::Part(across) => {
                    let share = half * v;
                    s[KAPPA_S] = s[KAPPA_S] + share * across.moment[0];
                    s[KAPPA_T] = s[KAPPA_T] + share * across.moment[1];
                    if !self.forces_alone {
                        c.add_part(zeta, half, v, &across);
                    }
                    across.update
                }
            };
            let (vs, vt) = (v * update.stress[0], v * update.stress[1]);
            add(&mut s, [vs, vt, zeta * vs, zeta * vt, v * update.stress[2]]);
            yield_stress = update.yield_stress;
        }
        // Forces and matrix of the element's five motions: differences d = (r, z), sum of r, difference and sum of θ.
        let force = nodal(g, &s);
        let thickness = *thickness * elementary::exp(-e[EPS_S] - e[EPS_T]);
        let shrinks = -thickness;
        let thickness_row = [shrinks * g.hoop, shrinks * g.along[0], shrinks * g.along[1]];
        if self.forces_alone {
            return Internal { force, blocks: None, thickness_row, thickness };
        }
        let mut k = g.geometric_stiffness(&s);
        if !bends && self.slack_tension > 0.0 {
            let missing = *volume * yield_stress * self.slack_tension - s[EPS_S];
            let missing = missing.where_or(missing.exceeds(zero), zero);
            let [x, y] = [-g.along[1], g.along[0]];
            add(&mut k.difference, [missing * x * x, missing * x * y, missing * y * y]);
        }
        Internal { force, blocks: Some(blocks(g, &c, &k)), thickness_row, thickness }
    }
}

/// Bᵀ C B and the geometric stiffness.
#[inline(always)]
fn blocks<T: Real>(g: &StrainDisplacement<T>, c: &Stiffness<T>, k: &GeometricStiffness<T>) -> Blocks<T> {
    let Stiffness { c0, c1, c2, shear } = c;
    let (e0, e1) = (g.along, g.across);
    let [rr, rz, zz] = k.difference;
    let from_s = [c0[0] * e0[0] + shear[0] * e1[0], c0[0] * e0[1] + shear[0] * e1[1]];
    let from_g = [shear[0] * e0[0] + shear[4] * e1[0], shear[0] * e0[1] + shear[4] * e1[1]];
    let rr = rr + e0[0] * from_s[0] + e1[0] * from_g[0];
    let rz = rz + e0[0] * from_s[1] + e1[0] * from_g[1];
    let zz = zz + e0[1] * from_s[1] + e1[1] * from_g[1];
    let hoop = along(g, g.hoop, c0[1], shear[1]);
    let bend = along(g, g.bend, c1[0], shear[2]);
    let turn_s = along(g, g.turn, c1[1], shear[3]);
    let turn = [turn_s[0] + g.shear * from_g[0], turn_s[1] + g.shear * from_g[1]];
    let hoop_hoop = g.hoop * g.hoop * c0[2] + k.hoop;
    let hoop_bend = g.hoop * g.bend * c1[2];
    let hoop_turn = g.hoop * (g.turn * c1[3] + g.shear * shear[1]);
    let bend_bend = g.bend * g.bend * c2[0];
    let bend_turn = g.bend * (g.turn * c2[1] + g.shear * shear[2]);
    let turn_turn = g.turn * (g.turn * c2[2] + g.shear * shear[3] * 2.0) + g.shear * g.shear * shear[4] + k.turn;

    // Back to the nodes: differences count −1 at the first and +1 at the second, sums +1 at both.
    let (r_turn, r_turn_odd) = (bend[0] + hoop_turn, turn[0] + hoop_bend);
    let (r_r, r_r_odd) = (rr + hoop_hoop, hoop[0] * 2.0);
    let (turns, turns_odd) = (bend_bend + turn_turn, bend_turn * 2.0);
    let first = {
        let (r_r, r_turn, turns) = (r_r - r_r_odd, r_turn - r_turn_odd, turns - turns_odd);
        let (r_z, z_turn) = (rz - hoop[1], bend[1] - turn[1]);
        [r_r, r_z, r_turn, r_z, zz, z_turn, r_turn, z_turn, turns]
    };
    let second = {
        let (r_r, r_turn, turns) = (r_r + r_r_odd, r_turn + r_turn_odd, turns + turns_odd);
        let (r_z, z_turn) = (rz + hoop[1], bend[1] + turn[1]);
        [r_r, r_z, r_turn, r_z, zz, z_turn, r_turn, z_turn, turns]
    };
    let (sums, mixed) = (hoop_turn - bend[0], turn[0] - hoop_bend);
    let across = [
        hoop_hoop - rr,
        -(hoop[1] + rz),
        sums + mixed,
        hoop[1] - rz,
        -zz,
        turn[1] - bend[1],
        sums - mixed,
        -(turn[1] + bend[1]),
        turn_turn - bend_bend,
    ];
    Blocks { own: [first, second], across }
}

/// By the differences of r and z, what goes with ε_s and γ, times `by`.
#[inline(always)]
fn along<T: Real>(g: &StrainDisplacement<T>, by: T, p: T, q: T) -> [T; 2] {
    let (e0, e1) = (g.along, g.across);
    [by * (p * e0[0] + q * e1[0]), by * (p * e0[1] + q * e1[1])]
}
