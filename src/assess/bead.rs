//! A draw bead that is drawn in the sections of holder and die: where it is, and what it holds the sheet back with.

use crate::geometry::Arc;
use crate::model::tool_sizes::{flat_level, shoulder_end};
use crate::model::{Model, Role, Tool};

/// How far a bead stands out of the flat, over the thickness \[–\].
const STANDS_OUT: f64 = 0.25;
/// Effective stress and strain of plane strain over those of tension \[–\]: 2/√3.
const PLANE: f64 = 1.154_700_538_379_251_7;

/// A bead that is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DrawnBead {
    /// Distance of its tip from the axis or symmetry plane [mm].
    pub at: f64,
    /// Estimate of what it holds the sheet back with, closed, per length of its line [N/mm].
    pub restraining: f64,
}

/// The bead of the tool that stands out of its flat towards the sheet, on the die's flange; `None` where none does.
///
/// The force is that of the work of plane bending and unbending over each convex corner of both tools on the flange, from the
/// edge inward, with the friction around it; the sheet hardens from each to the next, its thickness stays:
///
/// ```text
/// T ← (T + M/ρ) exp(μθ) + M/ρ,   M = 2/√3 σ t²/4,   ρ = R + t/2,   Δε = 2/√3 t/(4ρ) by each of the two
/// ```
///
/// Closed, the sheet goes round all of each corner. Declared: an elementary estimate, tried against the solver's own bead.
pub(crate) fn drawn(model: &Model) -> Option<DrawnBead> {
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

/// Where a tool stands out most towards the sheet, `up` being +1 for one below it \[mm\].
fn tip(tool: &Tool, up: f64, within: impl Fn(f64) -> bool, model: &Model) -> Option<f64> {
    let level = up * flat_level(tool)?;
    let points = tool.profile.polyline(0.01).into_iter().filter(|p| within(p.x));
    let tip = points.max_by(|a, b| (up * a.y).total_cmp(&(up * b.y)))?;
    (up * tip.y > level + STANDS_OUT * model.blank.thickness).then_some(tip.x)
}
