//! Estimates from a model alone.

use super::*;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::tool_sizes::{embosses, gap, mouth, shoulder_end, throat, widens};
pub(crate) use crate::rules::{siebel, tensile_strength};
use crate::solver::mesh;
use std::f64::consts::FRAC_PI_2;

/// Throat less punch \[mm\]; for a closed die or a punch that widens, the smallest gap after this travel \[mm\].
pub(crate) fn clearance(model: &Model, travel: f64) -> Option<f64> {
    let (punch, die) = (model.tool(Role::Punch)?, model.tool(Role::Die).filter(|_| !model.is_stretch_bent())?);
    let straight = throat(die).filter(|_| !widens(punch, travel));
    Some(straight.map_or_else(|| gap(punch, die, travel).0, |throat| throat - extent(punch).1))
}

pub(super) fn has_land(model: &Model) -> bool {
    model.tool(Role::Die).is_some_and(|die| die.profile.land().is_some())
}

pub(crate) fn draw_ratio(model: &Model) -> Option<f64> {
    let punch = model.tool(Role::Punch)?;
    let flat = model.blank.meridian.is_none();
    let drawn = flat && model.geometry == Geometry::Axisymmetric && model.blank.edge == Edge::Free && !embosses(model);
    let ratio = model.blank.length / mouth(punch, model.travel);
    (drawn && ratio > 1.0 && ratio.is_finite()).then_some(ratio)
}

/// Inner edge of the flat between holder and die \[mm\].
pub(crate) fn held_from(model: &Model) -> Option<f64> {
    Some(extent(model.tool(Role::Holder)?).0.max(shoulder_end(model.tool(Role::Die)?)))
}

/// Initial area between holder and the die's flat, of the whole section [mm², or mm² per mm of depth].
pub(crate) fn held_area(model: &Model) -> Option<f64> {
    let area = |r: f64| model.extent().area(r);
    let held = area(model.blank.length) - area(held_from(model)?);
    (held > 0.0).then_some(held)
}

/// The holder's largest force over the area that it presses on at the start [MPa].
pub(crate) fn holder_pressure(model: &Model) -> Option<f64> {
    let Motion::Pressed(press) = &model.tool(Role::Holder)?.motion else { return None };
    Some(press.force.largest() / held_area(model)?)
}

/// Tensile strength of the flange, as hot as its edge is at first \[MPa\].
pub(crate) fn flange_strength(model: &Model) -> f64 {
    let temperature = model.heat.as_ref().map_or(ROOM_TEMPERATURE, |heat| heat.initial.at(model.blank.length));
    let warm = model.material.thermal.map_or(1.0, |thermal| thermal.at(temperature));
    warm * model.material.load_maximum(1.0, temperature)[1]
}

pub(crate) fn siebel_pressure(model: &Model) -> Option<f64> {
    let diameter = 2.0 * mouth(model.tool(Role::Punch)?, model.travel);
    Some(siebel(draw_ratio(model)?, diameter, model.blank.thickness, flange_strength(model)))
}

pub(crate) struct CornerFit {
    pub role: Role,
    pub radius: f64,
    /// Initial element size there [mm].
    pub size: f64,
    pub per_quarter: f64,
}

pub(crate) fn coarsest_corner(model: &Model) -> Option<CornerFit> {
    let nodes = mesh::nodes(model);
    let acting = model.tools.iter().filter(|tool| tool.role != Role::Pad);
    let corners = acting.flat_map(|tool| tool.profile.corners().map(move |arc| (tool.role, arc)));
    let fits = corners.map(|(role, arc)| {
        let after = nodes.partition_point(|&r| r < arc.center.x).clamp(1, nodes.len() - 1);
        let size = nodes[after] - nodes[after - 1];
        CornerFit { role, radius: arc.radius, size, per_quarter: FRAC_PI_2 * arc.radius / size }
    });
    fits.min_by(|a, b| a.per_quarter.total_cmp(&b.per_quarter))
}

/// Force that keeps all beads closed \[N, or N/mm\].
pub(super) fn closing_of_beads(model: &Model) -> f64 {
    let force: f64 = model.beads.iter().map(|bead| bead.closing * bead.line(model.geometry)).sum();
    model.extent().times() * force
}
