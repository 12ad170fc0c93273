//! Results of a run: the record of every step, the kept frames, and the reason of its end.

mod energy;
mod frame;
pub mod neck;
mod step_record;
mod stop;

pub use energy::{Energy, Heat};
pub use frame::{ElementRecord, Frame, NodeRecord, PointRecord, ThroughThickness};
pub use step_record::StepRecord;
pub use stop::{Stop, StopKind};

use super::*;
use crate::forming_limit::{Onset, Paths};
use crate::solver::{Remedy, Start};

/// Closing of the holder on the die over the sheet, before the punch moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closing {
    /// Travel from the flat sheet to one thickness from the die \[mm\].
    pub way: f64,
    /// Part of the travel left when the force was reached: how far the holder stands open \[mm\].
    pub gap: f64,
    /// Force at the end of closing \[N, or N/mm of depth\].
    pub force: f64,
}

/// Rim cut off before a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trimmed {
    /// Requested distance of the cut from the axis or symmetry plane \[mm\].
    pub asked: f64,
    /// Actual distance of the edge: whole elements are removed \[mm\].
    pub edge: f64,
    /// Number of elements removed.
    pub elements: usize,
}

/// Counts of steps by the start that converged, and of repeated steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// Steps from the velocities at the end of the last step.
    pub predictor: usize,
    /// Steps from rest with the secant matrix.
    pub secant: usize,
    /// Steps from the solution with a larger cut-off.
    pub softened: usize,
    /// Steps halved because no start converged.
    pub halved: usize,
    /// Steps repeated shorter because they strained the sheet too much.
    pub overstrained: usize,
    /// Steps repeated shorter because they went beyond the end of the run.
    pub overstepped: usize,
    /// Tries of the step at which the run stopped.
    pub abandoned: usize,
}

/// Results of one stage.
#[derive(Clone, Debug, PartialEq)]
pub struct StageSolution {
    /// Model of the stage, its blank cut to the sheet at its start.
    pub model: Model,
    /// Frame before the first step; `None` when the stage has not begun.
    pub start: Option<Frame>,
    /// Accepted steps.
    pub steps: Vec<StepRecord>,
    /// Force along z of every tool on the sheet at each of the steps \[N, or N/mm of depth\].
    pub tool_forces: Vec<Vec<f64>>,
    /// Kept frames in the order of time; only the last one has thickness points.
    pub frames: Vec<Frame>,
    /// Strain paths; empty without a forming limit.
    pub paths: Paths,
    /// First neck that took over and lasted, if any.
    pub neck: Option<Onset>,
    /// Last state.
    pub end: State,
    /// Reason of the end.
    pub stop: Stop,
    /// Counts of starts and repeated steps.
    pub effort: Effort,
    /// Largest absolute external work at any step of the other stages \[mJ, or per mm of depth\].
    pub process_work: f64,
    /// Stretches that other settings than the model's have solved, and the travels at their begin and end \[mm\].
    pub remedied: Vec<(Remedy, [f64; 2])>,
    /// Closing of the holder; `None` where it lay on the flat sheet.
    pub closing: Option<Closing>,
    /// Rim cut off before the stage; `None` without trimming.
    pub trimmed: Option<Trimmed>,
    /// Travel at which the sheet left each of the model's tools \[mm\]; `None` of those that it has not left.
    pub left_at: Vec<Option<f64>>,
}

impl StageSolution {
    /// Names of the further tools, and the force with which each presses on the sheet at each of the steps \[N, or N/mm\].
    pub fn further_forces(&self) -> impl Iterator<Item = (&str, Vec<f64>)> {
        let tools = self.model.tools.iter().enumerate().filter(|(_, tool)| tool.role.further().is_some());
        tools.map(|(j, tool)| (self.model.name_of(tool.role), self.pressing(j)))
    }

    /// Force at each step of the further tool that [works](Model::worker), else of the punch, or of a tube's feed \[N, or N/mm\].
    pub fn working_force(&self) -> Vec<f64> {
        let worker = Some(self.model.worker()).filter(|role| role.further().is_some());
        let punch = || self.steps.iter().map(|step| step.punch_force + self.model.thrust(step.pressure)).collect();
        worker.and_then(|role| self.model.tool_index(role)).map_or_else(punch, |j| self.pressing(j))
    }

    /// [`Self::peaks`] of the further tools.
    pub fn further_peaks(&self) -> impl Iterator<Item = (&Tool, &str, f64)> {
        self.peaks().filter(|(tool, ..)| tool.role.further().is_some())
    }

    /// Every tool with its name and the largest force with which it presses on the sheet \[N, or N/mm\].
    pub fn peaks(&self) -> impl Iterator<Item = (&Tool, &str, f64)> {
        let peak = |j: usize| self.pressing(j).into_iter().fold(0.0, f64::max);
        self.model.tools.iter().enumerate().map(move |(j, tool)| (tool, self.model.name_of(tool.role), peak(j)))
    }

    /// Force with which a tool presses on the sheet at each of the steps \[N, or N/mm\].
    pub fn pressing(&self, tool: usize) -> Vec<f64> {
        self.tool_forces.iter().map(|forces| -self.model.tools[tool].role.side() * forces[tool]).collect()
    }

    /// Frames before and after a release; `None` of other stages.
    pub fn released(&self) -> Option<[&Frame; 2]> {
        self.model.release?;
        Some([self.start.as_ref()?, self.frames.last()?])
    }

    /// Largest absolute external work at any step of any stage of the process \[mJ, or per mm of depth\].
    pub fn largest_work(&self) -> f64 {
        self.steps.iter().map(|step| step.work.external.abs()).fold(self.process_work, f64::max)
    }

    /// Empty results of a stage that has not begun, without a state.
    pub fn unsolved(model: Model, stop: Stop) -> Self {
        Self {
            start: None,
            steps: Vec::new(),
            tool_forces: Vec::new(),
            frames: Vec::new(),
            paths: Paths::default(),
            neck: None,
            end: State::default(),
            stop,
            effort: Effort::default(),
            process_work: 0.0,
            remedied: Vec::new(),
            closing: None,
            trimmed: None,
            left_at: vec![None; model.tools.len()],
            model,
        }
    }
}

/// One evaluation of the corrector, in accepted and rejected tries.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IterationRecord {
    /// Number of the step, from 1.
    pub step: usize,
    /// Punch travel at the end of the step \[mm\].
    pub travel: f64,
    /// Starting point of the try.
    pub start: Start,
    /// Iteration matrix.
    pub matrix: Iteration,
    /// Number of the iteration; 0 before the first.
    pub iteration: usize,
    /// Relative velocity increment that led here \[–\]; 0 before the first.
    pub velocity_norm: f64,
    /// Relative residual \[–\].
    pub residual_norm: f64,
    /// Share of the computed increment that was taken \[–\]; below 1 when a move was capped or taken back.
    pub share: f64,
    /// Distance from the axis of the node with the largest residual \[mm\].
    pub worst_r: f64,
    /// Pairs of contact point and tool that penetrate.
    pub active_contacts: usize,
    /// Pairs of contact point and tool under pressure.
    pub touching: usize,
    /// Pairs under pressure that slide slower than the regularisation speed.
    pub sticking: usize,
    /// Elements that strain by less than ten cut-offs.
    pub cut_off: usize,
}
