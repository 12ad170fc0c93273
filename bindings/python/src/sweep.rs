//! One case with many settings, on all cores.

use super::attend::{Progress, attended};
use super::designs::{Part, Ran, Written};
use super::error;
use super::rows::Table;
use super::study::{Of, Told, form, found, threads, told};
use pyo3::prelude::*;
use stampflow::output::study::{json, pictures};
use stampflow::study::{self, Columns, Designs, How, Plan, Results, Said, StudyError, Vary, file};

/// So many designs at most are told and drawn: more are no picture, and their lines would fill the memory.
const TOLD: u64 = 100_000;

/// How many values each axis has, nothing where each is varied by itself; what is said of a sweep that is whole, what came of
/// the designs in their order, and the exception that cut it short.
type Swept<'py> = (Option<Vec<usize>>, Option<Told<'py>>, Table<'py>, Option<PyErr>);

/// Runs every combination of what is varied, or each key by itself.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // a name for each where it is called from
pub fn sweep<'py>(
    py: Python<'py>,
    of: Of<'py>,
    axes: Vec<String>,
    one_at_a_time: bool,
    error_bars: Option<bool>,
    part: Part,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<Swept<'py>> {
    let wrong = |error: StudyError| error::of_study(py, &error);
    let plan = plan(of, &axes).map_err(wrong)?;
    let plan = if one_at_a_time { plan.made(How::OneAtATime) } else { plan };
    part.indices(&plan).map_err(wrong)?;
    let bars = plan.bars(error_bars);
    let (result, mut raised) = attended(py, progress, |line| {
        let base = study::base(plan.subject(), bars, line)?;
        let columns = Columns::of(&plan, &base);
        let written = Written {
            stem: "study",
            columns: &columns,
            header: columns.header(),
            line: &|row| columns.line(&plan, row),
            is_told: plan.count() <= TOLD,
            has_times: true,
        };
        let ran = part.run(&plan, written, self::threads(threads), bars, line)?;
        Ok::<_, StudyError>((base, ran))
    });
    let (base, Ran { rows, whole }) = found(py, result, &mut raised)?;
    let whole = whole.filter(|_| plan.count() <= TOLD);
    let results = whole.map(|(table, shown)| Results::of(&table[..], &shown, &plan, &base)).transpose();
    let said = results.map_err(wrong)?.map(|results| {
        let said = Said::of(&results);
        let case = plan.subject().case(&[]).map_err(|error| error::of_case(py, &error))?;
        let drawn = pictures(&results, &case.model().title, form());
        Ok::<_, PyErr>(told(py, &json::sweep(&results, &said, form()), said.sentences(&results), drawn))
    });
    let shape = plan.axes().iter().map(|axis| axis[0].values.len()).collect();
    Ok(((plan.how() == How::Combined).then_some(shape), said.transpose()?, rows.table(py), raised))
}

fn plan(of: Of<'_>, axes: &[String]) -> Result<Plan, StudyError> {
    let axes = axes.iter().map(|axis| Vary::together(axis)).collect::<Result<Vec<_>, _>>()?;
    match of {
        Of::Case(case) => Plan::of(case.subject()?, axes),
        Of::File(path, settings) if axes.is_empty() => file::load(&path, settings),
        Of::File(path, settings) => Plan::new(path, settings, axes),
    }
}
