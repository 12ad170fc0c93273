//! What a run leaves behind: the history of every step, the kept frames, and why it stopped.

mod frame;
pub mod neck;

use crate::forming_limit::Paths;
use crate::geometry::Point;
use crate::model::{Model, ModelError, PressureCap, mesh};
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
    /// Cauchy stress along the section, mean over the thickness \[MPa\].
    pub stress_meridional: f64,
    /// Cauchy stress across the section, mean over the thickness \[MPa\].
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
    /// Cauchy stress along the section \[MPa\].
    pub stress_meridional: f64,
    /// Cauchy stress across the section \[MPa\].
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

/// Mean powers of a step, or the work done since the start \[mW or mJ, per ring or per mm of depth\].
///
/// external = plastic + elastic + friction + contact, where `contact` is what the penalty springs store.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Of the driven tools and edges on the sheet.
    pub external: f64,
    /// Of the plastic flow in the sheet.
    pub plastic: f64,
    /// What the sheet's elasticity stores; 0 by the flow law.
    pub elastic: f64,
    /// Of the friction on tools and beads.
    pub friction: f64,
    /// What the penalty springs of the contact store.
    pub contact: f64,
    /// The part of `plastic` in points whose strain rate is below ten times the cut-off.
    pub cutoff: f64,
}

impl Energy {
    /// What of the largest entry is round-off \[–\].
    const ROUND_OFF: f64 = 1e-9;

    /// Every entry times `factor`: power from work, work from power.
    pub fn scaled(self, factor: f64) -> Self {
        Self {
            external: self.external * factor,
            plastic: self.plastic * factor,
            elastic: self.elastic * factor,
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
            elastic: self.elastic + other.elastic,
            friction: self.friction + other.friction,
            contact: self.contact + other.contact,
            cutoff: self.cutoff + other.cutoff,
        }
    }

    /// As it is written: entries below 1e-9 of the largest are round-off, and 0.
    pub fn without_round_off(self) -> Self {
        let Self { external, plastic, elastic, friction, contact, cutoff } = self;
        let largest = [external, plastic, elastic, friction, contact].map(f64::abs).into_iter().fold(0.0, f64::max);
        let clean = |energy: f64| if energy.abs() < Self::ROUND_OFF * largest { 0.0 } else { energy };
        Self {
            external: clean(external),
            plastic: clean(plastic),
            elastic: clean(elastic),
            friction: clean(friction),
            contact: clean(contact),
            cutoff: clean(cutoff),
        }
    }

    /// What the balance misses, over the external work \[–\].
    pub fn imbalance(&self) -> f64 {
        let missing = self.external - self.plastic - self.elastic - self.friction - self.contact;
        if self.external == 0.0 { 0.0 } else { missing / self.external.abs() }
    }
}

/// Heat since the start \[mJ, per ring or per mm of depth\]: stored = plastic + tools.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Heat {
    /// What the plastic work has left in the sheet.
    pub plastic: f64,
    /// What the tools have given to it; negative when they cool it.
    pub tools: f64,
    /// What warms it.
    pub stored: f64,
}

impl Heat {
    /// The sum, entry by entry.
    pub fn plus(self, other: Self) -> Self {
        Self {
            plastic: self.plastic + other.plastic,
            tools: self.tools + other.tools,
            stored: self.stored + other.stored,
        }
    }
}

/// One accepted step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StepRecord {
    /// Number of the step, from 1.
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
    /// How far the holder has moved towards the die from where it touched the flat sheet \[mm\]; negative when lifted. A
    /// holder that the sheet has left stays where it last touched.
    pub holder_move: f64,
    /// Force of the holder that its distance blocks bear in place of the sheet \[N, or N/mm\].
    pub block_force: f64,
    /// Largest penetration of a tool over the sheet's thickness, where the sheet is not ironed \[–\].
    pub penetration: f64,
    /// Largest share of the thickness by which the sheet is too thick for the gap between two tools \[–\]: ironing.
    pub ironing: f64,
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
    /// Relative velocity increment at acceptance \[–\].
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
}

