//! What a run leaves behind: the history of every step, the kept frames, and why it stopped.

mod beginning;
mod energy;
mod frame;
pub mod neck;
mod stop;

pub use beginning::{Closing, Trimmed};
pub use energy::{Energy, Heat};
pub use stop::Stop;

use crate::forming_limit::Paths;
use crate::geometry::Point;
use crate::model::{Model, PressureCap, mesh};
use crate::numerics::lobatto::ThicknessPoint;
use crate::state::State;

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

/// One accepted step; forces, works and heat are of the whole section, as [`Extent`](crate::model::Extent) has it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepRecord {
    /// Number of the step, from 1.
    pub step: usize,
    /// Time at the end of the step \[s\].
    pub time: f64,
    /// Punch travel at the end of the step \[mm\].
    pub travel: f64,
    /// Force of the punch on the sheet along its travel \[N, or N/mm of depth\].
    pub punch_force: f64,
    /// Force of the holder on the sheet towards the die \[N, or N/mm\].
    pub holder_force: f64,
    /// Radial force that the held edge exerts outward, of a plane section both edges together \[N, or N/mm\]; 0 for a free
    /// edge.
    pub edge_force: f64,
    /// How far the blank's edge has moved inward \[mm\].
    pub draw_in: f64,
    /// Thickness of the thinnest element \[mm\].
    pub thinnest: f64,
    /// Initial distance of the thinnest element from the axis \[mm\].
    pub thinnest_s0: f64,
    /// Height of the sheet's middle above the flat blank, along the punch travel \[mm\].
    pub pole_height: f64,
    /// Gas pressure on the lower face less that on the upper \[MPa\].
    pub pressure: f64,
    /// Norm of the strain rate that a gas pressure holds \[1/s\]; 0 where none does.
    pub held_rate: f64,
    /// The cap that this gas pressure sits on; the rate is below its target then.
    pub on_cap: Option<PressureCap>,
    /// Share of the sheet's current area inside the gas's seal (of the whole sheet without gas) that lies on the punch or
    /// the die \[–\].
    pub contact_share: f64,
    /// Gap between the sheet's edge and punch, die and holder, in the order of [`Role::ALL`](crate::model::Role::ALL), half its
    /// thickness off \[mm\]; infinite where there is no such tool.
    pub edge_gap: [f64; 3],
    /// Likewise of the sheet's middle \[mm\].
    pub middle_gap: [f64; 3],
    /// Angle to the flat blank of the die's face nearest to the sheet's edge \[rad\]: 0 on a flat die, π/2 in its throat; 0
    /// without a die.
    pub die_slope: f64,
    /// How far the holder has moved towards the die from where it touched the flat sheet \[mm\]; negative when lifted. A
    /// holder that the sheet has left stays where it last touched.
    pub holder_move: f64,
    /// Force of the holder that its distance blocks bear in place of the sheet \[N, or N/mm\].
    pub block_force: f64,
    /// Largest penetration of a tool over the sheet's thickness \[–\].
    pub penetration: f64,
    /// Largest reduction of an element's thickness by ironing in this stage so far, 1 − exp(−ε) \[–\]: ε is what it has thinned
    /// in the steps in which two tools, none of them driven by a force, pressed both its faces with more than a tenth of
    /// its yield stress each.
    pub ironing: f64,
    /// Initial distance of that element from the axis \[mm\].
    pub ironing_s0: f64,
    /// Force of the die on the ironed elements against the punch travel \[N, or N/mm\], friction included.
    pub ironing_force: f64,
    /// What of it is friction \[N, or N/mm\].
    pub ironing_friction: f64,
    /// Largest pressure of a tool on an ironed element \[MPa\].
    pub ironing_pressure: f64,
    /// Share of the holder's force on the rim, the outermost [`StepRecord::RIM`] thicknesses of the blank \[–\].
    pub rim_share: f64,
    /// Share of the nodes in contact that stick: they slide slower than the regularisation speed \[–\].
    pub sticking: f64,
    /// Pairs of node and tool that came into contact or left it in the step.
    pub contact_changes: usize,
    /// Largest equivalent strain that the step added at a thickness point \[–\].
    pub strain_increment: f64,
    /// Thickness over the smallest bending radius of the mid-surface \[–\]; 0 while the sheet is flat.
    pub sharpest_bend: f64,
    /// Elements that bend; the others are membranes.
    pub bending: usize,
    /// Iterations of the try that was accepted.
    pub iterations: usize,
    /// Tries that were rejected before this step was accepted.
    pub rejected: usize,
    /// Relative velocity increment at acceptance \[–\]; 0 where the predictor was in equilibrium.
    pub velocity_norm: f64,
    /// Relative residual at acceptance \[–\].
    pub residual_norm: f64,
    /// Mean powers of the step.
    pub power: Energy,
    /// Work since the start.
    pub work: Energy,
    /// Largest porosity, mean over the thickness \[–\].
    pub porosity: f64,
    /// Where the porosity is largest, initially from the axis \[mm\].
    pub porous_s0: f64,
    /// Lowest temperature of an element \[K\].
    pub coldest: f64,
    /// Highest temperature of an element \[K\].
    pub hottest: f64,
    /// Heat since the start.
    pub heat: Heat,
}

impl StepRecord {
    /// Width of the rim over the initial thickness \[–\].
    pub const RIM: f64 = 3.0;

    /// With forces, powers, works and heat so many times as large \[–\].
    pub fn scaled(self, times: f64) -> Self {
        Self {
            punch_force: times * self.punch_force,
            holder_force: times * self.holder_force,
            edge_force: times * self.edge_force,
            block_force: times * self.block_force,
            ironing_force: times * self.ironing_force,
            ironing_friction: times * self.ironing_friction,
            power: self.power.scaled(times),
            work: self.work.scaled(times),
            heat: self.heat.scaled(times),
            ..self
        }
    }
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

/// One iteration of the corrector, accepted step or not.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct IterationRecord {
    /// Number of the step that is tried, from 1.
    pub step: usize,
    /// Punch travel at the end of the step that is tried \[mm\].
    pub travel: f64,
    /// Number of the iteration, from 0.
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
