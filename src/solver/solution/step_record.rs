//! What is kept of every step: its forces, works and shares, and what tells the run's health.

use super::{Energy, Heat};
use crate::model::PressureCap;

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
