//! Line search: an iteration that went too far along its direction is partly taken back.
//!
//! ```text
//! s(λ) = −δa · r(a + λ δa)      falls from s(0) > 0 to 0 where the work of the residual along δa ends
//! s(λ) < −κ s(0)                too far: back to λ s(0) / (s(0) − s(λ))
//! ```
//!
//! Elastic unloading and yielding change the tangent by a factor of hundreds, and Newton's method then cycles.
//!
//! # References
//! M. A. Crisfield, Non-linear finite element analysis of solids and structures, vol. 1 (1991), section 9.2 (not read).

use super::*;
use crate::numerics::block_tridiagonal::MAX_SHARED;
use nalgebra::SVector;

/// κ \[–\]: on a hemispherical cup 15 to 30 tries fail without a search, none with 0.3 to 0.8, up to two with 1.5.
const OVERSHOOT: f64 = 0.5;
/// Least and largest share of λ that is kept \[–\].
const KEPT: [f64; 2] = [0.1, 0.7];
const MOST: usize = 3;

#[derive(Clone, Debug)]
pub(super) struct LineSearch {
    /// −r before the iteration.
    residual: Vec<Vector3<f64>>,
    shared_residual: SVector<f64, MAX_SHARED>,
    /// δa of the nodes \[mm, rad\], and of the shared unknowns.
    pub direction: Vec<Vector3<f64>>,
    pub shared: SVector<f64, MAX_SHARED>,
    /// λ \[–\].
    pub length: f64,
    /// s(0).
    start: f64,
    rounds: usize,
}

impl LineSearch {
    pub fn new(nodes: usize) -> Self {
        let [residual, direction] = [(); 2].map(|()| vec![Vector3::zeros(); nodes]);
        let (shared_residual, shared, length, start) = Default::default();
        Self { residual, shared_residual, direction, shared, length, start, rounds: MOST }
    }

    pub fn aim(&mut self, system: &mut System) -> bool {
        self.residual.copy_from_slice(&system.rhs);
        self.shared_residual = system.corner_rhs;
        if !system.solve() {
            return false;
        }
        self.direction.copy_from_slice(&system.rhs);
        self.shared = system.corner_rhs;
        self.start = self.project(&self.residual, &self.shared_residual);
        self.rounds = 0;
        true
    }

    /// Share of the direction to take back; `None` if it was not too far.
    pub fn back(&mut self, system: &System) -> Option<f64> {
        let now = self.project(&system.rhs, &system.corner_rhs);
        if self.rounds == MOST || now >= -OVERSHOOT * self.start.abs() {
            return None;
        }
        self.rounds += 1;
        let back = (1.0 - (self.start / (self.start - now)).clamp(KEPT[0], KEPT[1])) * self.length;
        self.length -= back;
        Some(back)
    }

    fn project(&self, residual: &[Vector3<f64>], shared: &SVector<f64, MAX_SHARED>) -> f64 {
        self.direction.iter().zip(residual).map(|(d, r)| d.dot(r)).sum::<f64>() + self.shared.dot(shared)
    }
}
