//! A solved case, coarser while a slider moves.

use crate::film::Recorder;
use crate::stage;
use serde_json::{Value, json};
use stampflow::assess::{self, Answer, Kind, judgements, sentences};
use stampflow::case::Case;
use stampflow::model::{Geometry, Grading, Model};
use stampflow::units::Quantity;

/// Fewest elements of a coarse run.
const FEWEST: usize = 20;

/// Halves the elements, doubles the steps, and ends iterations early: an eighth of them, for a force that moves by 3e-5.
fn coarsen(Model { blank, settings, .. }: &mut Model) {
    if blank.grading == Grading::Radii {
        blank.grading = Grading::Divided { of: blank.elements };
    }
    blank.elements = (blank.elements / 2).max(FEWEST.min(blank.elements));
    settings.max_step = (2.0 * settings.max_step).min(1.0);
    settings.first_step = (2.0 * settings.first_step).min(settings.max_step);
    settings.strain_step *= 2.0;
    settings.tolerance = settings.tolerance.max(1e-3);
}

/// Solves a case and judges it.
pub fn solve(mut case: Case, is_coarse: bool) -> Value {
    if is_coarse {
        case.stages.iter_mut().for_each(|stage| coarsen(&mut stage.model));
    }
    let mut recorder = Recorder::default();
    let solution = case.solve(&mut recorder);
    let (case, solved) = (&solution.case, &solution.stages);
    let before = assess::before(case);
    let findings = assess::after(case, solved);
    let stages = case.stages.iter().zip(solved).zip(recorder.0);
    let stages: Vec<Value> = stages.map(|((stage, solved), frames)| stage::json(&stage.name, solved, frames)).collect();
    let notes = |kind| -> Vec<String> {
        let all = sentences(&before, kind).into_iter().chain(sentences(&findings, kind));
        all.map(|sentence| sentence.to_string()).collect()
    };
    let answer = Answer::of(case, solved, &findings);
    let number = |number: &Quantity| json!({ "key": number.key, "label": number.name.as_deref().unwrap_or(number.label), "text": number.amount.to_string(), "about": number.place });
    json!({
        "title": case.model().title,
        "text": case.text,
        "isRound": case.model().geometry == Geometry::Axisymmetric,
        "stages": stages,
        "verdict": {
            "light": answer.light,
            "sentence": answer.sentence,
            "end": answer.end,
            "numbers": answer.numbers.iter().map(number).collect::<Vec<_>>(),
            "rows": judgements(&findings).collect::<Vec<_>>(),
            "warnings": notes(Kind::Warning),
            "notes": notes(Kind::Assumption),
        },
    })
}
