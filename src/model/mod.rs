//! What a case means: every quantity in mm, N, s, MPa; validated and immutable.

pub mod mesh;
pub mod stage;

pub use stage::{Beginning, Stage};

use crate::forming_limit::Curve;
use crate::geometry::Profile;
use crate::material::Material;
use crate::material::flow::Triple;
use crate::numerics::PiecewiseLinear;

pub use crate::contact::friction::Friction;
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

/// What moves a tool.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    Fixed,
    /// Moves along z with the travel.
    Travel,
    /// Goes this far along z and away from the axis over the run \[mm\], in proportion to its travel, or to its time where
    /// there is no travel.
    Path {
        axial: f64,
        aside: f64,
    },
    /// Stands still at this distance between its face and the die's \[mm\]: a holder on distance blocks.
    Gap(f64),
    /// Pressed towards the die; its position is an unknown.
    Pressed(Press),
}

/// How a holder is pressed: F = F₀(travel) − c w, with w its move towards the die.
#[derive(Clone, Debug, PartialEq)]
pub struct Press {
    /// F₀ over the punch travel \[N, or N/mm in plane strain, over mm\].
    pub force: PiecewiseLinear,
    /// Stiffness c of the springs or the cushion \[N/mm, or N/mm²\]; 0 for a force that does not feel the position.
    pub stiffness: f64,
}

impl Press {
    /// A force that stays.
    pub fn constant(force: f64) -> Self {
        Self { force: force.into(), stiffness: 0.0 }
    }

    /// Whether nothing ever presses.
    pub fn is_idle(&self) -> bool {
        self.force.largest() <= 0.0 && self.stiffness == 0.0
    }
}

/// A rigid tool, drawn where it touches the flat blank (whose mid-surface is z = 0).
#[derive(Clone, Debug, PartialEq)]
pub struct Tool {
    pub role: Role,
    pub profile: Profile,
    pub friction: Friction,
    pub motion: Motion,
}

/// A draw bead as a line restraint on the flange.
///
/// It pulls the sheet back with a force per length of its line while the sheet passes it, and the force that closes it
/// is taken from the holder's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bead {
    /// Distance of its line from the axis or the symmetry plane \[mm\].
    pub at: f64,
    /// Restraining force per length of the line \[N/mm\].
    pub restraining: f64,
    /// Closing force per length of the line \[N/mm\].
    pub closing: f64,
}

impl Bead {
    /// Length of the line \[mm\], or 1 per mm of depth.
    pub fn line(&self, geometry: Geometry) -> f64 {
        match geometry {
            Geometry::Axisymmetric => std::f64::consts::TAU * self.at,
            Geometry::PlaneStrain => 1.0,
        }
    }
}

/// Which face of the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Face {
    /// The punch's side: pressure pushes along the punch travel.
    Lower,
    /// The die's side: pressure pushes against the punch travel.
    Upper,
}

impl Face {
    /// Which way pressure on it pushes: +1 along the punch travel, −1 against it.
    pub fn sign(self) -> f64 {
        match self {
            Face::Lower => 1.0,
            Face::Upper => -1.0,
        }
    }
}

/// What decides a gas pressure.
#[derive(Clone, Debug, PartialEq)]
pub enum Pressure {
    /// Given over time \[MPa over s\].
    OverTime(PiecewiseLinear),
    /// As much as holds a strain rate; an unknown of its own.
    Rate(RateControl),
}

/// Superplastic forming: the pressure that makes the sheet's strain rate, by the norm ‖ε̄̇‖ = (Σ V ε̄̇^q/Σ V)^(1/q), the
/// target in every step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateControl {
    /// Target of the norm \[1/s\].
    pub target: f64,
    /// q: 1 is the mean over the sheet's volume, a large one the fastest place \[–\].
    pub exponent: f64,
    /// Largest pressure \[MPa\] and fastest rise of it \[MPa/s\] that the press gives; infinite where nothing is said.
    pub max_pressure: f64,
    pub max_rise: f64,
}

impl RateControl {
    /// A target and a norm, and a press that gives any pressure.
    pub fn new(target: f64, exponent: f64) -> Self {
        Self { target, exponent, max_pressure: f64::INFINITY, max_rise: f64::INFINITY }
    }

