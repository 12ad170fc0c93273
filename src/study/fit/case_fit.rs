//! Keys of a case fitted to measured curves by Levenberg-Marquardt.

use super::{Estimate, estimates, table};
use crate::case::comparison::Spec;
use crate::numerics::least_squares::{Ended, Parameter, minimise};
use crate::plot::{chart::Chart, chart::Panel, chart::Series, chart::Style, palette::BLACK};
use crate::results::comparison::{Computed, Point};
use crate::study::measured_curve::{deviations, measured_curve};
use crate::study::variable::{check_distinct, written};
use crate::study::{BaseCase, Result, StudyError, StudyFile, StudyReport, Variable, Watch, ensure, parallel_map};
use crate::units::{joined, significant};
use std::{convert::Infallible, path::Path, path::PathBuf};

/// Keys and the curves that they are fitted to.
#[derive(Clone, Debug)]
pub struct CaseFitRequest {
    base: BaseCase,
    variables: Vec<Variable>,
    parameters: Vec<Parameter>,
    curves: Vec<Spec>,
}

/// Fitted keys.
#[derive(Clone, Debug)]
pub struct CaseFit {
    /// The keys, in the order of the request.
    pub estimates: Vec<Estimate>,
    /// Root mean square of the weighted residuals, at the start and at the end \[–\].
    pub rms: [f64; 2],
    /// Reason of the end.
    pub ended: Ended,
    /// The fitted case.
    pub text: String,
    /// Headline, notes, table and charts.
    pub report: StudyReport,
}

const MOST_STEPS: usize = 25;
const LEAST_CHANGE: f64 = 1e-6;
/// Half of a central difference over the range: wide enough for the noise of single increments \[–\].
const DIFFERENCE: f64 = 0.01;

type RunCurve = (Vec<Point>, Vec<(f64, f64)>);

impl CaseFitRequest {
    /// Reads a case or study file; `vary` and `to` replace the study's own.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], to: &[PathBuf]) -> Result<Self> {
        let file = StudyFile::load(path, set, vary)?;
        Self::new(BaseCase::load(&file.case, file.set)?, &file.variables, if to.is_empty() { &file.curves } else { to })
    }

    /// Fits `KEY=START in LOW..HIGH UNIT` keys to curves; to those of the case's comparisons if there are none.
    pub fn new(base: BaseCase, vary: &[String], to: &[PathBuf]) -> Result<Self> {
        let variables = vary.iter().map(|text| Variable::read(text)).collect::<Result<Vec<_>, _>>()?;
        let help = "give --vary \"tools.punch.friction=0.1 in 0.01..0.3\"";
        ensure(!variables.is_empty(), "no key is to be fitted", help)?;
        check_distinct(variables.iter(), "is given twice", "give each key once")?;
        let parameter = |variable: &Variable| {
            let range = variable.search_range()?;
            let [a, b] = range.ends;
            let (low, high, step) = (a.min(b), a.max(b), DIFFERENCE * (a - b).abs());
            Ok(Parameter { start: range.start.unwrap_or(0.5 * (a + b)), low, high, step })
        };
        let parameters: Vec<Parameter> = variables.iter().map(parameter).collect::<Result<_>>()?;
        let curves = match to {
            [] => base.case(&[])?.compare,
            to => to.iter().map(|path| measured_curve(path)).collect::<Result<_, _>>()?,
        };
        let curves: Vec<Spec> = curves.into_iter().filter(|c| c.quantity.is_curve() && c.data.is_some()).collect();
        let what = "there is no curve to fit to, and the case has no [[compare]] with one";
        ensure(!curves.is_empty(), what, "give --to curve.csv")?;
        let request = Self { base, variables, parameters, curves };
        request.base.check_effective(&request.settings(&request.starts()))?;
        request.base.case(&request.settings(&request.starts()))?;
        Ok(request)
    }

    fn starts(&self) -> Vec<f64> {
        self.parameters.iter().map(|parameter| parameter.start).collect()
    }

    fn settings(&self, values: &[f64]) -> Vec<String> {
        self.variables.iter().zip(values).map(|(variable, value)| variable.setting(&written(*value))).collect()
    }

    fn run(&self, values: &[f64], watch: &dyn Watch) -> Result<Vec<RunCurve>, String> {
        let case = self.base.case(&self.settings(values)).map_err(|error| error.to_string())?;
        let solution = BaseCase::solve(case, watch)?;
        let computed = Computed::of(solution.stages.first().ok_or("nothing was solved")?);
        let pair = |curve: &Spec| {
            let (x, y) = computed.columns(curve.quantity);
            let points = computed.points(curve).map_err(|error| error.to_string())?;
            Ok((points, x.values.into_iter().zip(y.values).collect()))
        };
        self.curves.iter().map(pair).collect()
    }

    fn weights(&self, first: &[RunCurve], deviations: Option<&[Vec<f64>]>) -> Result<Vec<Vec<f64>>> {
        let mut all = Vec::new();
        for (i, (curve, (points, _))) in self.curves.iter().zip(first).enumerate() {
            let mean = points.iter().map(|p| p.reference.abs()).sum::<f64>() / points.len() as f64;
            let size = |j: usize| deviations.map_or(mean.max(f64::MIN_POSITIVE), |all| all[i][j]);
            let weight = |(j, p): (usize, &Point)| if p.computed.is_some() { 1.0 / size(j) } else { 0.0 };
            all.push(points.iter().enumerate().map(weight).collect::<Vec<_>>());
            let what = format!("{} does not overlap the run", curve.reference.display());
            ensure(all[i].iter().any(|w| *w > 0.0), what, "check its unit and where its travel begins")?;
        }
        let (count, keys) = (all.iter().flatten().filter(|w| **w > 0.0).count(), self.variables.len());
        ensure(count > keys, format!("{count} points for {keys} keys"), "a fit needs more points than keys")?;
        Ok(all)
    }
}

