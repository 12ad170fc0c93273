//! Ductile fracture: damage that a point sums up along its path. One criterion, one file: [`law`](crate::material::law).
//!
//! ```text
//! D = (1/C) ∫ f(σ₁, σ_m, σ̄) dε̄,   f ≥ 0,   fracture at D = 1
//! ```
//!
//! with the critical value C and the equivalent stress σ̄. Damage does not heal: a negative criterion counts as zero.

mod brozzo;
mod cockcroft_latham;
mod oyane;
mod rice_tracey;

use crate::material::{YieldCriterion, flow::Triple, law::prelude::*};

family! {
    /// Criterion of ductile fracture: exactly one.
    #[derive(Copy)]
    pub enum Fracture: FractureCriterion, named in FractureTable as "Fracture";
    /// dD/dε̄ at a stress other than zero \[–\].
    fn at(stress: FractureStress) -> f64;
    cockcroft_latham: CockcroftLatham,
    brozzo: Brozzo,
    oyane: Oyane,
    rice_tracey: RiceTracey,
}

/// Invariants of the Cauchy stress at a thickness point \[MPa\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FractureStress {
    /// Largest principal stress σ₁, without the transverse shear.
    pub largest: f64,
    /// Mean stress σ_m.
    pub mean: f64,
    /// Equivalent stress σ̄ > 0.
    pub equivalent: f64,
}

impl FractureStress {
    /// Invariants of the in-plane stress `s` less the normal stress, and of a normal stress \[MPa\], negative for pressure.
    pub fn new(criterion: &YieldCriterion, s: Triple, normal: f64) -> Self {
        let (largest, mean) = (s[0].max(s[1]).max(0.0) + normal, (s[0] + s[1]) / 3.0 + normal);
        Self { largest, mean, equivalent: criterion.equivalent_stress(s) }
    }
}