    /// What the pressure may come to at the end of a step of `dt` \[s\] that it begins with `before` \[MPa\], and which cap
    /// says so; `None` where there is no cap.
    pub fn cap(&self, before: f64, dt: f64) -> Option<(f64, PressureCap)> {
        let risen = before + self.max_rise * dt;
        let (cap, which) = if self.max_pressure <= risen {
            (self.max_pressure, PressureCap::Largest)
        } else {
            (risen, PressureCap::Rise)
        };
        cap.is_finite().then_some((cap, which))
    }
}

/// What the press cannot go beyond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PressureCap {
    /// Its largest pressure.
    Largest,
    /// Its fastest rise of the pressure.
    Rise,
}

impl Pressure {
    /// The pressure at a time where it is given \[MPa\].
    pub fn given(&self, time: f64) -> Option<f64> {
        match self {
            Self::OverTime(history) => Some(history.at(time)),
            Self::Rate(_) => None,
        }
    }
}

impl From<PiecewiseLinear> for Pressure {
    fn from(history: PiecewiseLinear) -> Self {
        Self::OverTime(history)
    }
}

impl From<f64> for Pressure {
    fn from(pressure: f64) -> Self {
        Self::OverTime(pressure.into())
    }
}

/// Gas or oil pressure on a face of the sheet; it stays normal to the sheet and acts on its current area.
#[derive(Clone, Debug, PartialEq)]
pub struct Gas {
    pub face: Face,
    pub pressure: Pressure,
    /// It acts on what lies closer to the axis or symmetry plane than this seal \[mm\].
    pub within: f64,
}

/// The sheet's temperature and what changes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// Initial temperature over the distance from the axis or symmetry plane \[K over mm\].
    pub initial: PiecewiseLinear,
    /// `None` where the temperature stays what it is.
    pub flow: Option<HeatFlow>,
}

/// What changes the temperature, which is the same through the thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatFlow {
    /// ρ c: density times specific heat \[MPa/K\].
    pub capacity: f64,
    /// β: share of the plastic work that becomes heat \[–\].
    pub plastic_share: f64,
    /// Conductivity along the sheet \[N/(s K), which is W/(m K)\]; 0 without.
    pub conductivity: f64,
    /// Tools that heat or cool what they touch.
    pub tools: Vec<ToolHeat>,
}

/// Heat transfer between a tool and the sheet where they touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolHeat {
    pub role: Role,
    /// The tool's temperature, which stays \[K\].
    pub temperature: f64,
    /// Heat-transfer coefficient h \[N/(mm s K)\].
    pub transfer: f64,
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

/// How the metal answers to strain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// The flow approach: rigid-viscoplastic.
    #[default]
    Flow,
    /// Large-strain elasto-(visco)plastic on the same elements.
    ElastoViscoplastic,
    /// D(E, ν) on the stress that the sheet carries, without yield: the flow approach's spring-back.
    Elastic,
}

/// Which stiffness the unloading iterates with (Sosnowski 1994, equations 10 to 13).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Stiffness {
    /// Formed anew in every iteration, with the geometric stiffness.
    #[default]
    Updated,
    /// The one at the start of each increment.
    Constant,
}

/// Tools are taken away: the forces of contact become equal external loads that fade to zero over the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Release {
    pub stiffness: Stiffness,
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
    pub beads: Vec<Bead>,
    /// At most one on each face.
    pub gas: Vec<Gas>,
    /// `None` for a sheet at room temperature throughout.
    pub heat: Option<Heat>,
    /// Punch travel of the whole run \[mm\], in a later stage the longest path of a tool; 0 where none is driven.
    pub travel: f64,
    /// Punch travel over time \[mm over s\], rising from 0 at 0 to the whole travel; `None` at a constant speed.
    pub schedule: Option<PiecewiseLinear>,
    /// Punch speed, the mean one where it changes; without a punch, the speed that counts as that of the process \[mm/s\].
    pub speed: f64,
    /// Time that the run takes \[s\].
    pub duration: f64,
    /// Times at which the state is kept \[s\], rising, the last one equal to `duration`.
    pub frames: Vec<f64>,
    pub stop: StopRules,
    pub settings: Settings,
    pub mode: Mode,
    /// `None` while the tools act.
    pub release: Option<Release>,
    /// The forming limit that the strains are held against; with one, their paths are kept.
    pub forming_limit: Option<Curve>,
}

