//! Numerical parameters, and when a run ends early.

use super::Iteration;
use crate::units::{As, Fraction, Number, Positive, Ratio, Stress};

/// Numerical parameters; one default serves every case, so most files have no `[solver]`.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(rename = "Solver")]
pub struct Settings {
    /// Matrix of the corrector; "primal_dual" when not given.
    #[schemars(extend("default" = "primal_dual"))]
    pub iteration: Iteration,
    /// First guess of a step: the last velocities, by default; if false, fifteen secant iterations from rest.
    pub predictor: bool,
    /// Norm that must be small for a step to be accepted; "velocity" when not given.
    #[schemars(extend("default" = "velocity"))]
    pub norm: Norm,
    /// Accepted value of the norm; 1e-5 when not given.
    #[serde(with = "As::<Positive<Number>>")]
    pub tolerance: f64,
    /// Most iterations of one step (the secant matrix gets ten times as many); 40 when not given.
    #[schemars(range(min = 1, max = 10_000))]
    pub max_iterations: usize,
    /// Largest step as a fraction of the travel; 0.01 when not given.
    #[serde(with = "As::<Fraction>")]
    pub max_step: f64,
    /// First step as a fraction of the travel; 0.002 when not given.
    #[serde(with = "As::<Fraction>")]
    pub first_step: f64,
    /// Smallest step as a fraction of the travel, below which the run stops; 1e-6 when not given.
    #[serde(with = "As::<Fraction>")]
    pub min_step: f64,
    /// Equivalent strain that a hundredth of the travel adds below which the sheet counts as rigid; 5e-6 when not given. Other
    /// steps cut off in proportion, so that it stays a strain rate and small against what any step strains.
    #[serde(with = "As::<Positive<Number>>")]
    pub cutoff_strain: f64,
    /// Contact stiffness times the sheet thickness, in MPa; "30 GPa" when not given.
    #[serde(with = "As::<Positive<Stress>>")]
    #[schemars(extend("default" = "30 GPa"))]
    pub contact_stiffness: f64,
    /// Gap over which contact sets in, over the sheet thickness; 0.001 when not given.
    #[serde(with = "As::<Positive<Number>>")]
    pub contact_smoothing: f64,
    /// Sliding speed at which friction has reached 71 % of its full value, over the punch speed, or over that of one sheet
    /// thickness in the whole run or stage where the punch goes less far; 0.003 when not given.
    #[serde(with = "As::<Positive<Number>>")]
    pub slip_speed: f64,
    /// Method that keeps tools out of the sheet; "penalty" when not given.
    #[schemars(extend("default" = "penalty"))]
    pub contact: ContactMethod,
    /// Equivalent strain that one step may add anywhere; 0.1 when not given. Beyond twice as much it is repeated shorter.
    #[serde(with = "As::<Positive<Number>>")]
    pub strain_step: f64,
}

impl Settings {
    /// The step that the cut-off is meant for, as a fraction of the travel \[–\]: the default of `max_step`.
    pub const CUTOFF_STEP: f64 = 0.01;

    /// Penetration over thickness that the augmented Lagrangian comes down to \[–\].
    pub const PENETRATION: f64 = 1e-4;

    /// Matrix and norm of the corrector, in words.
    pub fn corrector(&self) -> [&'static str; 2] {
        let matrix = ["primal-dual Newton", "Newton", "secant"][self.iteration as usize];
        [matrix, ["velocity", "residual", "velocity and residual"][self.norm as usize]]
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            iteration: Iteration::PrimalDual,
            predictor: true,
            norm: Norm::Velocity,
            tolerance: 1e-5,
            max_iterations: 40,
            max_step: 0.01,
            first_step: 0.002,
            min_step: 1e-6,
            cutoff_strain: 5e-6,
            contact_stiffness: 3e4,
            contact_smoothing: 1e-3,
            slip_speed: 0.003,
            contact: ContactMethod::Penalty,
            strain_step: 0.1,
        }
    }
}

/// Norm of acceptance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Norm {
    /// Relative increment of the velocities.
    Velocity,
    /// Residual force over the largest internal force.
    Residual,
    /// Both of them.
    Both,
}

/// Method that keeps tools out of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ContactMethod {
    /// Stiff springs: tools penetrate by thousandths of the thickness.
    Penalty,
    /// The springs shifted until nothing penetrates by more than a ten-thousandth of the thickness.
    AugmentedLagrangian,
}

/// When a run ends before its full travel: at the instant, found to a thousandth of a step, that a rule is first met.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(default, deny_unknown_fields)]
#[schemars(rename = "Stop")]
pub struct StopRules {
    /// Ends where one place of the sheet takes all the stretching; true when not given.
    pub localised: bool,
    /// Ends when the punch force has fallen by this much from its maximum; never when not given.
    #[serde(with = "As::<Positive<Ratio>>")]
    pub load_drop: Option<f64>,
    /// Ends when this share of the sheet's area, inside a gas's seal, lies on punch or die. Never when not given.
    #[serde(with = "As::<Positive<Ratio>>")]
    pub contact_share: Option<f64>,
    /// Ends, as wished, when the cup is through the die: its rim stands in the throat, a thickness behind the shoulder; in every
    /// stage whose travel is long enough. False when not given: then a run ends early as soon as the rim comes to the throat.
    pub drawn_through: bool,
    /// Ends where the hole's edge comes to blank.edge_limit and cracks; false when not given.
    pub edge_limit: bool,
    /// Ends, as wished, when the holder presses with this force \[N, or N/mm of depth\]: it has closed. Not of a case file.
    #[serde(skip)]
    #[schemars(skip)]
    pub holder_force: Option<f64>,
}

impl Default for StopRules {
    fn default() -> Self {
        let (load_drop, contact_share, holder_force) = Default::default();
        Self { localised: true, load_drop, contact_share, drawn_through: false, edge_limit: false, holder_force }
    }
}
