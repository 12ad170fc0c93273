//! Forming problems in mm, N, s and MPa: a [`Model`] is one operation, a [`Stage`] a model with its beginning.

mod blank;
mod check;
mod extent;
mod heat;
mod loads;
mod mode;
pub mod refinement;
mod role_names;
mod settings;
pub mod stage;
pub mod tool_sizes;
mod tools;

pub use blank::{Blank, Edge, EdgeLimit, Grading, Preform, ThicknessRule, Zone};
pub use check::ModelError;
pub use extent::Extent;
pub use heat::{Heat, HeatFlow, ToolHeat};
pub use loads::{Bead, Face, Gas, Pressure, PressureCap, RateControl, Round};
pub use mode::{Mode, ReleaseStiffness};
pub use role_names::operation_in;
pub use settings::{ContactMethod, Norm, Settings, StopRules};
pub use stage::{Beginning, Stage};
pub use tools::{Motion, Press, Role, Tool};

pub use crate::contact::friction::Friction;
pub use crate::element::{Geometry, Theory};
pub use crate::material::flow::Iteration;

use crate::forming_limit::Curve;
use crate::material::{Elastic, Material, flow::Triple};
use crate::numerics::PiecewiseLinear;

/// A validated forming problem in solver units.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Title of plots and reports.
    pub title: String,
    /// Declared assumptions, shown with results.
    pub notes: Vec<String>,
    /// Axisymmetric or plane strain.
    pub geometry: Geometry,
    /// Length of the part across a plane section \[mm\]; `None` where it is not known, and of a body of revolution.
    pub depth: Option<f64>,
    /// The sheet before forming.
    pub blank: Blank,
    /// Metal of the sheet.
    pub material: Material,
    /// Tools, at most one of each role.
    pub tools: Vec<Tool>,
    /// Names of the further tools, by their numbers.
    pub further: Vec<String>,
    /// Line restraints across the flange.
    pub beads: Vec<Bead>,
    /// Gas, at most one on each face.
    pub gas: Vec<Gas>,
    /// Temperatures; `None` at room temperature throughout.
    pub heat: Option<Heat>,
    /// Punch travel of the run, in a later stage the longest path of a tool \[mm\]; 0 without a driven tool.
    pub travel: f64,
    /// Punch travel over time \[mm over s\], rising from 0 at 0 to the whole travel; `None` at a constant speed.
    pub schedule: Option<PiecewiseLinear>,
    /// Mean punch speed \[mm/s\]; without a punch, the reference speed.
    pub speed: f64,
    /// Duration of the run \[s\].
    pub duration: f64,
    /// True if times are those of a press: a speed, motion or duration is given, or something depends on the rate.
    pub timed: bool,
    /// Times at which the state is kept \[s\], rising, the last one equal to `duration`.
    pub frames: Vec<f64>,
    /// Rules that end the run before its full travel.
    pub stop: StopRules,
    /// Numerical parameters.
    pub settings: Settings,
    /// Constitutive mode.
    pub mode: Mode,
    /// Release of the tools; `None` while they act.
    pub release: Option<ReleaseStiffness>,
    /// Forming limit curve; with one, strain paths are kept.
    pub forming_limit: Option<Curve>,
}

impl Model {
    /// Values that an import could not know, by the case's notes.
    pub fn placeholders(&self) -> Option<&str> {
        let split = |note| str::split_once(note, "placeholders, not in the drawing: ");
        self.notes.iter().find_map(|note| split(note)).map(|(_, open)| open)
    }

    /// Axisymmetric sheet by the flow law with default settings; the punch travels `travel` \[mm\] at 1 mm/s.
    pub fn new(blank: Blank, material: Material, tools: Vec<Tool>, travel: f64) -> Self {
        Self {
            title: String::new(),
            notes: Vec::new(),
            geometry: Geometry::Axisymmetric,
            depth: None,
            blank,
            material,
            tools,
            further: Vec::new(),
            beads: Vec::new(),
            gas: Vec::new(),
            heat: None,
            travel,
            schedule: None,
            speed: 1.0,
            duration: travel,
            timed: false,
            frames: vec![travel],
            stop: StopRules::default(),
            settings: Settings::default(),
            mode: Mode::default(),
            release: None,
            forming_limit: None,
        }
    }

