//! Where a condition ends, where a number has a value, and the best of several keys.

use super::attend::{Line, Progress, attended};
use super::case::Case;
use super::error;
use super::rows::{Rows, Table};
use super::solution::Solution;
use super::study::{Told, form, found, threads, told};
use pyo3::prelude::*;
use stampflow::output::study::json;
use stampflow::output::study::search::{plot, plot_best};
use stampflow::study::search::{Asked, Sense, Side, Wish};
use stampflow::study::verify::{Verification, Watch, quick};
use stampflow::study::{Row, StudyError, Subject};

/// Keys and spans; a template; whether the largest is wanted, or the smallest; a condition, a target, a tolerance.
type Limit = (Vec<String>, Option<String>, Option<bool>, Option<String>, Option<String>, Option<String>);

/// Keys and spans; a number, and whether its most is wanted, or its least; a condition.
type Extreme = (Vec<String>, String, bool, Option<String>);

/// What was found, every run, the case of the answer with its solution, and the exception that cut it short.
type Searched<'py> = (Told<'py>, Table<'py>, Option<(Case, Solution)>, Option<PyErr>);

/// Where a condition ends, or where a number has a value; the answer's run with error bars where they are wanted.
#[pyfunction]
pub fn search<'py>(
    py: Python<'py>,
    case: &Case,
    limit: Limit,
    error_bars: bool,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<Searched<'py>> {
    let (vary, template, largest, condition, target, tolerance) = limit;
    let side = largest.map(|largest| if largest { Side::Largest } else { Side::Smallest });
    let asked = Asked { vary, template, side, condition, target, tolerance };
    let quest = case.subject().and_then(|subject| asked.quest(subject)).map_err(|error| error::of_study(py, &error))?;
    let (result, mut raised) = attended(py, progress, |line| {
        let answer = quest.search(self::threads(threads), line)?;
        let best = answer.best.map(|best| &answer.rows[best]);
        let solved = solved(&quest.subject, best, error_bars, line)?;
        Ok::<_, StudyError>((answer, solved))
    });
    let (answer, solved) = found(py, result, &mut raised)?;
    let bars = solved.as_ref().and_then(|(_, bars)| bars.as_ref());
    let sentences = [quest.sentence(&answer)].into_iter().chain(quest.sentences(&answer, bars));
    let pictures = plot(&quest, &answer, form()).map(|chart| ("search", chart));
    let told = told(py, &json::found(&quest, &answer, bars), sentences, pictures);
    let headers = quest.span.keys().iter().map(|key| key.header()).collect();
    Ok((told, table(py, headers, answer.rows), handed(&quest.subject, solved), raised))
}

/// The least or the most of a number over several keys.
#[pyfunction]
pub fn optimise<'py>(
    py: Python<'py>,
    case: &Case,
    extreme: Extreme,
    error_bars: bool,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<Searched<'py>> {
    let (vary, number, most, condition) = extreme;
    let sense = if most { Sense::Most } else { Sense::Least };
    let wish = case.subject().and_then(|subject| Wish::read(subject, &vary, (&number, sense), condition.as_deref()));
    let wish = wish.map_err(|error| error::of_study(py, &error))?;
    let (result, mut raised) = attended(py, progress, |line| {
        let best = wish.search(self::threads(threads), line)?;
        let solved = solved(&wish.subject, best.best.map(|run| &best.rows[run]), error_bars, line)?;
        Ok::<_, StudyError>((best, solved))
    });
    let (best, solved) = found(py, result, &mut raised)?;
    let bars = solved.as_ref().and_then(|(_, bars)| bars.as_ref());
    let sentences = [wish.sentence(&best)].into_iter().chain(best.sentences());
    let picture = plot_best(&wish.spans, &wish.number, wish.condition.as_ref(), &best, form());
    let told = told(py, &json::best(&wish, &best, bars), sentences, picture.map(|chart| ("search", chart)));
    let headers = wish.spans.iter().flat_map(|span| span.keys()).map(|key| key.header()).collect();
    Ok((told, table(py, headers, best.rows), handed(&wish.subject, solved), raised))
}

/// The answer's case solved wholly; nothing where there is no answer, or it is to stop.
fn solved(
    subject: &Subject,
    row: Option<&Row>,
    error_bars: bool,
    line: &Line<'_>,
) -> Result<Option<(stampflow::case::Solution, Option<Verification>)>, StudyError> {
    let Some(row) = row.filter(|_| !line.wants_to_stop()) else { return Ok(None) };
    let solution = Subject::solution(subject.case(&row.design.settings)?, &Silent(line));
    let solution = solution.map_err(|what| StudyError::Asked { what, help: "try to solve the case".into() })?;
    let bars = error_bars.then(|| quick(&solution, &Silent(line)));
    Ok(Some((solution, bars)).filter(|_| !line.wants_to_stop()))
}

/// Ends with a line, and counts no runs on it.
struct Silent<'a>(&'a Line<'a>);

impl Watch for Silent<'_> {
    fn wants_to_stop(&self) -> bool {
        self.0.wants_to_stop()
    }
}

fn handed(of: &Subject, solved: Option<(stampflow::case::Solution, Option<Verification>)>) -> Option<(Case, Solution)> {
    let (solution, bars) = solved?;
    Some((Case::made(of, solution.case.clone()), Solution::verified(solution, bars)))
}

fn table(py: Python<'_>, headers: Vec<String>, rows: Vec<Row>) -> Table<'_> {
    let mut all = Rows::of(headers);
    rows.into_iter().for_each(|row| all.push(row));
    all.table(py)
}
