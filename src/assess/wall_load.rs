//! How far a wall that is drawn against a holder is from yielding as a whole, which is what straightens it.

use crate::measure::Shape;
use crate::model::Model;
use crate::solver::solution::Frame;
use crate::units::{Amount, joined};

/// What tension does for the spring-back of a wall, with the share of its yield load that it carries under the tools.
pub(super) fn advice(model: &Model, frame: &Frame, shape: &Shape) -> String {
    let carried = share(model, frame, shape).map_or_else(String::new, |share| {
        format!("(the wall carries {share} of it, and is straight from about 100 % on)", share = Amount::share(share))
    });
    let tension = "smaller radii spring back less; more tension in the walls (holder force, beads) helps only as it nears the \
                   load at which the whole wall yields";
    joined([tension.into(), carried], " ")
}

/// The wall's mean tension over the one at which all of its thickness yields \[–\]: the largest along it, for the tension
/// falls by friction only.
fn share(model: &Model, frame: &Frame, shape: &Shape) -> Option<f64> {
    let nodes = shape.wall.as_ref()?.nodes.clone();
    let weights: Vec<f64> = frame.through.layers.iter().map(|layer| layer.weight).collect();
    let total: f64 = weights.iter().sum();
    // A wall does not strain across its section: the stress along it is then larger than the yield stress.
    let material = &model.material;
    let across = material.yield_criterion.equivalent_stress([1.0, material.yield_criterion.plane_strain_ratio(), 0.0]);
    let of = |e: usize| {
        let (element, points) = (frame.elements.get(e)?, frame.through.elements().nth(e)?);
        let yields = |strain: f64| material.yield_stress(strain, element.temperature);
        let limit: f64 =
            points.iter().zip(&weights).map(|(point, weight)| weight * yields(point.strain_equivalent)).sum();
        Some(element.stress_meridional * across * total / limit)
    };
    (nodes.start..nodes.end.saturating_sub(1)).filter_map(of).reduce(f64::max).filter(|share| *share > 0.0)
}