    /// Extent of the part that forces and work refer to.
    pub fn extent(&self) -> Extent {
        Extent::of(self.geometry, self.depth)
    }

    /// Name of a tool; of a tube's end and of a strip that is stretched as shops have it.
    pub fn name_of(&self, role: Role) -> &str {
        match (role, self.tool(role)) {
            (Role::Punch, Some(tool)) if self.blank.is_open() => tool_sizes::name_on_tube(tool),
            (Role::Die, Some(_)) if self.is_stretch_bent() => "clamp",
            _ => role.further().and_then(|number| self.further.get(number)).map_or(role.name(), String::as_str),
        }
    }

    /// Label of the force of the tool that works, or that feeds a tube.
    pub fn force_label(&self) -> &'static str {
        match self.name_of(self.worker()) {
            _ if self.blank.edge == Edge::Fed => "Feed force",
            "punch" => "Punch force",
            "groove" => "Groove force",
            "nosing die" => "Nosing die force",
            _ => "Tool force",
        }
    }

    /// True of a strip bent over a punch that is clamped or, once it is let go, ends with the clamps' shoulders.
    pub fn is_stretch_bent(&self) -> bool {
        let ends = |clamp: &Tool| tool_sizes::shoulder_end(clamp) > self.blank.length - 1e-6;
        let is_held = self.blank.edge == Edge::Clamped || self.tool(Role::Die).is_some_and(ends);
        let is_bent = self.tool(Role::Punch).is_some() && self.tool(Role::Holder).is_none();
        self.geometry == Geometry::PlaneStrain && is_held && is_bent
    }

    /// Force of the pressure inside a tube on the seal by which its end is fed \[N, or N/mm\].
    pub fn thrust(&self, pressure: f64) -> f64 {
        let inside = self.extent().area(self.blank.edge_radius() - 0.5 * self.blank.thickness);
        if self.blank.edge == Edge::Fed { pressure.max(0.0) * inside } else { 0.0 }
    }

    /// True of a tube under pressure: its guided end is taken as the middle (declared).
    pub fn is_half_tube(&self) -> bool {
        self.blank.is_open() && self.blank.inner_edge == Edge::Guided && !self.gas.is_empty()
    }

    /// Tool that works: the punch if it moves, else the one that goes furthest, else the further tool that presses most.
    pub fn worker(&self) -> Role {
        let travel = |tool: &&Tool| tool.motion.displacement(self.travel, self.travel).norm();
        let force = |tool: &&Tool| match &tool.motion {
            Motion::Pressed(press) if tool.role.further().is_some() && self.gas.is_empty() => press.force.largest(),
            _ => 0.0,
        };
        let most = |of: &dyn Fn(&&Tool) -> f64| {
            self.tools.iter().filter(|tool| of(tool) > 0.0).max_by(|a, b| of(a).total_cmp(&of(b)))
        };
        let punch = self.tool(Role::Punch).filter(|punch| travel(punch) > 0.0);
        punch.or_else(|| most(&travel)).or_else(|| most(&force)).map_or(Role::Punch, |tool| tool.role)
    }

    /// Tool of a role.
    pub fn tool(&self, role: Role) -> Option<&Tool> {
        self.tools.iter().find(|t| t.role == role)
    }

    /// Index of the tool of a role.
    pub fn tool_index(&self, role: Role) -> Option<usize> {
        self.tools.iter().position(|tool| tool.role == role)
    }

    /// First and last of `nodes` and how they are held.
    pub fn held_edges(&self, nodes: usize) -> [(usize, Edge); 2] {
        [(0, if self.blank.hole == 0.0 { Edge::Axis } else { self.blank.inner_edge }), (nodes - 1, self.blank.edge)]
    }

    /// Metal at an initial distance from the axis or symmetry plane \[mm\].
    pub fn material_at(&self, s0: f64) -> &Material {
        self.blank.zone(s0).and_then(|zone| zone.material.as_ref()).unwrap_or(&self.material)
    }

    /// Elasticity in the model's mode; `None` by the flow law.
    pub fn elasticity(&self) -> Option<Elastic> {
        self.material.elastic.filter(|_| self.mode != Mode::Flow)
    }

    /// Elastic energy per volume \[MPa\]; 0 by the flow law.
    pub fn stored(&self, stress: Triple) -> f64 {
        self.elasticity().map_or(0.0, |elastic| elastic.energy(stress))
    }

    /// Cauchy stress of a stress per initial volume \[MPa\]; the same by the flow law.
    pub fn cauchy(&self, stress: Triple) -> Triple {
        let volume = self.elasticity().map_or(1.0, |elastic| elastic.volume_strain(stress).exp());
        stress.map(|stress| stress / volume)
    }

    /// True if the tools may leave the sheet: they follow paths of their own, or nothing drives the sheet.
    pub fn may_be_left(&self) -> bool {
        let goes_own_way = |tool: &Tool| matches!(tool.motion, Motion::Path(_));
        let pulled = matches!(self.blank.edge, Edge::Pulled { .. });
        let driven = pulled
            || self.blank.edge == Edge::Fed
            || !self.gas.is_empty()
            || self.tools.iter().any(|tool| tool.motion == Motion::Travel);
        // A sheet that is held at its far end stands by itself.
        let stands = self.blank.meridian.is_some() && self.blank.inner_edge != Edge::Free;
        stands || self.tools.iter().any(goes_own_way) || !(driven || self.release.is_some())
    }

    /// Strain rate held by a gas pressure.
    pub fn rate_control(&self) -> Option<&RateControl> {
        self.held_gas().map(|(_, control)| control)
    }

    /// Gas whose pressure holds a strain rate.
    pub fn held_gas(&self) -> Option<(&Gas, &RateControl)> {
        let mut all = self.gas.iter();
        all.find_map(|gas| if let Pressure::Rate(control) = &gas.pressure { Some((gas, control)) } else { None })
    }

    /// Punch travel \[mm\] at a time of the run \[s\].
    pub fn travel_at(&self, time: f64) -> f64 {
        self.schedule.as_ref().map_or(self.travel * (time / self.duration), |schedule| schedule.at(time))
    }

    /// Progress of the run at a time \[–\]: share of its travel, or of its time without travel.
    pub fn progress(&self, time: f64) -> f64 {
        if self.travel > 0.0 { self.travel_at(time) / self.travel } else { time / self.duration }
    }

    /// Time of the run \[s\] at a punch travel \[mm\].
    pub fn time_at(&self, travel: f64) -> f64 {
        self.schedule.as_ref().map_or(travel / self.speed, |schedule| schedule.reaches(travel))
    }

    /// Process time of the clock interval `dt` from `time` on \[s\]: equal steps in it are equal travels.
    pub fn process_time(&self, time: f64, dt: f64) -> f64 {
        let way = |schedule: &PiecewiseLinear| schedule.at(time + dt) - schedule.at(time);
        self.schedule.as_ref().map_or(dt, |schedule| self.duration * way(schedule) / self.travel)
    }

    /// Clock interval from `time` on of this process time \[s\].
    pub fn clock_time(&self, time: f64, process_time: f64) -> f64 {
        let way = self.travel * process_time / self.duration;
        self.schedule.as_ref().map_or(process_time, |schedule| schedule.reaches(schedule.at(time) + way) - time)
    }

    /// Next time at which the punch changes its speed \[s\]; infinite if never.
    pub fn next_change(&self, time: f64) -> f64 {
        let changes = self.schedule.iter().flat_map(|schedule| schedule.points());
        changes.map(|p| p.0).find(|t| *t > time + 1e-12 * self.duration).unwrap_or(f64::INFINITY)
    }
}
