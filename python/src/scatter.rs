//! How sure a verdict is when coil, friction, thickness and press scatter.

use super::attend::{Progress, attended};
use super::case::Case;
use super::error;
use super::rows::{Rows, Table};
use super::study::{Told, form, found, threads, told};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::output::study::{json, scatter_pictures};
use stampflow::study::scatter::{Asked, Band, Base, Correlation, Factor, Found, POINTS, SEED, Sample, Scatter};
use stampflow::study::{self, Bars, Designs, StudyError};
use std::convert::Infallible;

/// Points of the sample, its seed, and whether Sobol indices are wanted.
type Size = (Option<u64>, Option<u32>, bool);

/// Where, the quantiles there, and how many runs come there.
type BandParts<'py> = (Bound<'py, PyArray1<f64>>, Vec<Bound<'py, PyArray1<f64>>>, Vec<usize>);

/// What the sample says, and its bands of load and thickness; nothing of a sample that was cut short.
type Said<'py> = (Told<'py>, Option<BandParts<'py>>, Option<BandParts<'py>>);

/// Runs a sample of what scatters.
#[pyfunction]
#[allow(clippy::too_many_arguments)] // a name for each where it is called from
pub fn scatter<'py>(
    py: Python<'py>,
    case: &Case,
    vary: Vec<String>,
    correlate: Vec<String>,
    size: Size,
    name: &str,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<(Option<Said<'py>>, Table<'py>, Option<PyErr>)> {
    let scatter = asked(case, &vary, &correlate, size).map_err(|error| error::of_study(py, &error))?;
    let (result, mut raised) = attended(py, progress, |line| {
        let base = Base::of(&scatter, line)?;
        let (mut rows, mut lines) = (Rows::of(scatter.headers()), Vec::new());
        let indices: Vec<u64> = (0..scatter.count()).collect();
        let Ok(()) = study::run(&scatter, &indices, self::threads(threads), Bars::Without, line, |row| {
            lines.push(base.columns.line(&scatter, &row).into_iter().chain(base.grids.cells(&row)).collect());
            rows.push(row);
            Ok::<_, Infallible>(())
        });
        let is_whole = lines.len() == indices.len();
        // What is said is said of the table, as on the command line: of its digits.
        let table = is_whole.then(|| study::csv(&base.header(), &lines));
        let sample = table.map(|table| Sample::of(&table[..], "the sample", &base.columns)).transpose()?;
        let found = sample.map(|sample| Found::of(&scatter, &base, &sample));
        Ok::<_, StudyError>((base, rows, found))
    });
    let (base, rows, said) = found(py, result, &mut raised)?;
    let said = said.map(|found| {
        let sentences = [found.sentence()].into_iter().chain(found.sentences()).chain(scatter.told.iter().cloned());
        let pictures = scatter_pictures(&found, &base.grids, name, form());
        let told = told(py, &json::scatter(&scatter, &found), sentences, pictures);
        (told, found.load.map(|band| parts(py, band)), found.thickness.map(|band| parts(py, band)))
    });
    Ok((said, rows.table(py), raised))
}

fn asked(case: &Case, vary: &[String], correlate: &[String], size: Size) -> Result<Scatter, StudyError> {
    let split = |text: &String| Factor::split(text).map(|(key, how)| (key.to_owned(), how.to_owned()));
    let (points, seed, indices) = size;
    let asked = Asked {
        vary: vary.iter().map(split).collect::<Result<_, _>>()?,
        correlations: correlate.iter().map(|pair| Correlation::read(pair)).collect::<Result<_, _>>()?,
        points: points.unwrap_or(POINTS),
        seed: seed.unwrap_or(SEED),
        indices,
    };
    Scatter::new(case.subject()?, asked)
}

fn parts<'py>(py: Python<'py>, band: Band) -> BandParts<'py> {
    let Band { x, quantiles, runs } = band;
    (x.into_pyarray(py), quantiles.map(|side| side.into_pyarray(py)).into(), runs)
}
