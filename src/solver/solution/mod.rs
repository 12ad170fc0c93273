//! What a run leaves behind: the history of every step, the kept frames, and why it stopped.

mod beginning;
mod energy;
mod frame;
pub mod neck;
mod step_record;
mod stop;

pub use beginning::{Closing, Trimmed};
pub use energy::{Energy, Heat};
pub use step_record::StepRecord;
pub use stop::{LOST, Stop};

use crate::forming_limit::Paths;
use crate::geometry::Point;
use crate::model::{Iteration, Model, mesh};
use crate::numerics::lobatto::ThicknessPoint;
use crate::solver::Start;
use crate::solver::state::State;

/// One element at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementRecord {
    /// Initial distance of the element's middle from the axis \[mm\].
    pub s0: f64,
    /// Distance of the element's middle from the axis \[mm\].
    pub r: f64,
    /// Height of the element's middle, along the punch travel \[mm\].
    pub z: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Logarithmic mid-surface strain along the section \[–\].
    pub strain_meridional: f64,
    /// Logarithmic mid-surface strain across the section \[–\].
    pub strain_hoop: f64,
    /// ln(t/t₀) \[–\].
    pub strain_thickness: f64,
    /// Equivalent plastic strain, mean over the thickness \[–\].
    pub strain_equivalent: f64,
    /// Largest equivalent plastic strain over the thickness \[–\].
    pub strain_equivalent_max: f64,
    /// Cauchy stress along the section, mean over the thickness; where a tool presses on a face with p, its stress is p/2 lower
    /// \[MPa\].
    pub stress_meridional: f64,
    /// Cauchy stress across the section, likewise \[MPa\].
    pub stress_hoop: f64,
    /// Volume of voids over that of the sheet, mean over the thickness \[–\].
    pub porosity: f64,
    /// Temperature \[K\].
    pub temperature: f64,
    /// Whether it bent in the last step, or was a membrane.
    pub bends: bool,
}

/// One node at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodeRecord {
    /// Distance of the mid-surface from the axis \[mm\].
    pub r: f64,
    /// Height of the mid-surface, along the punch travel \[mm\].
    pub z: f64,
    /// Rotation of the fibre, counter-clockwise in the r-z plane \[rad\].
    pub theta: f64,
    /// Thickness that contact sees \[mm\].
    pub thickness: f64,
}

/// One thickness point of an element at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PointRecord {
    /// Cauchy stress along the section, likewise \[MPa\].
    pub stress_meridional: f64,
    /// Cauchy stress across the section, likewise \[MPa\].
    pub stress_hoop: f64,
    /// Equivalent plastic strain \[–\].
    pub strain_equivalent: f64,
}

/// The sheet through its thickness at one instant; empty in a frame that does not look there.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ThroughThickness {
    /// Where the points of every element lie: ξ = ζ/(t/2) from −1 on the die's face to 1 on the punch's, because ζ goes
    /// from the mid-surface along −n, n = (−sin φ, cos φ), and the punch pushes along n.
    pub layers: Vec<ThicknessPoint>,
    /// Element by element, in the order of `layers`.
    pub points: Vec<PointRecord>,
}

impl ThroughThickness {
    /// The points of each element, from the axis outward.
    pub fn elements(&self) -> std::slice::ChunksExact<'_, PointRecord> {
        self.points.chunks_exact(self.layers.len().max(1))
    }
}

/// What is kept of an instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Time \[s\].
    pub time: f64,
    /// Punch travel \[mm\].
    pub travel: f64,
    /// Elements, from the axis outward.
    pub elements: Vec<ElementRecord>,
    /// Nodes, from the axis outward.
    pub nodes: Vec<NodeRecord>,
    /// What lies through the thickness.
    pub through: ThroughThickness,
    /// Displacement of each tool (away from the axis, along z) from where it is drawn in the model \[mm\], in the model's
    /// order.
    pub tool_displacement: Vec<Point>,
}

/// How the steps of a run came to equilibrium: counts of steps by the start that did it, and of steps cut short.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// From the velocities at the end of the last step.
    pub predictor: usize,
    /// From rest and a few iterations with the secant matrix.
    pub secant: usize,
    /// From the answer with a larger cut-off.
    pub softened: usize,
    /// Steps that no start solved and that were halved.
    pub halved: usize,
    /// Steps in equilibrium that strained the sheet too much and were repeated shorter.
    pub overstrained: usize,
    /// Steps in equilibrium that went beyond the end of the run and were repeated shorter.
    pub overstepped: usize,
    /// Tries of the step that the stage stopped at.
    pub abandoned: usize,
}

/// A solved stage: what came out of one model.
#[derive(Clone, Debug, PartialEq)]
pub struct StageSolution {
    /// The stage's model, its blank cut to the sheet that the stage began with.
    pub model: Model,
    /// The sheet and its tools before the first step; `None` of a stage that has not begun.
    pub start: Option<Frame>,
    /// The accepted steps.
    pub steps: Vec<StepRecord>,
    /// In the order of time; only the last one looks through the thickness.
    pub frames: Vec<Frame>,
    /// Strains over the steps, where the model has a forming limit; empty without.
    pub paths: Paths,
    /// Where it ended.
    pub end: State,
    /// Why it ended.
    pub stop: Stop,
    /// How the steps came to equilibrium.
    pub effort: Effort,
    /// How the holder closed before the punch came; `None` where it lay on the flat sheet.
    pub closing: Option<Closing>,
    /// What was cut off before the stage began; `None` where nothing was asked for.
    pub trimmed: Option<Trimmed>,
    /// Travel at which the sheet left each of the model's tools \[mm\], which stands still from there on; `None` of those
    /// that it has not left.
    pub left_at: Vec<Option<f64>>,
}

impl StageSolution {
    /// Keeps another frame; only the last one keeps what lies through the thickness, many times the rest of it.
    pub fn keep(&mut self, frame: Frame) {
        if let Some(before) = self.frames.last_mut() {
            before.through = ThroughThickness::default();
        }
        self.frames.push(frame);
    }

    /// The sheet before and after a stage that takes its tools away; `None` of other stages, and where nothing was kept.
    pub fn released(&self) -> Option<[&Frame; 2]> {
        self.model.release?;
        Some([self.start.as_ref()?, self.frames.last()?])
    }

    /// The largest external work that the tools had done, or got back, by any step \[mJ, or per mm of depth\].
    pub fn largest_work(&self) -> f64 {
        self.steps.iter().map(|step| step.work.external.abs()).fold(0.0, f64::max)
    }

    /// A stage that has not begun.
    pub fn unsolved(model: Model) -> Self {
        let end = State::flat(&model, mesh::nodes(&model));
        Self { end, ..Self::refused(model, Stop::FullTravel) }
    }

    /// A stage that was not tried; its last state is empty.
    pub fn refused(model: Model, stop: Stop) -> Self {
        Self {
            start: None,
            steps: Vec::new(),
            frames: Vec::new(),
            paths: Paths::default(),
            end: State::default(),
            stop,
            effort: Effort::default(),
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
