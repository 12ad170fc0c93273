//! What a later stage changes: a patch on the model of the stage before.

use crate::geometry::Profile;
use crate::model::{Beginning, Edge, Friction, Mode, Model, Motion, Release, Role, StopRules, Tool};

/// What a stage changes of the model before it; what is `None` stays.
pub(super) struct StagePatch {
    pub tools: Vec<ToolPatch>,
    pub pace: Pace,
    pub edge: Option<Edge>,
    pub mode: Option<Mode>,
    pub release: Option<Release>,
    /// Number of equally spaced instants that are kept.
    pub frames: usize,
    pub begin: Beginning,
}

/// What a stage changes of a tool.
pub(super) struct ToolPatch {
    pub role: Role,
    /// The section of a new tool.
    pub profile: Option<Profile>,
    pub friction: Option<Friction>,
    pub motion: Option<Motion>,
}

/// How far the tools of a stage go, and how fast.
pub(super) struct Pace {
    /// The longest path of a tool \[mm\].
    pub travel: f64,
    /// \[s\]
    pub duration: f64,
    /// \[mm/s\]
    pub speed: f64,
    /// As in [`Model`].
    pub timed: bool,
}

impl StagePatch {
    /// The model with the patch.
    pub fn applied_to(&self, mut model: Model) -> Model {
        let Pace { travel, duration, speed, timed } = self.pace;
        (model.travel, model.duration, model.speed, model.timed) = (travel, duration, speed, timed);
        for patch in &self.tools {
            patch.apply_to(&mut model.tools);
        }
        if self.release.is_some() {
            model.tools.iter_mut().for_each(|tool| tool.motion = Motion::Fixed);
        }
        model.release = self.release;
        model.mode = self.mode.unwrap_or(model.mode);
        model.blank.edge = self.edge.unwrap_or(model.blank.edge);
        model.frames = equally_spaced(duration, self.frames);
        model
    }
}

impl ToolPatch {
    fn apply_to(&self, tools: &mut Vec<Tool>) {
        if let (Some(profile), Some(friction)) = (self.profile.clone(), self.friction) {
            tools.retain(|tool| tool.role != self.role);
            tools.push(Tool { role: self.role, profile, friction, motion: Motion::Fixed });
            tools.sort_by_key(|tool| Role::ALL.iter().position(|role| *role == tool.role));
        }
        for tool in tools.iter_mut().filter(|tool| tool.role == self.role) {
            tool.friction = self.friction.unwrap_or(tool.friction);
            tool.motion = self.motion.clone().unwrap_or(tool.motion.clone());
        }
    }
}

/// Instants of a run \[s\], the last one its end.
pub(super) fn equally_spaced(duration: f64, count: usize) -> Vec<f64> {
    (1..count).map(|i| duration * i as f64 / count as f64).chain([duration]).collect()
}

/// What stays of the model before where a stage says nothing: tools that went stand still, and a holder keeps the force that
/// it had at the end.
pub(super) fn at_rest(before: &Model, first: &Model, standing: Vec<Tool>) -> Model {
    let mut model = Model { tools: standing, gas: Vec::new(), schedule: None, ..before.clone() };
    for tool in &mut model.tools {
        match &mut tool.motion {
            Motion::Pressed(press) => press.force = press.force.at(before.travel).into(),
            Motion::Gap(_) => {}
            motion => *motion = Motion::Fixed,
        }
    }
    let StopRules { localised, drawn_through, .. } = first.stop;
    model.stop = StopRules { localised, drawn_through, ..StopRules::default() };
    model
}
