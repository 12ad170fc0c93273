//! The section: stresses of thickness points integrated through the thickness into forces and the element's matrix.

use super::Vector6;
use super::kinematics::{Current, EPS_S, EPS_T, GAMMA, Generalised, KAPPA_S, KAPPA_T, Matrix6, Reference};
use crate::material::{PointLaw, flow::StressUpdate, flow::Tangent, flow::Triple};
use crate::numerics::quadrature::ThicknessPoint;
use nalgebra::SMatrix;

/// Integration of elements through the thickness.
#[derive(Clone, Copy, Debug)]
pub struct Section<'a, L> {
    /// Law of the thickness points.
    pub law: &'a L,
    /// Points through the thickness; a membrane has one, in the middle.
    pub rule: &'a [ThicknessPoint],
    /// Least tension of a membrane over its yield force \[–\], in the matrix only: a flat one has no transverse stiffness.
    pub slack_tension: f64,
    /// Largest move of a node in the last iteration \[mm\], which bounds that tension; infinite for a rigid-plastic sheet.
    pub last_move: f64,
    /// True if the matrix is left out.
    pub forces_alone: bool,
}

/// Stiffness C of a section, by its strains.
type Matrix5 = SMatrix<f64, 5, 5>;

fn resultants(zeta: f64, v: f64, stress: Triple) -> Generalised {
    let [s, t, shear] = stress.map(|stress| v * stress);
    [s, t, zeta * s, zeta * t, shear].into()
}

/// Adds the lower triangle of C of a point at ζ with the volume `v`, in the middle of 2 `half` of the thickness.
fn add_point(c: &mut Matrix5, zeta: f64, half: f64, v: f64, tangent: &Tangent) {
    let [ss, st, tt, sg, tg, gg] = tangent.own.map(|entry| v * entry);
    let (own, coupling) = ([ss, st, tt], tangent.coupling.map(|entry| v * half * entry));
    let square = zeta * zeta + half * half * tangent.across;
    let coupled = [0, 1, 2].map(|j| zeta * own[j] + coupling[j]);
    let bending = [0, 1, 2].map(|j| square * own[j] + 2.0 * zeta * coupling[j]);
    for ((i, j), [ss, st, tt]) in [((0, 0), own), ((2, 0), coupled), ((2, 2), bending)] {
        c[(i, j)] += ss;
        c[(i + 1, j)] += st;
        c[(i + 1, j + 1)] += tt;
    }
    c[(KAPPA_S, EPS_T)] += coupled[1];
    let [p, q] = tangent.outer.map(|g| [g[0], g[1], zeta * g[0] + half * g[2], zeta * g[1] + half * g[3], g[4]]);
    let q = q.map(|q| v * q);
    for j in 0..5 {
        c[(GAMMA, j)] += [sg, tg, zeta * sg, zeta * tg, gg][j];
        (j..5).for_each(|i| c[(i, j)] += p[i] * q[j] + q[i] * p[j]);
    }
}

impl<L: PointLaw> Section<'_, L> {
    /// Forces Bᵀ S \[N, N mm\] and matrix of an element of `volume` \[mm³, or mm²\] that was `thickness` \[mm\] thick.
    /// The points of the element are those of the start of the step; the iterates are advanced, the updates overwritten.
    pub fn internal(
        &self, current: &Current, volume: f64, thickness: f64, points: &[L::PointState], iterates: &mut [L::Iterate],
        updates: &mut [StressUpdate],
    ) -> (Vector6, Option<Matrix6>) {
        let e = &current.strain;
        let (mut s, mut c) = (Generalised::zeros(), Matrix5::zeros());
        let mut yield_stress = 0.0;
        for (i, at) in self.rule.iter().enumerate() {
            let (zeta, half, v) = (0.5 * thickness * at.xi, 0.5 * thickness * at.half, volume * at.weight);
            let strain = [e[EPS_S] + zeta * e[KAPPA_S], e[EPS_T] + zeta * e[KAPPA_T], e[GAMMA]];
            let spread = [half * e[KAPPA_S], half * e[KAPPA_T]];
            let (update, tangent) = self.law.respond(&points[i], &mut iterates[i], strain, spread);
            if !self.forces_alone {
                add_point(&mut c, zeta, half, v, &tangent);
            }
            s[KAPPA_S] += half * v * update.moment[0];
            s[KAPPA_T] += half * v * update.moment[1];
            s += resultants(zeta, v, update.stress);
            yield_stress = update.yield_stress;
            updates[i] = update;
        }
        let force = current.nodal_forces(&s);
        if self.forces_alone {
            return (force, None);
        }
        c.fill_upper_triangle_with_lower_triangle();
        let mut matrix = current.stiffness(&c) + current.geometric_stiffness(&s);
        let Reference { bending, length, .. } = current.reference;
        if !bending && self.slack_tension > 0.0 {
            let stretched = 0.5 * c[(EPS_S, EPS_S)] * (self.last_move / length).powi(2);
            let slack = stretched.min(self.slack_tension * volume * yield_stress) - s[EPS_S];
            matrix += current.transverse_stiffness(slack.max(0.0));
        }
        (force, Some(matrix))
    }
}
