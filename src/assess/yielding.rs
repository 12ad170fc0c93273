//! How much of the sheet yields again, the other way, while its tools are taken away.

use super::Finding;
use crate::model::Mode;
use crate::solver::solution::StageSolution;
use crate::units::Amount;

/// Plastic strain, or stress over the yield stress, from which a point has yielded again \[–\].
const YIELDED: f64 = 1e-4;
/// Share of the sheet that is worth a word \[–\].
const LEAST: f64 = 1e-3;

/// The share of the sheet's volume; by D(E, ν) alone that is where the stress that is left lies beyond the yield stress.
pub(super) fn again(stage: &StageSolution) -> Option<Finding> {
    let (model, end) = (&stage.model, &stage.end);
    model.release?;
    let before = &stage.start.as_ref()?.through.points;
    let layers = model.blank.points();
    let (mut volume, mut total) = (0.0, 0.0);
    for (i, (point, before)) in end.points.iter().zip(before).enumerate() {
        let e = i / layers.len();
        let share = end.volume[e] * layers[i % layers.len()].weight;
        let limit = model.material.yield_stress(point.strain, end.temperature[e]);
        let beyond = model.mode != Mode::ElastoViscoplastic
            && model.material.yield_criterion.equivalent_stress(point.stress) > limit * (1.0 + YIELDED);
        total += share;
        volume += if beyond || point.strain - before.strain_equivalent > YIELDED { share } else { 0.0 };
    }
    let share = volume / total;
    let found = match model.mode {
        Mode::Elastic => format!(
            "{share} of the sheet would yield again as the tools are taken away, which elasticity alone leaves out",
            share = Amount::share(share)
        ),
        _ => format!("{share} of the sheet yields again as the tools are taken away", share = Amount::share(share)),
    };
    (share > LEAST).then(|| Finding::warning("yields_again", "Unloading", found).share(share, LEAST))
}
