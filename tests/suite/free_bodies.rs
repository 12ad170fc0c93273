//! Tools as free bodies: what they do to the sheet is in balance.

use crate::common::prelude::*;

/// Trust: nothing else holds a sheet with a free edge up, so that the forces of all tools along z sum to nothing, to what the
/// corrector leaves: velocities within 1e-5, the residual then within 0.1 % of the largest force.
#[test]
fn the_tools_of_every_stage_hold_the_sheet_in_balance() {
    let made = TEMPLATES.iter().map(|template| made(template.name, &[], &[]));
    let shipped = ["quickstart", "chalmers_cup", "stages_cup", "strip_draw"];
    let mut judged = 0;
    for case in made.chain(shipped.map(|name| shipped_case(name, &[]))) {
        let run = solved_once(&case);
        for (i, stage) in run.stages.iter().enumerate() {
            let model = &stage.model;
            let is_alone = model.blank.edge == Edge::Free && model.blank.meridian.is_none() && model.gas.is_empty();
            if !is_alone || model.release.is_some() || !stage.end.unloading.is_empty() {
                continue;
            }
            let largest = stage.tool_forces.iter().flatten().map(|force| force.abs()).fold(0.0, f64::max);
            for (step, forces) in stage.steps.iter().zip(&stage.tool_forces) {
                let (sum, at) = (forces.iter().sum::<f64>(), (&model.title, i, step.travel));
                assert!(sum.abs() <= 1e-3 * largest, "{at:?}: {sum} of {largest}");
                judged += 1;
            }
        }
    }
    assert!(judged > 1500, "{judged}");
}
