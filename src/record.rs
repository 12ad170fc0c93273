//! What a run leaves behind: the history of every step, the kept frames, and why it stopped.

/// One element at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ElementRecord {
    /// Initial distance of the element's middle from the axis \[mm\].
    pub s0: f64,
    /// Position of the element's middle \[mm\].
    pub r: f64,
    pub z: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Logarithmic mid-surface strains \[–\].
    pub strain_meridional: f64,
    pub strain_hoop: f64,
    /// ln(t/t₀) \[–\].
    pub strain_thickness: f64,
    /// Equivalent plastic strain, mean over the thickness \[–\].
    pub strain_equivalent: f64,
    /// Largest equivalent plastic strain over the thickness \[–\].
    pub strain_equivalent_max: f64,
    /// Cauchy stresses, mean over the thickness \[MPa\].
    pub stress_meridional: f64,
    pub stress_hoop: f64,
}

/// One node at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeRecord {
    /// Position of the mid-surface \[mm\].
    pub r: f64,
    pub z: f64,
    /// Rotation of the fibre, counter-clockwise in the r-z plane \[rad\].
    pub theta: f64,
    /// Thickness that contact sees \[mm\].
    pub thickness: f64,
}

/// What is kept of an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Punch travel \[mm\].
    pub travel: f64,
    /// From the axis outward.
    pub elements: Vec<ElementRecord>,
    pub nodes: Vec<NodeRecord>,
    /// Axial displacement of each tool from where it is drawn in the model \[mm\], in the model's order.
    pub tool_displacement: Vec<f64>,
}

/// Mean powers of a step, or the work done since the start \[mW or mJ, per ring or per mm of depth\].
///
/// external = plastic + friction + contact, where `contact` is what the penalty springs store.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Of the driven tools and edges on the sheet.
    pub external: f64,
    pub plastic: f64,
    pub friction: f64,
    pub contact: f64,
    /// The part of `plastic` in points whose strain rate is below ten times the cut-off.
    pub cutoff: f64,
}

impl Energy {
    /// Every entry times `factor`: power from work, work from power.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            external: self.external * factor,
            plastic: self.plastic * factor,
            friction: self.friction * factor,
            contact: self.contact * factor,
            cutoff: self.cutoff * factor,
        }
    }

    /// The sum, entry by entry.
    pub fn plus(self, other: Self) -> Self {
        Self {
            external: self.external + other.external,
            plastic: self.plastic + other.plastic,
            friction: self.friction + other.friction,
            contact: self.contact + other.contact,
            cutoff: self.cutoff + other.cutoff,
        }
    }

    /// What the balance misses, over the external work \[–\].
    pub fn imbalance(&self) -> f64 {
        let missing = self.external - self.plastic - self.friction - self.contact;
        if self.external == 0.0 { 0.0 } else { missing / self.external.abs() }
    }
}

/// One accepted step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepRecord {
    pub step: usize,
    /// Time at the end of the step \[s\].
    pub time: f64,
    /// Punch travel at the end of the step \[mm\].
    pub travel: f64,
    /// Force of the punch on the sheet along its travel \[N, or N/mm in plane strain\].
    pub punch_force: f64,
    /// Force of the holder on the sheet towards the die \[N, or N/mm\].
    pub holder_force: f64,
    /// Radial force that the held edge exerts outward \[N, or N/mm\]; 0 for a free edge.
    pub edge_force: f64,
    /// How far the blank's edge has moved inward \[mm\].
    pub draw_in: f64,
    /// Thinnest element: its thickness \[mm\] and initial distance from the axis \[mm\].
    pub thinnest: f64,
    pub thinnest_s0: f64,
    /// Largest penetration of a tool over the sheet's thickness \[–\].
    pub penetration: f64,
    pub iterations: usize,
    /// Tries that were rejected before this step was accepted.
    pub rejected: usize,
    /// Relative velocity increment and relative residual at acceptance \[–\].
    pub velocity_norm: f64,
    pub residual_norm: f64,
    /// Mean powers of the step, and work since the start.
    pub power: Energy,
    pub work: Energy,
}

/// Why a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    FullTravel,
    /// No equilibrium was found down to the smallest step.
    NoEquilibrium {
        travel: f64,
        step: f64,
        velocity_norm: f64,
        residual_norm: f64,
        /// Initial distance from the axis of the node with the largest residual \[mm\].
        worst_s0: f64,
    },
}

impl Stop {
    /// Whether the run came to the end it was asked for.
    pub fn is_complete(&self) -> bool {
        matches!(self, Stop::FullTravel)
    }
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Stop::FullTravel => write!(f, "full travel reached"),
            Stop::NoEquilibrium { travel, step, velocity_norm, residual_norm, worst_s0 } => write!(
                f,
                "no equilibrium found at {travel:.3} mm of travel with steps down to {step:.2e} mm \
                 (velocity norm {velocity_norm:.1e}, residual norm {residual_norm:.1e}, worst at s0 = {worst_s0:.2} mm); \
                 try more elements at the smallest radius, or a smaller first_step"
            ),
        }
    }
}

/// A whole run.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    pub history: Vec<StepRecord>,
    pub frames: Vec<Frame>,
    pub stop: Stop,
    /// Tries of the step that the run stopped at.
    pub abandoned: usize,
    /// Things a user should know before trusting the result.
    pub warnings: Vec<String>,
}

/// One iteration of the corrector, accepted step or not.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct IterationRecord {
    pub step: usize,
    /// Punch travel at the end of the step that is tried \[mm\].
    pub travel: f64,
    pub iteration: usize,
    /// Relative velocity increment \[–\].
    pub velocity_norm: f64,
    /// Relative residual before the increment \[–\].
    pub residual_norm: f64,
    /// Share of the computed increment that was taken \[–\]; below 1 when a move was capped.
    pub cut: f64,
    /// Node-tool pairs under contact pressure.
    pub active_contacts: usize,
}
