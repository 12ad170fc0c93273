//! How sure a verdict is when coil, friction, thickness and press scatter.

use super::attend::{Progress, attended};
use super::designs::{Part, Ran, Written};
use super::error;
use super::rows::Table;
use super::study::{Of, Told, form, found, threads, told};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::output::study::{json, scatter_pictures};
use stampflow::study::scatter::{Asked, Band, Base, Correlation, Factor, Found, Sample, Scatter, file};
use stampflow::study::{Bars, StudyError, Subject};

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
    of: Of<'py>,
    vary: Vec<String>,
    correlate: Vec<String>,
    size: Size,
    name: &str,
    part: Part,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<(Option<Said<'py>>, Table<'py>, Option<PyErr>)> {
    let wrong = |error: StudyError| error::of_study(py, &error);
    let scatter = asked(of, &vary, &correlate, size).map_err(wrong)?;
    part.indices(&scatter).map_err(wrong)?;
    let (result, mut raised) = attended(py, progress, |line| {
        let base = Base::of(&scatter, line)?;
        let written = Written {
            stem: "scatter",
            columns: &base.columns,
            header: base.header(),
            line: &|row| base.columns.line(&scatter, row).into_iter().chain(base.grids.cells(row)).collect(),
            is_told: true,
            has_times: false,
        };
        let Ran { rows, whole } = part.run(&scatter, written, self::threads(threads), Bars::Without, line)?;
        let sample = whole.map(|(table, shown)| Sample::of(&table[..], &shown, &base.columns)).transpose()?;
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

fn asked(of: Of<'_>, vary: &[String], correlate: &[String], size: Size) -> Result<Scatter, StudyError> {
    let (subject, mut asked) = match of {
        Of::Case(case) => (case.subject()?, Asked::default()),
        Of::File(path, settings) => {
            let (case, own, asked) = file::load(&path)?;
            (Subject::new(case, [own, settings].concat())?, asked)
        }
    };
    for text in vary {
        let (key, how) = Factor::split(text)?;
        asked.vary.push((key.to_owned(), how.to_owned()));
    }
    for pair in correlate {
        asked.correlations.push(Correlation::read(pair)?);
    }
    let (points, seed, indices) = size;
    let (points, seed) = (points.unwrap_or(asked.points), seed.unwrap_or(asked.seed));
    Scatter::new(subject, Asked { points, seed, indices, ..asked })
}

fn parts<'py>(py: Python<'py>, band: Band) -> BandParts<'py> {
    let Band { x, quantiles, runs } = band;
    (x.into_pyarray(py), quantiles.map(|side| side.into_pyarray(py)).into(), runs)
}