/// Fits the keys of a case. After `watch` asks to stop, the best so far is returned.
pub fn fit_case(request: &CaseFitRequest, threads: usize, watch: &dyn Watch) -> Result<CaseFit> {
    let first = request.run(&request.starts(), watch).map_err(|reason| {
        StudyError::new(format!("the case at the start of the fit: {reason}"), "begin where it can be run")
    })?;
    let computed = Computed::nothing(request.base.case(&[])?.model());
    let deviations: Option<Vec<Vec<f64>>> = request.curves.iter().map(|curve| deviations(curve, &computed)).collect();
    let weights = request.weights(&first, deviations.as_deref())?;
    let residuals = |curves: &[RunCurve]| -> Option<Vec<f64>> {
        let all = curves.iter().zip(&weights).flat_map(|((points, _), weights)| points.iter().zip(weights));
        let used = all.filter(|(_, weight)| **weight > 0.0);
        used.map(|(point, weight)| Some((point.computed? - point.reference) * weight)).collect()
    };
    let (mut done, mut failed, mut reason) = (1, 0, None);
    let expected = 1 + 7 * (2 * request.variables.len() + 2);
    let mut run_all = |points: &[Vec<f64>]| {
        let one = |i: usize| {
            residuals(&request.run(&points[i], watch)?).ok_or_else(|| "a run ended before the curve does".to_owned())
        };
        let mut all = Vec::new();
        let Ok(()) = parallel_map(points.len(), threads, watch, one, |result: Result<Vec<f64>, String>| {
            done += 1;
            watch.ran(done, expected.max(done + 1));
            failed += usize::from(result.is_err());
            all.push(result.map_err(|why| _ = reason.get_or_insert(why)).ok());
            Ok::<_, Infallible>(())
        });
        if all.len() < points.len() { Vec::new() } else { all }
    };
    let minimum = minimise(&request.parameters, &mut run_all, MOST_STEPS, LEAST_CHANGE)
        .ok_or_else(|| StudyError::new("the fit was ended before its first step", "let it run"))?;
    if let Ended::Blind(j) = minimum.ended {
        let (key, value) = (&request.variables[j].key, minimum.values[j]);
        let what = format!("no run succeeds on either side of {key} = {value}: {}", reason.unwrap_or_default());
        return Err(StudyError::new(what, "begin elsewhere, or narrow the ranges"));
    }
    let names = request.variables.iter().map(|v| (v.key.as_str(), v.unit.as_str()));
    let estimates = estimates(names, &request.parameters, &minimum, deviations.is_some());
    let rounded: Vec<f64> = estimates.iter().map(|e| e.written().parse().unwrap_or(e.value)).collect();
    let settings = request.settings(&rounded);
    // Also after an interruption: the best so far is shown.
    let last = request.run(&minimum.values, &()).map_err(|reason| StudyError::new(reason, "begin elsewhere"))?;
    let rms = |residuals: &[f64]| (residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len() as f64).sqrt();
    let rms = [rms(&residuals(&first).unwrap_or_default()), rms(&minimum.residuals)];
    let ended = if watch.wants_to_stop() { Ended::Stopped } else { minimum.ended };
    let text = request.base.case(&settings)?.text;

    let keys = estimates.iter().map(|e| {
        let error = e.error.map_or_else(String::new, |error| format!(" ± {}", significant(error, 2)));
        format!("{} = {}{error} {}", e.key, e.written(), e.unit).trim_end().to_owned()
    });
    let headline = format!("{}.", joined(keys, ", "));
    let [before, after] = rms.map(|rms| significant(rms, 2));
    let mut notes = vec![format!("Weighted misfit {before} at the start, {after} at the end (r.m.s.).")];
    notes.extend(match ended {
        Ended::Found => None,
        Ended::Stopped => Some("It was interrupted: this is the best so far.".to_owned()),
        Ended::Steps | Ended::Blind(_) => Some("It did not converge: begin again from here.".to_owned()),
    });
    let at_bound = estimates.iter().filter(|e| e.bound.is_some());
    notes.extend(at_bound.map(|e| format!("{} is at its bound: the curves want it beyond.", e.key)));
    let mut charts = Vec::new();
    for (((curve, (_, before)), (points, after)), weights) in request.curves.iter().zip(first).zip(last).zip(&weights) {
        let (file, left_out, all) = (curve.file(), weights.iter().filter(|w| **w == 0.0).count(), points.len());
        let note = format!("{left_out} of {all} points of {file} are left out: the first run ended before them.");
        notes.extend((left_out > 0).then_some(note));
        let series = [
            Series::new("Run at the start", before, Style::curve(1)),
            Series::new("Fitted run", after, Style::curve(0)),
            Series::new(file, points.iter().map(|p| (p.x, p.reference)).collect(), Style::Circles { color: BLACK }),
        ];
        let (x, y) = computed.columns(curve.quantity);
        let name = if charts.is_empty() { "fit".to_owned() } else { format!("fit_{}", charts.len() + 1) };
        charts.push((name, Chart::new("", vec![Panel::fit(x.axis(), y.axis(), 350.0, 0.0).with(series)], Vec::new())));
    }
    notes.extend((failed > 0).then(|| format!("{failed} runs failed or ended before the curves do.")));
    notes.push(joined(settings.iter().map(|s| format!("--set \"{s}\"")), " "));
    let tables = vec![table(estimates.iter().map(|e| ("case".to_owned(), e)))];
    Ok(CaseFit { estimates, rms, ended, text, report: StudyReport { headline, notes, tables, found: true, charts } })
}
