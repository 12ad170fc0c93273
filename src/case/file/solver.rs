//! `[solver]`, `[stop]` and `[output]`: all optional.

use crate::units::{Fraction, Length, Number, Positive, Ratio, Stress};
use schemars::JsonSchema;
use serde::Deserialize;

/// Numerical parameters; one default serves every case, so most files have no `[solver]`.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Solver {
    /// Matrix of the corrector; "primal_dual" when not given.
    #[schemars(example = &"primal_dual")]
    pub iteration: Option<Iteration>,
    /// What must be small for a step to be accepted; "velocity" when not given.
    #[schemars(example = &"velocity")]
    pub norm: Option<Norm>,
    /// Accepted value of the norm; 1e-5 when not given.
    #[schemars(example = 1e-5)]
    pub tolerance: Option<Positive<Number>>,
    /// Most iterations of one step; 40 when not given.
    #[schemars(range(min = 1, max = 10_000), example = 40)]
    pub max_iterations: Option<i64>,
    /// Largest step as a fraction of the travel; 0.01 when not given.
    #[schemars(example = 0.01)]
    pub max_step: Option<Fraction>,
    /// First step as a fraction of the travel; 0.002 when not given.
    #[schemars(example = 0.002)]
    pub first_step: Option<Fraction>,
    /// Smallest step as a fraction of the travel; 1e-6 when not given.
    #[schemars(example = 1e-6)]
    pub min_step: Option<Fraction>,
    /// Equivalent strain that a hundredth of the travel adds below which the sheet counts as rigid; 5e-6 when not given.
    #[schemars(example = 5e-6)]
    pub cutoff_strain: Option<Positive<Number>>,
    /// Contact stiffness times the sheet thickness; "30 GPa" when not given.
    #[schemars(example = "30 GPa")]
    pub contact_stiffness: Option<Positive<Stress>>,
    /// Gap over which contact sets in, over the sheet thickness; 0.003 when not given.
    #[schemars(example = 0.003)]
    pub contact_smoothing: Option<Positive<Number>>,
    /// Sliding speed at which friction is nearly full, over the punch speed; 0.01 when not given.
    #[schemars(example = 0.01)]
    pub slip_speed: Option<Positive<Number>>,
    /// Chords per 90° that replace the tools' arcs, 1 to 1000; exact arcs when not given.
    #[schemars(range(min = 1, max = 1000), example = 20)]
    pub facets: Option<i64>,
    /// Rounds chords off by arcs with common tangents, so that the load does not tick at their vertices; true by default.
    pub round_facets: Option<bool>,
    /// What keeps tools out of the sheet; "penalty" when not given.
    #[schemars(example = &"penalty")]
    pub contact: Option<ContactMethod>,
    /// Equivalent strain that one step may add anywhere; 0.1 when not given.
    #[schemars(example = 0.1)]
    pub strain_step: Option<Positive<Number>>,
    /// Thickness over bending radius from which an element bends where `blank.theory` is "selective"; 0.05 when not given.
    #[schemars(example = 0.05)]
    pub bend_ratio: Option<Positive<Number>>,
}

/// What keeps tools out of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactMethod {
    /// Stiff springs: tools penetrate by thousandths of the thickness.
    Penalty,
    /// The springs shifted until nothing penetrates by more than a ten-thousandth of the thickness.
    AugmentedLagrangian,
}

/// When a run ends before its full travel.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stop {
    /// Ends where one place of the sheet takes all the stretching; true when not given.
    #[schemars(example = true)]
    pub localised: Option<bool>,
    /// Ends when the punch force has fallen by this much from its maximum; never when not given.
    #[schemars(example = "20 %")]
    pub load_drop: Option<Positive<Ratio>>,
    /// Ends when this share of the sheet's area, inside the gas's seal where there is gas, lies on the punch or the die: the
    /// part is formed. Never when not given.
    #[schemars(example = "95 %")]
    pub contact_share: Option<Positive<Ratio>>,
}

/// Matrix of the corrector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Iteration {
    /// Newton's matrix with an independently carried stress.
    PrimalDual,
    /// Newton's consistent tangent.
    Newton,
    /// Secant (Picard): slow, hardly ever fails.
    Secant,
}

/// Norm of acceptance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Norm {
    /// Relative increment of the velocities.
    Velocity,
    /// Residual force over the largest internal force.
    Residual,
    /// Both of them.
    Both,
}

/// Which instants are kept: `frames` or `count`; the end of the travel always is.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Punch travels at which the state is kept.
    pub frames: Option<Vec<Positive<Length>>>,
    /// Number of equally spaced instants, 1 to 1000; 4 when neither is given.
    #[schemars(range(min = 1, max = 1000), example = 4)]
    pub count: Option<i64>,
}
