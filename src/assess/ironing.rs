//! Whether two tools iron the wall between them, and by how much.

use super::run::Run;
use super::{Finding, Light};
use crate::assess::design::IRONING_LIMIT;
use crate::table::Unit;
use crate::units::Amount;

/// Reduction of the thickness above which a wall counts as ironed \[–\].
const IRONED: f64 = 0.01;

/// Reduction of the thickness in the stage that irons most, where, and the force and the pressure that go with it.
pub(super) fn judge(run: &Run) -> Option<Finding> {
    let most = run.steps().max_by(|a, b| a.ironing.total_cmp(&b.ironing))?;
    let light = Light::of(most.ironing, [IRONED, IRONING_LIMIT]);
    let found = match run.steps().find(|step| step.ironing > IRONED) {
        None => "no wall is ironed between two tools".into(),
        Some(first) => format!(
            "wall ironed by {share} between two tools at s0 = {s0}, from {travel} of travel, with up to {pressure}",
            share = Amount::share(most.ironing),
            s0 = Amount::place(most.ironing_s0),
            travel = Amount::place(first.travel),
            pressure = Amount::stress(run.largest(|step| step.ironing_pressure)?)
        ),
    };
    Some(
        Finding::judged("ironing", "Ironing", light, found)
            .against(
                100.0 * most.ironing,
                Unit::Percent,
                format!("{share} in one pass", share = Amount::given_share(IRONING_LIMIT)),
            )
            .at_most(100.0 * IRONED, 100.0 * IRONING_LIMIT)
            .source("a die for one pass is laid out for less (Chin. J. Mech. Eng. 2022, 10.1186/s10033-022-00681-9)")
            .advice(
                "a wall that is not to be ironed wants a clearance of t √β, the thickness of the rim (4ming); a throat drawn \
                 straight on rubs all along it: draw the land as long as it is; the penalty leaves the wall thicker than the \
                 gap by up to twice the penetration: a larger solver.contact_stiffness",
            ),
    )
}