/// How the steps of a run came to equilibrium: counts of steps by the start that did it, and of steps cut short.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effort {
    /// From the velocities of the last step.
    pub predictor: usize,
    /// From rest and a few iterations with the secant matrix.
    pub secant: usize,
    /// From the answer with a larger cut-off.
    pub softened: usize,
    /// Steps that no start solved and that were halved.
    pub halved: usize,
    /// Steps in equilibrium that strained the sheet too much and were repeated shorter.
    pub overstrained: usize,
    /// Tries of the step that the stage stopped at.
    pub abandoned: usize,
}

/// Why a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The model is none that can be solved: nothing was tried.
    Refused(ModelError),
    /// The run has come to its end.
    FullTravel,
    /// The load has fallen from its maximum by the share that the case asks for.
    LoadMaximum {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Largest load before \[N, or N/mm\].
        peak: f64,
        /// Share of the peak by which the load has fallen \[–\].
        drop: f64,
    },
    /// As much of the sheet lies on its tools as the case asks for.
    ContactShare {
        /// Reached \[–\].
        share: f64,
        /// Asked for by the case \[–\].
        asked: f64,
        /// Time then \[s\].
        time: f64,
        /// Punch travel then \[mm\].
        travel: f64,
    },
    /// The gas pressure has come to the largest that the sheet can bear at the height of its middle.
    PressureMaximum {
        /// The largest pressure \[MPa\].
        pressure: f64,
        /// Height of the sheet's middle then \[mm\].
        height: f64,
    },
    /// One place takes all the stretching while its surroundings stop.
    Localised {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Where, initially from the axis \[mm\].
        s0: f64,
        /// Thickness there over the initial one \[–\].
        share: f64,
        /// Where it is and why, in words.
        why: String,
    },
    /// The voids at a place have grown together through the thickness.
    Coalesced {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Where, initially from the axis \[mm\].
        s0: f64,
        /// Porosity there, mean over the thickness \[–\].
        porosity: f64,
    },
    /// The blank's edge has passed the die's throat.
    DrawnThrough {
        /// Punch travel there \[mm\].
        travel: f64,
    },
    /// Punch and die come closer than the sheet can be squeezed.
    ToolsClosed {
        /// Punch travel there \[mm\].
        travel: f64,
        /// Where they are too close: distance from the axis \[mm\].
        r: f64,
        /// Where they are too close: height \[mm\].
        z: f64,
    },
    /// An observer wanted no more of it.
    Interrupted {
        /// Punch travel reached \[mm\].
        travel: f64,
        /// Time reached \[s\].
        time: f64,
    },
    /// No equilibrium was found down to the smallest step.
    NoEquilibrium {
        /// Punch travel of the last accepted step \[mm\].
        travel: f64,
        /// Time of the last accepted step \[s\].
        time: f64,
        /// The smallest step that was tried \[s\].
        step: f64,
        /// Relative velocity increment of the last try \[–\].
        velocity_norm: f64,
        /// Relative residual of the last try \[–\].
        residual_norm: f64,
        /// Initial distance from the axis of the node with the largest residual \[mm\].
        worst_s0: f64,
        /// What the sheet was doing there, and what to try.
        diagnosis: String,
    },
}

impl Stop {
    /// Whether the run came to the end it was asked for: its full travel or time, or the contact that the part is done
    /// with. A fallen load is none, though a case may ask for it: the sheet has failed there.
    pub fn is_complete(&self) -> bool {
        matches!(self, Stop::FullTravel | Stop::ContactShare { .. })
    }

    /// Whether the sheet or the tools ended the run, not the numerics or the user.
    pub fn is_physical(&self) -> bool {
        let ours = matches!(self, Stop::Interrupted { .. } | Stop::NoEquilibrium { .. } | Stop::Refused(_));
        !self.is_complete() && !ours
    }

