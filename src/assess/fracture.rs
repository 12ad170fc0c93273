//! Ductile fracture, by the criterion and the constants of the case.

use super::*;

/// Share of the critical value above which scatter of metal and process may reach it \[–\].
const CAREFUL: f64 = 0.9;
/// Difference of damage through the thickness up to which no face is named, over the largest \[–\].
const EVEN: f64 = 0.05;

pub(super) fn reached(stage: &StageSolution) -> Option<&StepRecord> {
    stage.steps.iter().find(|step| step.damage >= 1.0)
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let criterion = run.case.model().material.fracture?;
    let (i, damage, at) =
        run.peak(|_, stage| stage.steps.iter().map(|step| (step.damage, step)).max_by(|a, b| a.0.total_cmp(&b.0)))?;
    let stage = &run.stages[i];
    let place = joined([tear::place(&run.stages[..=i], at.damage_s0), face(stage, at.damage_s0).into()], ", ");
    let uses = format!("uses {{}} of the critical value {place}");
    let first = formed(run.stages).find_map(|(i, stage)| Some((i, reached(stage)?)));
    let breaks = first.map_or_else(String::new, |(i, step)| {
        run.of_stage(format!("reached at {}", instant(&run.stages[i], step.travel, step.time)), i)
    });
    let assumed = "the case's constants, assumed: no source is given; the share is declared";
    let source = run.case.sources.fracture.as_deref().unwrap_or(assumed);
    let judged = Finding::judged("fracture", "Fracture", joined([uses, breaks], "; ")).number(Amount::share(damage));
    let limit = format!("{criterion}, near it from {}", Amount::given_share(CAREFUL));
    Some(judged.at_most(100.0 * CAREFUL, 100.0).limit(limit).source(source))
}

fn face(stage: &StageSolution, s0: f64) -> &'static str {
    let (state, rule) = (&stage.end, stage.model.blank.points());
    let nearest = |a: &usize, b: &usize| (state.middle(*a) - s0).abs().total_cmp(&(state.middle(*b) - s0).abs());
    let Some(e) = (0..state.thickness.len()).min_by(nearest) else { return "" };
    let (largest, xi) = state.damage(e, &rule);
    let least = state.points.row(e).iter().map(|point| point.damage).fold(largest, f64::min);
    match xi {
        _ if largest - least <= EVEN * largest => "through the whole thickness",
        xi if xi > 0.0 => "on the punch's face",
        _ => "on the die's face",
    }
}
