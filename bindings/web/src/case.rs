//! A case solved: as it is, or coarser while a slider moves.

use crate::film::Film;
use crate::json::{Numbers, Value, table};
use crate::question::{Failure, Question};
use crate::{answer, stage};
use stampflow::assess::{self, Answer};
use stampflow::case::files::Memory;
use stampflow::case::{Case, parse_with};
use stampflow::study::verify::Direction;

/// How fine a coarse run is in every direction \[–\].
const COARSE: f64 = 0.5;

/// The case of a question: its text, the settings that replace what it says, and the files beside it.
pub fn case(question: &Question) -> Result<Case, Failure> {
    let mut files = Memory::default();
    for (path, text) in question.table("files") {
        files.insert(path, text);
    }
    let overrides: Vec<String> = question.all("overrides").map(str::to_owned).collect();
    let name = Some(question.text("name")).filter(|name| !name.is_empty()).unwrap_or("case.toml");
    Ok(parse_with(question.text("text"), name, &overrides, &files)?)
}

/// What comes of the case, coarser where the question says so.
pub fn solve(question: &Question, numbers: &mut Numbers) -> Result<Value, Failure> {
    let form = question.form();
    let mut case = case(question)?;
    let is_coarse = question.is("coarse");
    if let Some(coarser) = is_coarse.then(|| Direction::Together.refined(&case.stages, COARSE)).flatten() {
        case.stages = coarser;
    }
    let mut film = Film::default();
    let solution = case.solve(&mut film);
    let (case, solved) = (&solution.case, &solution.stages);
    let findings = if is_coarse { assess::after_one_of_many(case, solved) } else { assess::after(case, solved) };
    let verdict = Answer::of(case, solved, &findings);
    let stages = case.stages.iter().zip(solved).zip(film.0);
    let stages: Vec<Value> =
        stages.map(|((stage, solved), strip)| stage::json(&stage.name, solved, strip, form, numbers)).collect();
    Ok(table! {
        "title": case.model().title.as_str(),
        "text": case.text.as_str(),
        "isRound": case.model().geometry == stampflow::model::Geometry::Axisymmetric,
        "isCoarse": is_coarse,
        "isComplete": solution.is_complete(),
        "stages": stages,
        "verdict": answer::json(&verdict, &findings, &assess::before(case), form),
    })
}
