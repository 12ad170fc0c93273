//! Closing of the holder on the die, over a bead that is drawn in their sections.

use super::Finding;
use crate::geometry::Arc;
use crate::model::tool_sizes::{flat_level, shoulder_end};
use crate::model::{Geometry, Model, Role, Tool};
use crate::solver::closing_way;
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Gap over the thickness that a holder may keep \[–\]: thickening of a flange that is drawn.
const OPEN: f64 = 0.1;

pub(super) fn closes(model: &Model) -> Option<Finding> {
    let text = "holder and die do not lie flat on the sheet: the holder closes over it by {} before the punch comes";
    Some(Finding::assumed(text).number(Amount::place(closing_way(model)?)))
}

/// Gap of the holder when the draw begins \[mm\], if it is too large.
pub(super) fn gap_left(stage: &StageSolution) -> Option<f64> {
    Some(stage.closing?.gap).filter(|gap| *gap > OPEN * stage.model.blank.thickness)
}

pub(super) fn stays_open(stage: &StageSolution) -> Option<Finding> {
    let gap = gap_left(stage)?;
    let force = Amount::force(stage.closing?.force, stage.model.extent().force_unit());
    let text = format!("the holder did not close: with {force} it stands open by {{}} when the draw begins");
    Finding::warning("holder_open", "Holder", text)
        .number(Amount::thickness(gap))
        .limit(format!("open by at most {} t", Amount::number(OPEN)))
        .advice(advice(&stage.model))
        .into()
}

pub(super) fn advice(model: &Model) -> String {
    let more = "more holder force, until it closes";
    match drawn(model) {
        Some(bead) => format!("{more}; or a flat holder and die with the bead as a line: {}", bead.line()),
        None => more.into(),
    }
}

pub(super) fn bead(model: &Model) -> Option<Finding> {
    let bead = drawn(model).filter(|_| closing_way(model).is_some())?;
    let around = match model.geometry {
        Geometry::Axisymmetric => "from the axis",
        Geometry::PlaneStrain => "from the symmetry plane",
    };
    let text =
        format!("the bead {{}} {around} closes with the holder; as a line on flat tools it would be {}", bead.line());
    Some(Finding::assumed(text).number(Amount::place(bead.at)))
}

impl DrawnBead {
    fn line(&self) -> String {
        format!(
            "[[tools.beads]] at = \"{}\", restraining = \"{} N/mm\" (declared: the work of bending over its radii)",
            Amount::place(self.at),
            Amount::number(self.restraining.round())
        )
    }
}

/// Height of a bead over the flat, over the thickness \[–\].
const STANDS_OUT: f64 = 0.25;
/// Effective stress and strain of plane strain over those of tension \[–\]: 2/√3.
const PLANE: f64 = 1.154_700_538_379_251_7;

#[derive(Clone, Copy, Debug, PartialEq)]
struct DrawnBead {
    /// Distance of its tip from the axis or symmetry plane \[mm\].
    at: f64,
    /// Estimated restraining force when closed, per length of its line \[N/mm\].
    restraining: f64,
}

/// Bead of the tool that stands out of its flat towards the sheet, on the die's flange.
///
/// The force is that of the work of plane bending and unbending over each convex corner of both tools on the flange, from the
/// edge inward, with the friction around it; the sheet hardens from each to the next, its thickness stays:
///
/// ```text
/// T ← (T + M/ρ) exp(μθ) + M/ρ,   M = 2/√3 σ t²/4,   ρ = R + t/2,   Δε = 2/√3 t/(4ρ) by each of the two
/// ```
///
/// Closed, the sheet goes round all of each corner. Declared: an elementary estimate, tried against the solver's own bead.
fn drawn(model: &Model) -> Option<DrawnBead> {
    let (holder, die) = (model.tool(Role::Holder)?, model.tool(Role::Die)?);
    let from = shoulder_end(die);
    let within = |x: f64| x > from && x < model.blank.length;
    let at = tip(holder, 1.0, within, model).or_else(|| tip(die, -1.0, within, model))?;
    let of = |tool: &Tool| {
        let friction = tool.friction.largest_coefficient();
        let corners =
            tool.profile.corners().filter(|arc| within(arc.center.x) && within(arc.at(0.0).x.min(arc.at(1.0).x)));
        corners.map(|arc| (arc, friction)).collect::<Vec<_>>()
    };
    let mut bends: Vec<(Arc, f64)> = [of(holder), of(die)].concat();
    bends.sort_by(|a, b| b.0.center.x.total_cmp(&a.0.center.x));
    let t = model.blank.thickness;
    let (mut tension, mut strain) = (0.0, 0.0);
    for (arc, friction) in bends {
        let rho = arc.radius + 0.5 * t;
        let mut bent = || {
            let step = PLANE * t / (4.0 * rho);
            strain += step;
            PLANE * model.material.hardening.at(strain - 0.5 * step).stress * t * t / (4.0 * rho)
        };
        tension = (tension + bent()) * (friction * arc.sweep.abs()).exp();
        tension += bent();
    }
    Some(DrawnBead { at, restraining: tension })
}

/// Tip of a bead \[mm\]; `up` is +1 for a tool below the sheet.
fn tip(tool: &Tool, up: f64, within: impl Fn(f64) -> bool, model: &Model) -> Option<f64> {
    let level = up * flat_level(tool)?;
    let points = tool.profile.polyline(0.01).into_iter().filter(|p| within(p.x));
    let tip = points.max_by(|a, b| (up * a.y).total_cmp(&(up * b.y)))?;
    (up * tip.y > level + STANDS_OUT * model.blank.thickness).then_some(tip.x)
}
