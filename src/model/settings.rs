//! Numerical parameters, and when a run ends early.

use super::Iteration;

/// Numerical parameters. One default serves every case.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    pub iteration: Iteration,
    pub norm: Norm,
    /// Accepted value of the norm \[–\].
    pub tolerance: f64,
    /// Most iterations of one step (the secant matrix gets ten times as many).
    pub max_iterations: usize,
    /// Largest step as a fraction of the travel \[–\].
    pub max_step: f64,
    /// First step as a fraction of the travel \[–\].
    pub first_step: f64,
    /// Smallest step as a fraction of the travel \[–\]; below it the run stops.
    pub min_step: f64,
    /// Cut-off Δε₀ of the equivalent strain of a step of [`Settings::CUTOFF_STEP`] of the travel \[–\]; others cut off in
    /// proportion, so that it stays a strain rate and small against what any step strains.
    pub cutoff_strain: f64,
    /// Contact stiffness k times the sheet thickness \[MPa\].
    pub contact_stiffness: f64,
    /// Length δ over which contact sets in, over the sheet thickness \[–\].
    pub contact_smoothing: f64,
    /// Sliding speed at which friction has reached 71 % of μN, over the punch speed \[–\].
    pub slip_speed: f64,
    /// Chords per 90° that replace the tools' arcs; `None` keeps them exact.
    pub facets: Option<usize>,
    /// Rounds chords off by arcs with common tangents, so that the load does not tick at their vertices.
    pub round_facets: bool,
    pub contact: ContactMethod,
    /// Equivalent strain that one step may add anywhere \[–\]: the next step is chosen by it, and one that goes beyond
    /// twice as much is repeated shorter.
    pub strain_step: f64,
    /// Thickness over bending radius from which an element of a selective sheet bends \[–\].
    pub bend_ratio: f64,
}

impl Settings {
    /// The step that the cut-off is meant for, as a fraction of the travel \[–\]: the default of `max_step`.
    pub const CUTOFF_STEP: f64 = 0.01;

    /// Penetration over thickness that the augmented Lagrangian comes down to \[–\].
    pub const PENETRATION: f64 = 1e-4;
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            iteration: Iteration::PrimalDual,
            norm: Norm::Velocity,
            tolerance: 1e-5,
            max_iterations: 40,
            max_step: 0.01,
            first_step: 0.002,
            min_step: 1e-6,
            cutoff_strain: 5e-6,
            contact_stiffness: 3e4,
            contact_smoothing: 3e-3,
            slip_speed: 0.01,
            facets: None,
            round_facets: true,
            contact: ContactMethod::Penalty,
            strain_step: 0.1,
            bend_ratio: 0.05,
        }
    }
}

/// What must be small for a step to be accepted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Norm {
    /// Relative increment of the velocities.
    Velocity,
    /// Residual force over the largest nodal internal force.
    Residual,
    Both,
}

/// What makes contact hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactMethod {
    /// A penalty: tools penetrate by what their pressure asks for.
    Penalty,
    /// The penalty shifted until nothing penetrates by more than [`Settings::PENETRATION`] thicknesses.
    AugmentedLagrangian,
}

/// When a run ends before its full travel; what can be checked at each accepted step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StopRules {
    /// Ends where one place of the sheet takes over and its surroundings stop stretching.
    pub localised: bool,
    /// Ends when the load has fallen by this share of its maximum \[–\].
    pub load_drop: Option<f64>,
    /// Ends when this share of the sheet's area lies on the punch or the die \[–\].
    pub contact_share: Option<f64>,
}

impl Default for StopRules {
    fn default() -> Self {
        Self { localised: true, load_drop: None, contact_share: None }
    }
}
