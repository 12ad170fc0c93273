//! Constant data of a run: tools, thickness points, shared unknowns, fading forces.

use super::{closing::block_height, restraints::Grip, tearing_index::PlaneStrainStrength, *};
use crate::contact::friction::Friction;
use crate::geometry::Profile;
use std::ops::Range;

/// Least reference force of the residual over the yield force of the sheet \[–\]: a tenth of bending over 100 thicknesses.
const LEAST_FORCE: f64 = 1e-4;
/// Strain of the yield stress in it \[–\].
const STRENGTH_AT: f64 = 0.01;

#[derive(Clone, Debug)]
pub(super) struct ActiveTool {
    pub role: Role,
    pub profile: Profile,
    pub friction: Friction,
    pub motion: Motion,
    /// Index among the shared unknowns, if its position is one.
    pub shared: Option<usize>,
    /// Least r of its section as drawn \[mm\].
    pub inner: f64,
    /// Travel at which the sheet left the tool for good \[mm\]; it stands still from then on.
    pub released: Option<f64>,
}

impl ActiveTool {
    /// True if the sheet has left it, or it is a holder without force.
    pub fn is_absent(&self) -> bool {
        self.released.is_some() || (matches!(self.motion, Motion::Pressed(_)) && self.shared.is_none())
    }
}

pub(super) struct RunContext<'a> {
    pub model: &'a Model,
    pub tools: Vec<ActiveTool>,
    pub rule: Vec<ThicknessPoint>,
    /// Index of each gas pressure among the shared unknowns, if it is one.
    pub gas_shared: Vec<Option<usize>>,
    pub shared: usize,
    pub penalty: Penalty,
    /// Least reference force of the residual \[N, or N/mm\].
    pub least_force: f64,
    /// Move of the holder relative to the die at which it stands on its blocks \[mm\].
    pub blocks: Option<f64>,
    pub metals: Vec<Metal<'a>>,
}

/// Elements of one metal, side by side.
pub(super) struct Metal<'a> {
    pub elements: Range<usize>,
    pub material: &'a Material,
    pub strength: Option<PlaneStrainStrength<'a>>,
}

fn metals<'a>(model: &'a Model, state: &State) -> Vec<Metal<'a>> {
    let materials: Vec<_> = (0..state.thickness.len()).map(|e| model.material_at(state.middle(e))).collect();
    let mut end = 0;
    let metal = |equal: &[&'a Material]| {
        let begin = end;
        end += equal.len();
        Metal { elements: begin..end, material: equal[0], strength: PlaneStrainStrength::new(model, equal[0]) }
    };
    materials.chunk_by(|a, b| std::ptr::eq(*a, *b)).map(metal).collect()
}

impl<'a> RunContext<'a> {
    pub fn new(model: &'a Model, state: &State) -> Self {
        let mut shared = 0;
        let mut index = |unknown: bool| {
            let index = unknown.then_some(shared);
            shared += usize::from(unknown);
            index
        };
        let tools = model.tools.iter().map(|tool| ActiveTool {
            profile: tool.profile.clone(),
            friction: tool.friction,
            motion: tool.motion.clone(),
            role: tool.role,
            inner: tool.profile.pieces().iter().map(|p| p.first().x.min(p.last().x)).fold(f64::INFINITY, f64::min),
            shared: index(matches!(&tool.motion, Motion::Pressed(press) if !press.is_idle())),
            released: model.release.map(|_| 0.0),
        });
        let tools = tools.collect();
        let gas_shared = model.gas.iter().map(|gas| index(matches!(gas.pressure, Pressure::Rate(_)))).collect();
        let (settings, t, length) = (&model.settings, model.blank.thickness, model.blank.length);
        let penalty = Penalty { stiffness: settings.contact_stiffness / t, smoothing: settings.contact_smoothing * t };
        let yield_stress = model.material.yield_stress(STRENGTH_AT, ROOM_TEMPERATURE);
        let least_force = LEAST_FORCE * yield_stress * t * model.geometry.area(length) / length;
        let (rule, blocks, metals) = (model.blank.points(), block_height(model), metals(model, state));
        Self { model, tools, rule, gas_shared, shared, penalty, least_force, blocks, metals }
    }

    pub fn acting_tools(&self) -> impl Iterator<Item = (usize, &ActiveTool)> {
        self.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent())
    }

    /// Metal of element `e`.
    pub fn metal(&self, e: usize) -> &Metal<'a> {
        &self.metals[self.metals.partition_point(|metal| metal.elements.end <= e)]
    }

    pub fn holds_rate(&self) -> bool {
        self.gas_shared.iter().any(Option::is_some)
    }

    /// Releases a pressed tool once the sheet has run out from under it; returns its index.
    pub fn release(&mut self, state: &State) -> Option<usize> {
        let theory = self.model.blank.theory;
        let grip = |j: usize, tool: &ActiveTool| Grip::new(tool.inner, state.tools[j], &state.nodes, theory);
        let has_left = |(j, tool): &(usize, &ActiveTool)| tool.shared.is_some() && grip(*j, tool).width <= 0.0;
        let (lost, _) = self.acting_tools().find(has_left)?;
        self.tools[lost].released = Some(state.travel);
        Some(lost)
    }
}

pub(super) fn references(model: &Model, state: &State) -> impl Iterator<Item = Reference> {
    let (geometry, theory) = (model.geometry, model.blank.theory);
    state.nodes.windows(2).map(move |pair| Reference::new(geometry, theory, pair[0], pair[1]))
}