impl Model {
    /// The tool of a role, where there is one.
    pub fn tool(&self, role: Role) -> Option<&Tool> {
        self.tools.iter().find(|t| t.role == role)
    }

    /// Elastic energy per volume that a stress stores \[MPa\]; the flow law stores none.
    pub fn stored(&self, stress: Triple) -> f64 {
        match (self.mode, self.material.elastic) {
            (Mode::Flow, _) | (_, None) => 0.0,
            (_, Some(elastic)) => elastic.energy(stress),
        }
    }

    /// Whether tools go ways of their own, as they do in later stages: then they may leave the sheet.
    pub fn has_paths(&self) -> bool {
        self.tools.iter().any(|tool| matches!(tool.motion, Motion::Path { .. }))
    }

    /// The strain rate that a gas pressure holds, where one does.
    pub fn rate_control(&self) -> Option<&RateControl> {
        self.held_gas().map(|(_, control)| control)
    }

    /// The gas whose pressure holds a strain rate, and how.
    pub fn held_gas(&self) -> Option<(&Gas, &RateControl)> {
        self.gas.iter().find_map(|gas| match &gas.pressure {
            Pressure::Rate(control) => Some((gas, control)),
            Pressure::OverTime(_) => None,
        })
    }

    /// Sets another punch travel \[mm\] at the same speed, or along the same history, whose last speed goes on where it is
    /// too short; the state is kept at its end only.
    pub fn drive_to(&mut self, travel: f64) {
        self.travel = travel;
        if let Some(schedule) = &mut self.schedule {
            *schedule = schedule.up_to(travel);
            self.duration = schedule.reaches(travel);
            self.speed = travel / self.duration;
        } else {
            self.duration = travel / self.speed;
        }
        self.frames = vec![self.duration];
    }

    /// Punch travel \[mm\] at a time of the run \[s\].
    pub fn travel_at(&self, time: f64) -> f64 {
        match &self.schedule {
            Some(schedule) => schedule.at(time),
            None => self.travel * (time / self.duration),
        }
    }

    /// Share of the run that is done at a time \[–\]: of its travel, or of its time where there is no travel.
    pub fn progress(&self, time: f64) -> f64 {
        if self.travel > 0.0 { self.travel_at(time) / self.travel } else { time / self.duration }
    }

    /// Time of the run \[s\] at a punch travel \[mm\].
    pub fn time_at(&self, travel: f64) -> f64 {
        match &self.schedule {
            Some(schedule) => schedule.reaches(travel),
            None => travel / self.speed,
        }
    }

    /// Process time of the part of the run from `time` on that takes `dt` \[s\] by the clock: how long it would take at the
    /// mean speed \[s\]. Lengths of steps are measured in it, so that a punch that changes its speed goes equal ways in
    /// equal steps.
    pub fn process_time(&self, time: f64, dt: f64) -> f64 {
        match &self.schedule {
            Some(schedule) => self.duration * (schedule.at(time + dt) - schedule.at(time)) / self.travel,
            None => dt,
        }
    }

    /// Time by the clock \[s\] of the part from `time` on that has this process time \[s\].
    pub fn clock_time(&self, time: f64, process_time: f64) -> f64 {
        match &self.schedule {
            Some(schedule) => schedule.reaches(schedule.at(time) + self.travel * process_time / self.duration) - time,
            None => process_time,
        }
    }

    /// Time after `time` at which the punch next changes its speed \[s\]; infinite where it does not.
    pub fn next_change(&self, time: f64) -> f64 {
        let changes = self.schedule.iter().flat_map(|schedule| schedule.points());
        let after = time + 1e-12 * self.duration;
        changes.map(|p| p.0).find(|t| *t > after).unwrap_or(f64::INFINITY)
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
