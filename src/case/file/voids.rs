//! `[material.voids]`: microscopic voids that grow, open and join.

use crate::units::{Fraction, Number, Positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// σ̄²/σ_y² + 2 q1 f* cosh(3 q2 p/2σ_y) = 1 + q3 f*² with the mean stress p: Gurson's yield condition.
///
/// Valid for small, spread-out voids under tension; without shear it says little about compression.
/// Source: in common use; A. L. Gurson (1977), V. Tvergaard, A. Needleman (1984), nucleation C. C. Chu, A. Needleman
/// (1980) (not read).
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Voids {
    /// Initial porosity f₀, below 0.3.
    #[schemars(example = 0.01)]
    pub initial: Fraction,
    /// 1.5 when not given (Tvergaard).
    #[schemars(example = 1.5)]
    pub q1: Option<Positive<Number>>,
    /// 1 when not given.
    #[schemars(example = 1.0)]
    pub q2: Option<Positive<Number>>,
    /// q1² when not given.
    #[schemars(example = 2.25)]
    pub q3: Option<Positive<Number>>,
    /// Voids that open at particles as the sheet strains; none when not given.
    pub nucleation: Option<Nucleation>,
    /// Voids that join; they keep apart when not given.
    pub coalescence: Option<Coalescence>,
}

/// Strain-controlled nucleation, spread normally.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Nucleation {
    /// Porosity f_N that all particles make.
    #[schemars(example = 0.04)]
    pub fraction: Fraction,
    /// Mean strain ε_N.
    #[schemars(example = 0.3)]
    pub strain: Positive<Number>,
    /// Standard deviation s_N.
    #[schemars(example = 0.1)]
    pub deviation: Positive<Number>,
}

/// Faster loss of strength from a critical porosity on.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coalescence {
    /// f_c.
    #[schemars(example = 0.15)]
    pub critical: Fraction,
    /// f_F, at which the sheet bears nothing any more: the run ends there.
    #[schemars(example = 0.25)]
    pub fracture: Fraction,
}
