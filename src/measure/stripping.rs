//! Stripping force of a cup that clings to its punch.
//!
//! ```text
//! F = Σ A p (μ cos α − sin α),   α < arctan μ
//! ```
//!
//! over the contact points of the punch, with area A, pressure p and slope α of the sheet to the axis: a wall within the friction
//! angle sticks, what slopes more is pushed off. Derived here from Coulomb's friction. Declared: the wall keeps the pressure of
//! the last step. A rigid-plastic sheet has no pressure without its load, so this is of elastic sheets only.

use crate::element::{kinematics::Reference, surface::STATIONS};
use crate::model::{Geometry, Mode, Role};
use crate::solver::solution::StageSolution;

/// Force that pulls the punch of an axisymmetric elastic sheet out at the end of a stage \[N\].
pub fn stripping_force(stage: &StageSolution) -> Option<f64> {
    let (model, end) = (&stage.model, &stage.end);
    let is_round = model.geometry == Geometry::Axisymmetric && model.mode != Mode::Flow;
    let punch = model.tool_index(Role::Punch).filter(|_| is_round && model.release.is_none())?;
    let (friction, pressures) = (model.tools[punch].friction.largest_coefficient(), end.pressure.row(punch));
    let of_element = |(e, pressures): (usize, &[f64])| {
        let along = end.along(e);
        let clings = (friction * along.y.abs() - along.x.abs()) / along.norm();
        let element = Reference::new(model.geometry, model.blank.theory, end.nodes[e], end.nodes[e + 1]);
        let load: f64 = pressures.iter().zip(element.contact_areas()).map(|(pressure, area)| pressure * area).sum();
        clings.max(0.0) * load
    };
    Some(pressures.chunks(STATIONS).enumerate().map(of_element).sum())
}
