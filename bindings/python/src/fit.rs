//! Laws from tension tests, and keys of a case from measured curves.

use super::attend::{Progress, attended};
use super::case::Case;
use super::error;
use super::study::{Given, Of, Told, form, found, readings, threads, told};
use pyo3::prelude::*;
use stampflow::output::study::json;
use stampflow::study::StudyError;
use stampflow::study::fit::{self, CaseFitSpec, FlowCurve, Kind, Range, RateKind, Reduction, Tests, specimens};

/// Young's modulus, offset, where the fit begins and ends, section and gauge of the specimen: texts with their units.
type Reduced = [Option<String>; 6];

/// The law that is asked for, and the law of the rate.
type Laws = (Option<String>, Option<String>);

/// Hardening laws through tension tests; also the setting that makes the fitted sheet that of a case.
#[pyfunction]
pub fn fit_law<'py>(
    py: Python<'py>,
    tests: Vec<Given<'py>>,
    laws: Laws,
    reduced: Reduced,
    rate: Vec<f64>,
    direction: Vec<f64>,
) -> PyResult<(Told<'py>, String)> {
    let wrong = |error: StudyError| error::of_study(py, &error);
    let law = laws.0.as_deref().map(|law| read::<Kind>(law, str::parse)).transpose().map_err(wrong)?;
    let rate_law = laws.1.as_deref().map_or(Ok(RateKind::Power), |law| read(law, str::parse)).map_err(wrong)?;
    let tests = reduced_by(&tests, &reduced, rate, direction).map_err(wrong)?;
    let fits = py.detach(|| fit::fit_laws(tests.curves()?, law, rate_law)).map_err(wrong)?;
    let setting = fit::material_setting(&fits, fits.best());
    let sentences = fits.sentences().into_iter().chain(fits.tests.iter().map(FlowCurve::sentence));
    let picture = stampflow::output::study::fit_law(&fits, form());
    Ok((told(py, &json::fit_law(&fits), sentences, [("fit", picture)]), setting))
}

/// Keys of a case with which its run meets measured curves; also the fitted case.
#[pyfunction]
pub fn fit_case<'py>(
    py: Python<'py>,
    of: Of<'py>,
    ranges: Vec<String>,
    to: Vec<Given<'py>>,
    threads: Option<usize>,
    progress: Progress,
) -> PyResult<(Told<'py>, Case, Option<PyErr>)> {
    let spec = spec(of, &ranges, &to).map_err(|error| error::of_study(py, &error))?;
    let (result, mut raised) = attended(py, progress, |line| {
        let fit = fit::fit_case(&spec, self::threads(threads), line)?;
        let case = spec.subject.case(&fit.settings)?;
        Ok::<_, StudyError>((fit, case))
    });
    let (fit, fitted) = found(py, result, &mut raised)?;
    let pictures = stampflow::output::study::fit_case(&fit, form()).into_iter().enumerate();
    let named = pictures.map(|(i, chart)| (if i == 0 { "fit".to_owned() } else { format!("fit_{}", i + 1) }, chart));
    Ok((told(py, &json::fit_case(&fit), fit.sentences(), named), Case::made(&spec.subject, fitted), raised))
}

fn spec(of: Of<'_>, ranges: &[String], to: &[Given<'_>]) -> Result<CaseFitSpec, StudyError> {
    let ranges = ranges.iter().map(|range| Range::read(range)).collect::<Result<Vec<_>, _>>()?;
    let to = readings(to)?;
    match of {
        Of::Case(case) => CaseFitSpec::of(case.subject()?, ranges, &to),
        Of::File(path, settings) => fit::load(&path, settings, ranges, &to),
    }
}

fn reduced_by(
    tests: &[Given<'_>],
    reduced: &Reduced,
    rate: Vec<f64>,
    direction: Vec<f64>,
) -> Result<Tests, StudyError> {
    let [young, offset, from, to, section, gauge] = reduced;
    let of = |text: &Option<String>, by: fn(&str) -> Result<f64, String>| {
        text.as_deref().map(|text| read(text, by)).transpose()
    };
    let default = Reduction::default();
    Ok(Tests {
        tests: readings(tests)?,
        reduction: Reduction {
            young: of(young, specimens::stress)?,
            offset: of(offset, specimens::strain)?.unwrap_or(default.offset),
            from: of(from, specimens::strain)?,
            to: of(to, specimens::strain)?,
        },
        section: of(section, specimens::section)?,
        gauge: of(gauge, specimens::gauge)?,
        rate,
        direction,
    })
}

/// A text by its reader.
fn read<T>(text: &str, by: impl Fn(&str) -> Result<T, String>) -> Result<T, StudyError> {
    by(text).map_err(|help| StudyError::Asked { what: format!("`{text}` is not understood"), help })
}
