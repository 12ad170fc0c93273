//! What is to be solved, in mm, N, s and MPa: a [`Model`] is one forming operation, a [`Stage`] a model and how it begins.

mod blank;
mod check;
mod error;
mod extent;
mod heat;
mod loads;
pub mod mesh;
mod mode;
mod role_names;
mod settings;
pub mod stage;
pub mod tool_sizes;
mod tools;

pub use blank::{Blank, Edge, Grading, ThicknessRule};
pub use error::ModelError;
pub use extent::Extent;
pub use heat::{Heat, HeatFlow, ToolHeat};
pub use loads::{Bead, Face, Gas, Pressure, PressureCap, RateControl};
pub use mode::{Mode, Release, ReleaseStiffness};
pub use settings::{ContactMethod, Norm, Settings, StopRules};
pub use stage::{Beginning, Stage};
pub use tools::{Motion, Press, Role, Tool};

pub use crate::contact::friction::Friction;
pub use crate::element::{Geometry, Theory};
pub use crate::material::flow::Iteration;

use crate::forming_limit::Curve;
use crate::material::flow::Triple;
use crate::material::{Elastic, Material};
use crate::numerics::PiecewiseLinear;

/// A validated forming problem in solver units.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    /// Shown above plots and reports.
    pub title: String,
    /// Declared assumptions, shown wherever results are shown.
    pub notes: Vec<String>,
    /// Axisymmetric or plane strain.
    pub geometry: Geometry,
    /// Length of the part across a plane section \[mm\]; `None` where it is not known, and of a body of revolution.
    pub depth: Option<f64>,
    /// The sheet before forming.
    pub blank: Blank,
    /// What the sheet is made of.
    pub material: Material,
    /// At most one tool of each role.
    pub tools: Vec<Tool>,
    /// Line restraints across the flange.
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
    /// Whether its times are those of a press: a speed, a motion or a duration is given, or something in the model feels the
    /// rate. Else they follow from a speed that stands for any, and no reader is told them.
    pub timed: bool,
    /// Times at which the state is kept \[s\], rising, the last one equal to `duration`.
    pub frames: Vec<f64>,
    /// What ends the run before its full travel.
    pub stop: StopRules,
    /// How the problem is solved.
    pub settings: Settings,
    /// How the metal answers to strain.
    pub mode: Mode,
    /// `None` while the tools act.
    pub release: Option<Release>,
    /// The forming limit that the strains are held against; with one, their paths are kept.
    pub forming_limit: Option<Curve>,
}

impl Model {
    /// What its forces and works are of.
    pub fn extent(&self) -> Extent {
        Extent::of(self.geometry, self.depth)
    }

    /// The tool of a role, where there is one.
    pub fn tool(&self, role: Role) -> Option<&Tool> {
        self.tools.iter().find(|t| t.role == role)
    }

    /// The elasticity that the sheet has in its mode: none by the flow law.
    pub fn elasticity(&self) -> Option<Elastic> {
        self.material.elastic.filter(|_| self.mode != Mode::Flow)
    }

    /// Elastic energy per volume that a stress stores \[MPa\]; the flow law stores none.
    pub fn stored(&self, stress: Triple) -> f64 {
        self.elasticity().map_or(0.0, |elastic| elastic.energy(stress))
    }

    /// Cauchy's stress of one per initial volume \[MPa\]; by the flow law they are the same.
    pub fn cauchy(&self, stress: Triple) -> Triple {
        let volume = self.elasticity().map_or(1.0, |elastic| elastic.volume_strain(stress).exp());
        stress.map(|stress| stress / volume)
    }

    /// Whether the tools may leave the sheet: they go ways of their own, or stand and nothing else drives the sheet, as in
    /// later stages.
    pub fn may_be_left(&self) -> bool {
        let goes_own_way = |tool: &Tool| matches!(tool.motion, Motion::Path(_));
        let pulled = matches!(self.blank.edge, Edge::Pulled { .. });
        let driven = pulled || !self.gas.is_empty() || self.tools.iter().any(|tool| tool.motion == Motion::Travel);
        self.tools.iter().any(goes_own_way) || !(driven || self.release.is_some())
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
