//! What a case means: every quantity in mm, N, s, MPa; validated and immutable.

use crate::geometry::Profile;
use crate::material::Material;

pub use crate::element::{Geometry, Theory};
pub use crate::material::flow::Iteration;

/// How the blank's outer edge is held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Edge {
    Free,
    /// All velocities of the edge are zero.
    Clamped,
    /// The edge moves outward in its plane at `speed` times the punch speed \[–\] and keeps its slope: for tension tests.
    Pulled {
        speed: f64,
    },
}

/// How element sizes are spread over the blank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grading {
    /// Equal elements.
    Uniform,
    /// Smaller elements where the sheet meets the tools' corners.
    Radii,
}

/// The sheet before forming.
#[derive(Clone, Debug, PartialEq)]
pub struct Blank {
    /// Radius, or half-length in plane strain \[mm\].
    pub length: f64,
    /// Initial thickness \[mm\].
    pub thickness: f64,
    /// Number of elements from the axis to the edge.
    pub elements: usize,
    pub grading: Grading,
    pub theory: Theory,
    /// Gauss-Lobatto points through the thickness (1 when the theory is membrane).
    pub layers: usize,
    pub edge: Edge,
}

/// What a tool is called in tables and plots.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    Punch,
    Die,
    Holder,
}

/// What moves a tool. All tools move along z only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Motion {
    Fixed,
    /// Moves with the punch travel.
    Travel,
    /// Pressed towards the die with this force \[N, or N/mm in plane strain\]; its position is an unknown.
    Force(f64),
}

/// A rigid tool, drawn where it touches the flat blank (whose mid-surface is z = 0).
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    pub role: Role,
    pub profile: Profile,
    /// Coulomb's coefficient of friction \[–\].
    pub friction: f64,
    pub motion: Motion,
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
    /// Cut-off Δε₀ of the equivalent strain of one step of `max_step` \[–\]; shorter steps cut off in proportion.
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
            contact_stiffness: 1e4,
            contact_smoothing: 2e-3,
            slip_speed: 0.01,
            facets: None,
            round_facets: true,
        }
    }
}

/// A validated forming problem in solver units.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    pub title: String,
    /// Declared assumptions, shown wherever results are shown.
    pub notes: Vec<String>,
    pub geometry: Geometry,
    pub blank: Blank,
    pub material: Material,
    /// At most one tool of each role.
    pub tools: Vec<Tool>,
    /// Punch travel of the whole run \[mm\].
    pub travel: f64,
    /// Punch speed \[mm/s\]; rate-free materials do not feel it.
    pub speed: f64,
    /// Travels at which the state is kept \[mm\], rising, the last one equal to `travel`.
    pub frames: Vec<f64>,
    pub settings: Settings,
}

impl Model {
    /// The tool of a role, where there is one.
    pub fn tool(&self, role: Role) -> Option<&Tool> {
        self.tools.iter().find(|t| t.role == role)
    }
}

impl Role {
    pub const ALL: [Role; 3] = [Role::Punch, Role::Die, Role::Holder];

    /// The word used in tables, plots and case files.
    pub fn name(self) -> &'static str {
        match self {
            Role::Punch => "punch",
            Role::Die => "die",
            Role::Holder => "holder",
        }
    }
}
