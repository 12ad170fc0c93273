//! The section: layer points integrated through the thickness into forces and the element's matrix.

use super::kinematics::{EPS_S, EPS_T, End, GAMMA, Generalised, KAPPA_S, KAPPA_T};
use super::lobatto::Layer;
use super::{Matrix6, Theory, Vector6};
use crate::material::Hardening;
use crate::material::flow::{Iterate, Iteration, Response, Symmetric};

/// What is the same for every layer point of a step.
#[derive(Clone, Copy, Debug)]
pub struct Law<'a> {
    pub hardening: &'a Hardening,
    pub matrix: Iteration,
    pub theory: Theory,
    pub layers: &'a [Layer],
    /// Δε₀ of the step \[–\].
    pub cutoff: f64,
    /// Least tension of a membrane over its yield force \[–\], in the matrix only (the residual is untouched): a flat
    /// membrane has no transverse stiffness before its first stretch.
    pub slack_tension: f64,
}

/// An element's internal forces and matrix.
#[derive(Clone, Copy, Debug)]
pub struct Internal {
    /// Bᵀ S \[N, N mm\].
    pub force: Vector6,
    /// Bᵀ C B + geometric stiffness.
    pub matrix: Matrix6,
    /// ∂t/∂x of the current thickness \[–\].
    pub thickness_row: [f64; 6],
    /// Current thickness, by constant volume \[mm\].
    pub thickness: f64,
}

impl Law<'_> {
    /// Forces and matrix of an element of `volume` \[mm³\] whose thickness was `thickness` \[mm\] at the start of the step.
    ///
    /// `before` is ε̄ at the start of the step, `iterates` the layers' iterates (moved on), `responses` the layers'
    /// results (written).
    #[inline]
    pub fn internal(
        &self,
        end: &End,
        volume: f64,
        thickness: f64,
        before: &[f64],
        iterates: &mut [Iterate],
        responses: &mut [Response],
    ) -> Internal {
        let e = &end.strain;
        let mut s: Generalised = [0.0; 5];
        // C integrated with 1, ζ, ζ²: membrane, coupling, bending.
        let (mut c0, mut c1, mut c2): (Symmetric, Symmetric, Symmetric) = ([0.0; 6], [0.0; 6], [0.0; 6]);
        for (i, layer) in self.layers.iter().enumerate() {
            let zeta = 0.5 * thickness * layer.xi;
            let strain = [e[EPS_S] + zeta * e[KAPPA_S], e[EPS_T] + zeta * e[KAPPA_T], e[GAMMA]];
            let response = iterates[i].advance(self.hardening, self.matrix, before[i], self.cutoff, strain);
            let v = volume * layer.share;
            let (vs, vt) = (v * response.stress[0], v * response.stress[1]);
            s[EPS_S] += vs;
            s[EPS_T] += vt;
            s[KAPPA_S] += zeta * vs;
            s[KAPPA_T] += zeta * vt;
            s[GAMMA] += v * response.stress[2];
            for j in 0..6 {
                let c = v * response.tangent[j];
                c0[j] += c;
                c1[j] += zeta * c;
                c2[j] += zeta * zeta * c;
            }
            responses[i] = response;
        }
        let c: [[f64; 5]; 5] = [
            [c0[0], c0[1], c1[0], c1[1], c0[3]],
            [c0[1], c0[2], c1[1], c1[2], c0[4]],
            [c1[0], c1[1], c2[0], c2[1], c1[3]],
            [c1[1], c1[2], c2[1], c2[2], c1[4]],
            [c0[3], c0[4], c1[3], c1[4], c0[5]],
        ];

        let rows = end.rows();
        let mut force = Vector6::zeros();
        let mut matrix = Matrix6::zeros();
        let used = if self.theory == Theory::Membrane { 2 } else { 5 };
        for a in 0..used {
            let mut cb = [0.0; 6];
            for b in 0..used {
                for j in 0..6 {
                    cb[j] += c[a][b] * rows[b][j];
                }
            }
            for i in 0..6 {
                force[i] += rows[a][i] * s[a];
                for j in 0..6 {
                    matrix[(i, j)] += rows[a][i] * cb[j];
                }
            }
        }
        end.add_geometric(&s, &mut matrix);
        if self.theory == Theory::Membrane && self.slack_tension > 0.0 {
            let tension = self.slack_tension * volume * self.hardening.at(before[0]).stress;
            if s[EPS_S] < tension {
                let n = end.transverse();
                matrix += (tension - s[EPS_S]) * n * n.transpose();
            }
        }
        let thickness = thickness * (-e[EPS_S] - e[EPS_T]).exp();
        let thickness_row = std::array::from_fn(|j| -thickness * (rows[EPS_S][j] + rows[EPS_T][j]));
        Internal { force, matrix, thickness_row, thickness }
    }
}
