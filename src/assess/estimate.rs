//! Estimates from a model alone.

use crate::geometry::Point;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::tool_sizes::{extent, gap, mouth, shoulder_end, throat, widens};
use crate::model::{Edge, Geometry, Model, Motion, Role, mesh};
pub(crate) use crate::rules::{siebel, tensile_strength};
use std::f64::consts::{FRAC_PI_2, PI};

/// Throat less punch \[mm\]; for a closed die or a punch that widens, the smallest gap at the full travel.
pub(crate) fn clearance(model: &Model) -> Option<f64> {
    let (punch, die) = (model.tool(Role::Punch)?, model.tool(Role::Die)?);
    let closed = || gap(punch, die, model.travel).0;
    let straight = throat(die).filter(|_| !widens(punch, model.travel));
    Some(straight.map_or_else(closed, |throat| throat - extent(punch).1))
}

/// Blank over the punch's [`mouth`], where a blank is drawn in over a punch that is smaller.
pub(crate) fn draw_ratio(model: &Model) -> Option<f64> {
    let punch = model.tool(Role::Punch)?;
    // A punch and a die with a bottom, both as wide as the blank, emboss it.
    let embossed =
        model.tool(Role::Die).is_some_and(|die| throat(die).is_none()) && extent(punch).1 >= model.blank.length;
    let drawn = model.geometry == Geometry::Axisymmetric && model.blank.edge == Edge::Free && !embossed;
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
    match &model.tool(Role::Holder)?.motion {
        Motion::Pressed(press) => Some(press.force.largest() / held_area(model)?),
        _ => None,
    }
}

/// Tensile strength of the flange, as hot as its edge is at first \[MPa\].
pub(crate) fn flange_strength(model: &Model) -> f64 {
    let temperature = model.heat.as_ref().map_or(ROOM_TEMPERATURE, |heat| heat.initial.at(model.blank.length));
    let warm = model.material.thermal.map_or(1.0, |thermal| thermal.at(temperature));
    warm * model.material.load_maximum(1.0, temperature)[1]
}

/// [`siebel`]'s pressure for the blank and the punch of a model.
pub(crate) fn siebel_pressure(model: &Model) -> Option<f64> {
    let diameter = 2.0 * mouth(model.tool(Role::Punch)?, model.travel);
    Some(siebel(draw_ratio(model)?, diameter, model.blank.thickness, flange_strength(model)))
}

/// Angle of the edge on the die's shoulder when a sheet of constant area leaves the die \[rad\]; declared, above 45° because
/// the rim thickens.
const LEFT: f64 = PI / 3.0;

/// Area of the part as its edge leaves the die's shoulder, over the blank's \[–\]; above 1 the blank is drawn through.
pub(crate) fn drawn_share(model: &Model) -> Option<f64> {
    let (punch, die) = (model.tool(Role::Punch)?, model.tool(Role::Die)?);
    let points = punch.profile.polyline(0.02);
    let top = points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max);
    let end = shoulder_end(die);
    let shoulder = end - throat(die).unwrap_or(end);
    let bottom = top - model.travel + shoulder * (1.0 - LEFT.cos());
    let (mut used, mut reached) = (0.0, 0.0);
    for (a, b) in points.iter().zip(&points[1..]).filter(|(a, _)| a.y > bottom) {
        let share = if b.y < bottom { (a.y - bottom) / (a.y - b.y) } else { 1.0 };
        let end: Point = a + share * (b - a);
        let width = match model.geometry {
            Geometry::Axisymmetric => PI * (a.x + end.x),
            Geometry::PlaneStrain => 1.0,
        };
        used += width * (end - a).norm();
        reached = end.x;
    }
    let rest = model.geometry.area(end - shoulder * LEFT.sin()) - model.geometry.area(reached);
    // A punch as wide as the blank draws nothing in.
    if reached >= model.blank.length {
        return None;
    }
    Some((used + rest) / model.geometry.area(model.blank.length))
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
    let corners = model.tools.iter().flat_map(|tool| tool.profile.corners().map(move |arc| (tool.role, arc)));
    let fits = corners.map(|(role, arc)| {
        let after = nodes.partition_point(|&r| r < arc.center.x).clamp(1, nodes.len() - 1);
        let size = nodes[after] - nodes[after - 1];
        CornerFit { role, radius: arc.radius, size, per_quarter: FRAC_PI_2 * arc.radius / size }
    });
    fits.min_by(|a, b| a.per_quarter.total_cmp(&b.per_quarter))
}

/// Reference: with sharp corners the part is a cylinder of known area, drawn through if its area is the blank's.
#[cfg(test)]
#[test]
fn drawn_share_is_the_area_of_a_sharp_cup() {
    let sharp = ["tools.punch.flat.nose=0.01 mm", "tools.die.shoulder=0.01 mm"].map(str::to_owned);
    let case = crate::case::load("cases/quickstart.toml", &sharp).expect("valid");
    let cup = 30.0 * 30.0 + 2.0 * 30.0 * 25.0 + 31.26 * 31.26 - 30.0 * 30.0;
    approx::assert_relative_eq!(drawn_share(case.model()).unwrap(), cup / (55.0 * 55.0), epsilon = 1e-3);
}