    /// The kind in a few words.
    pub fn kind(&self) -> &'static str {
        match self {
            Stop::Refused(_) => "refused",
            Stop::FullTravel => "full travel",
            Stop::LoadMaximum { .. } => "load maximum passed",
            Stop::ContactShare { .. } => "contact share reached",
            Stop::PressureMaximum { .. } => "pressure maximum reached",
            Stop::Localised { .. } => "localised",
            Stop::Coalesced { .. } => "voids coalesced",
            Stop::DrawnThrough { .. } => "drawn through",
            Stop::ToolsClosed { .. } => "tools closed",
            Stop::Interrupted { .. } => "interrupted",
            Stop::NoEquilibrium { .. } => "no equilibrium",
        }
    }
}

impl std::fmt::Display for Stop {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Stop::Refused(why) => write!(f, "{why}"),
            Stop::FullTravel => write!(f, "full travel reached"),
            Stop::LoadMaximum { travel, peak, drop } => write!(
                f,
                "load maximum passed: at {travel:.2} mm of travel the load is {:.1} % below its peak of {peak:.0}",
                100.0 * drop
            ),
            Stop::ContactShare { share, asked, time, travel } => {
                let place = if *travel > 0.0 { format!("{travel:.2} mm of travel") } else { format!("{time:.4} s") };
                write!(
                    f,
                    "contact share reached: at {place} {:.1} % of the sheet lies on its tools ({:.1} % asked for)",
                    100.0 * share,
                    100.0 * asked
                )
            }
            Stop::PressureMaximum { pressure, height } => write!(
                f,
                "pressure maximum reached: no equilibrium beyond {pressure:.4} MPa, at a dome height of {height:.2} mm; \
                 the sheet would run away and burst"
            ),
            Stop::Localised { travel, s0, share, why } => write!(
                f,
                "localised at {travel:.2} mm of travel: the sheet tears at s0 = {s0:.1} mm, where {:.0} % of its thickness \
                 is left; {why}",
                100.0 * share
            ),
            Stop::Coalesced { travel, s0, porosity } => write!(
                f,
                "voids coalesced at {travel:.2} mm of travel: the sheet tears at s0 = {s0:.1} mm, where {:.1} % of its volume \
                 are voids",
                100.0 * porosity
            ),
            Stop::DrawnThrough { travel } => {
                write!(f, "drawn through: the blank's edge has passed the die's throat at {travel:.2} mm of travel")
            }
            Stop::ToolsClosed { travel, r, z } => write!(
                f,
                "travel limit by geometry: at {travel:.2} mm of travel punch and die come closer than half the sheet's \
                 thickness, near r = {r:.2} mm, z = {z:.2} mm"
            ),
            Stop::Interrupted { travel, time } => write!(
                f,
                "interrupted at {travel:.2} mm of travel (time {time:.4} s): what was computed up to there is kept, but the \
                 run has not come to its end"
            ),
            Stop::NoEquilibrium { travel, time, step, velocity_norm, residual_norm, worst_s0, diagnosis } => write!(
                f,
                "no equilibrium found at {travel:.3} mm of travel (time {time:.4} s) with steps down to {step:.2e} s \
                 (velocity norm {velocity_norm:.1e}, residual norm {residual_norm:.1e}, worst at s0 = {worst_s0:.2} mm); \
                 {diagnosis}"
            ),
        }
    }
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
    /// What was cut off before the stage began; `None` where nothing was asked for.
    pub trimmed: Option<Trimmed>,
    /// Travel at which the sheet left each of the model's tools \[mm\], which stands still from there on; `None` of those
    /// that it has not left.
    pub left_at: Vec<Option<f64>>,
}

/// A rim that was cut off before a stage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trimmed {
    /// Distance from the axis or symmetry plane that was asked for \[mm\].
    pub asked: f64,
    /// Where the edge is: whole elements go \[mm\].
    pub edge: f64,
    /// Elements that were cut off.
    pub elements: usize,
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
