//! Record of every step: forces, work, shares and measures of the solution's quality.

use super::{Energy, Heat};
use crate::model::{Blank, PressureCap, Role};

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
    /// Force of the pad on the sheet towards the punch \[N, or N/mm\].
    pub pad_force: f64,
    /// Outward radial force of the held edge, both edges of a plane section \[N, or N/mm\]; 0 for a free edge.
    pub edge_force: f64,
    /// Draw-in: inward move of the blank's edge \[mm\].
    pub draw_in: f64,
    /// Clear diameter of the hole, between its inner faces \[mm\]; 0 without one.
    pub hole: f64,
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
    /// Share of the sheet's current area inside the gas's seal that lies on the punch or the die \[–\].
    pub contact_share: f64,
    /// Gaps between the sheet's edge and the tools of [`Role::ALL`](crate::model::Role::ALL) \[mm\]; infinite without the tool.
    pub edge_gap: [f64; Role::ALL.len()],
    /// Gaps between the sheet's middle and the same tools \[mm\].
    pub middle_gap: [f64; Role::ALL.len()],
    /// Slope of the die's face nearest to the sheet's edge \[rad\]: 0 flat, π/2 in the throat.
    pub die_slope: f64,
    /// Move of the holder towards the die from where it touched the flat sheet \[mm\]; negative when lifted.
    pub holder_move: f64,
    /// Force of the holder on its distance blocks \[N, or N/mm\].
    pub block_force: f64,
    /// Largest penetration of a tool over the sheet's thickness \[–\].
    pub penetration: f64,
    /// Largest thickness reduction by ironing in this stage, 1 − exp(−ε) \[–\], while two tools press both faces.
    pub ironing: f64,
    /// Initial distance of that element from the axis \[mm\].
    pub ironing_s0: f64,
    /// Force of the die on the ironed elements against the punch travel \[N, or N/mm\], friction included.
    pub ironing_force: f64,
    /// Friction part of it \[N, or N/mm\].
    pub ironing_friction: f64,
    /// Largest pressure of a tool on an ironed element \[MPa\].
    pub ironing_pressure: f64,
    /// Largest tearing index of an element \[–\].
    pub tearing_index: f64,
    /// Initial distance of that element from the axis \[mm\].
    pub tearing_s0: f64,
    /// Meridional force that it carries, and the one at which it tears \[N/mm\].
    pub tearing_forces: [f64; 2],
    /// Share of the holder's force on the outermost [`StepRecord::RIM`] thicknesses of the blank \[–\].
    pub rim_share: f64,
    /// Share of the points in contact that slide slower than the regularisation speed \[–\].
    pub sticking: f64,
    /// Pairs of point and tool that came into contact or left it in the step.
    pub contact_changes: usize,
    /// Largest equivalent strain increment of the step at a thickness point \[–\].
    pub strain_increment: f64,
    /// Thickness over the smallest bending radius of the mid-surface \[–\]; 0 while the sheet is flat.
    pub sharpest_bend: f64,
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
    /// Initial distance from the axis of the largest porosity \[mm\].
    pub porous_s0: f64,
    /// Largest damage of ductile fracture over its critical value, faces included \[–\].
    pub damage: f64,
    /// Initial distance from the axis of the largest damage \[mm\].
    pub damage_s0: f64,
    /// Lowest temperature of an element \[K\].
    pub coldest: f64,
    /// Highest temperature of an element \[K\].
    pub hottest: f64,
    /// Heat since the start.
    pub heat: Heat,
}

impl StepRecord {
    /// Diameter of the edge that may be widened \[mm\]: clear, of a hole; of the mid-surface, at the end of a sheet that is not flat.
    pub fn edge_diameter(&self, blank: &Blank) -> f64 {
        if blank.meridian.is_some() { 2.0 * (blank.edge_radius() - self.draw_in) } else { self.hole }
    }

    /// Its expansion \[–\].
    pub fn edge_expansion(&self, blank: &Blank) -> f64 {
        self.edge_diameter(blank) / (2.0 * blank.widened_radius()) - 1.0
    }

    /// Width of the rim over the initial thickness \[–\].
    pub const RIM: f64 = 3.0;
}
