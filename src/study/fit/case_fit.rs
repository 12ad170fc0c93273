//! Keys of a case fitted to measured curves by Levenberg-Marquardt.

use super::estimate::{Correlated, Estimate, estimates, table};
use crate::numerics::least_squares::{Ended, Limits, Parameter, minimise};
use crate::plot::chart::{Chart, Panel, Series, Style};
use crate::plot::palette::BLACK;
use crate::results::comparison::{Computed, Point};
use crate::study::Watch;
use crate::study::variable::{repeated, written};
use crate::study::{BaseCase, MeasuredCurve, StudyError, StudyFile, StudyReport, Variable, fail, parallel_map};
use crate::units::significant;
use std::convert::Infallible;
use std::path::{Path, PathBuf};

/// Keys and the curves that they are fitted to.
#[derive(Clone, Debug)]
pub struct CaseFitRequest {
    base: BaseCase,
    variables: Vec<Variable>,
    parameters: Vec<Parameter>,
    curves: Vec<MeasuredCurve>,
}

/// Fitted keys.
#[derive(Clone, Debug)]
pub struct CaseFit {
    /// The keys, in the order of the request.
    pub estimates: Vec<Estimate>,
    /// Pairs of keys that the curves cannot tell apart.
    pub correlated: Vec<Correlated>,
    /// Root mean square of the weighted residuals, at the start and at the end \[–\].
    pub rms: [f64; 2],
    /// Reason of the end.
    pub ended: Ended,
    /// The fitted case.
    pub text: String,
    settings: Vec<String>,
    /// Runs that failed or ended before the curves do.
    failed: usize,
    charts: Vec<Chart>,
    /// Name, points that the first run did not reach, and all points of each curve.
    left_out: Vec<(String, usize, usize)>,
}

const LIMITS: Limits = Limits { steps: 25, change: 1e-6 };
/// Half of a central difference over the range: wide enough for the noise of single increments \[–\].
const DIFFERENCE: f64 = 0.01;
/// Correlation from which keys cannot be told apart \[–\].
const TIED: f64 = 0.95;

/// Points with the values of a run, and the run's own curve.
type RunCurve = (Vec<Point>, Vec<(f64, f64)>);

impl CaseFitRequest {
    /// Reads a case or study file; `vary` and `to` replace the study's own.
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], to: &[PathBuf]) -> Result<Self, StudyError> {
        let file = StudyFile::load(path, set, vary)?;
        Self::new(BaseCase::load(&file.case, file.set)?, &file.variables, if to.is_empty() { &file.to } else { to })
    }

    /// Fits `KEY=START in LOW..HIGH UNIT` keys to curves; to those of the case's comparisons if there are none.
    pub fn new(base: BaseCase, vary: &[String], to: &[PathBuf]) -> Result<Self, StudyError> {
        let variables = vary.iter().map(|text| Variable::read(text)).collect::<Result<Vec<_>, _>>()?;
        if variables.is_empty() {
            return fail("no key is to be fitted", "give --vary \"tools.punch.friction=0.1 in 0.01..0.3\"");
        }
        if let Some(key) = repeated(variables.iter()) {
            return fail(format!("{key} is given twice"), "give each key once");
        }
        let parameter = |variable: &Variable| {
            let range = variable.search_range()?;
            let [low, high] = [range.ends[0].min(range.ends[1]), range.ends[0].max(range.ends[1])];
            let (start, step) = (range.start.unwrap_or(0.5 * (low + high)), DIFFERENCE * (high - low));
            Ok(Parameter { start, low, high, step })
        };
        let parameters: Vec<Parameter> = variables.iter().map(parameter).collect::<Result<_, StudyError>>()?;
        let curves = match to {
            [] => MeasuredCurve::of_case(&base.case(&[])?),
            to => to.iter().map(|path| MeasuredCurve::load(path)).collect::<Result<_, _>>()?,
        };
        if curves.is_empty() {
            let what = "there is no curve to fit to, and the case has no [[compare]] with one";
            return fail(what, "give --to curve.csv");
        }
        let request = Self { base, variables, parameters, curves };
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
        let pair = |curve: &MeasuredCurve| {
            let (x, y) = computed.columns(curve.spec.quantity);
            let points = curve.points(&computed).map_err(|error| error.to_string())?;
            Ok((points, x.values.into_iter().zip(y.values).collect()))
        };
        self.curves.iter().map(pair).collect()
    }

    /// One over each point's standard deviation, or over the mean height of its curve; 0 where the run has no value.
    fn weights(&self, first: &[RunCurve], is_weighted: bool) -> Result<Vec<Vec<f64>>, StudyError> {
        let weights = |(curve, (points, _)): (&MeasuredCurve, &RunCurve)| -> Vec<f64> {
            let mean = points.iter().map(|p| p.reference.abs()).sum::<f64>() / points.len() as f64;
            let deviations = curve.deviations(points).filter(|_| is_weighted);
            let sizes = deviations.unwrap_or_else(|| vec![mean.max(f64::MIN_POSITIVE); points.len()]);
            points.iter().zip(sizes).map(|(p, size)| if p.computed.is_some() { 1.0 / size } else { 0.0 }).collect()
        };
        let all: Vec<Vec<f64>> = self.curves.iter().zip(first).map(weights).collect();
        let counts: Vec<usize> = all.iter().map(|weights| weights.iter().filter(|w| **w > 0.0).count()).collect();
        if let Some(i) = counts.iter().position(|count| *count == 0) {
            let what = format!("{} does not overlap the run", self.curves[i].path.display());
            return fail(what, "check its unit and where its travel begins");
        }
        let (count, keys) = (counts.iter().sum::<usize>(), self.variables.len());
        if count <= keys {
            return fail(format!("{count} points for {keys} keys"), "a fit needs more points than keys");
        }
        Ok(all)
    }
}

/// Fits the keys of a case. After `watch` asks to stop, the best so far is returned.
pub fn fit_case(request: &CaseFitRequest, threads: usize, watch: &dyn Watch) -> Result<CaseFit, StudyError> {
    let first = request.run(&request.starts(), watch).map_err(|reason| {
        StudyError::new(format!("the case at the start of the fit: {reason}"), "begin where it can be run")
    })?;
    let is_weighted = request.curves.iter().zip(&first).all(|(curve, (points, _))| curve.deviations(points).is_some());
    let weights = request.weights(&first, is_weighted)?;
    let residuals = |curves: &[RunCurve]| -> Option<Vec<f64>> {
        let all = curves.iter().zip(&weights).flat_map(|((points, _), weights)| points.iter().zip(weights));
        let used = all.filter(|(_, weight)| **weight > 0.0);
        used.map(|(point, weight)| Some((point.computed? - point.reference) * weight)).collect()
    };
    let (mut done, mut failed, mut reason) = (1, 0, None);
    let expected = 1 + 7 * (2 * request.variables.len() + 2);
    let mut run_all = |points: &[Vec<f64>]| {
        let one = |values: &Vec<f64>| {
            let curves = request.run(values, watch)?;
            residuals(&curves).ok_or_else(|| "a run ended before the curve does".to_owned())
        };
        let mut all = Vec::new();
        let Ok(()) = parallel_map(points, threads, watch, one, |result: Result<Vec<f64>, String>| {
            done += 1;
            watch.ran(done, expected.max(done + 1));
            failed += usize::from(result.is_err());
            all.push(result.map_err(|why| _ = reason.get_or_insert(why)).ok());
            Ok::<_, Infallible>(())
        });
        if all.len() < points.len() { Vec::new() } else { all }
    };
    let Some(minimum) = minimise(&request.parameters, &mut run_all, LIMITS) else {
        return fail("the fit was ended before its first step", "let it run");
    };
    if let Ended::Blind(j) = minimum.ended {
        let (key, value) = (&request.variables[j].key, minimum.values[j]);
        let what = format!("no run succeeds on either side of {key} = {value}: {}", reason.unwrap_or_default());
        return fail(what, "begin elsewhere, or narrow the ranges");
    }
    let names: Vec<(&str, &str)> = request.variables.iter().map(|v| (v.key.as_str(), v.unit.as_str())).collect();
    let (estimates, correlated) = estimates(&names, &request.parameters, &minimum, is_weighted, TIED);
    let written: Vec<f64> = estimates.iter().map(|e| e.written().parse().unwrap_or(e.value)).collect();
    let settings = request.settings(&written);
    // Also after an interruption: the best so far is shown.
    let last = request.run(&minimum.values, &()).map_err(|reason| StudyError::new(reason, "begin elsewhere"))?;
    let rms = |residuals: &[f64]| (residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len() as f64).sqrt();
    let case = request.base.case(&[])?;
    let before = rms(&residuals(&first).unwrap_or_default());
    let (mut charts, mut left_out) = (Vec::new(), Vec::new());
    for (((curve, (_, before)), (points, after)), weights) in request.curves.iter().zip(first).zip(last).zip(&weights) {
        left_out.push((curve.name(), weights.iter().filter(|weight| **weight == 0.0).count(), points.len()));
        let measured = points.iter().map(|p| (p.x, p.reference)).collect();
        let series = [
            Series::new("Run at the start", before, Style::curve(1)),
            Series::new("Fitted run", after, Style::curve(0)),
            Series::new(curve.name(), measured, Style::Circles { color: BLACK }),
        ];
        let [x, y] = curve.axes(case.model());
        charts.push(Chart::new("", vec![Panel::fit(x, y, 350.0, 0.0).with(series)], Vec::new()));
    }
    Ok(CaseFit {
        estimates,
        correlated,
        rms: [before, rms(&minimum.residuals)],
        ended: if watch.wants_to_stop() { Ended::Stopped } else { minimum.ended },
        text: request.base.case(&settings)?.text,
        settings,
        failed,
        charts,
        left_out,
    })
}

impl CaseFit {
    /// Headline, notes, table and charts.
    pub fn report(&self) -> StudyReport {
        let keys = self.estimates.iter().map(|e| {
            let error = e.error.map_or_else(String::new, |error| format!(" ± {}", significant(error, 2)));
            format!("{} = {}{error} {}", e.key, e.written(), e.unit).trim_end().to_owned()
        });
        let [before, after] = self.rms.map(|rms| significant(rms, 2));
        let mut notes = vec![format!("Weighted misfit {before} at the start, {after} at the end (r.m.s.).")];
        match self.ended {
            Ended::Found => {}
            Ended::Stopped => notes.push("It was interrupted: this is the best so far.".into()),
            Ended::Steps | Ended::Blind(_) => notes.push("It did not converge: begin again from here.".into()),
        }
        for e in self.estimates.iter().filter(|e| e.bound.is_some()) {
            notes.push(format!("{} is at its bound: the curves want it beyond.", e.key));
        }
        for (i, j, correlation) in &self.correlated {
            let [a, b] = [i, j].map(|i| &self.estimates[*i].key);
            notes.push(format!("{a} and {b} cannot be told apart by these curves (correlation {correlation:.2})."));
        }
        for (file, n, all) in self.left_out.iter().filter(|(_, n, _)| *n > 0) {
            notes.push(format!("{n} of {all} points of {file} are left out: the run at the start ended before them."));
        }
        if self.failed > 0 {
            notes.push(format!("{} runs failed or ended before the curves do.", self.failed));
        }
        notes.push(self.settings.iter().map(|s| format!("--set \"{s}\"")).collect::<Vec<_>>().join(" "));
        let name = |i: usize| if i == 0 { "fit".to_owned() } else { format!("fit_{}", i + 1) };
        StudyReport {
            headline: format!("{}.", keys.collect::<Vec<_>>().join(", ")),
            notes,
            tables: vec![table(self.estimates.iter().map(|e| ("case".to_owned(), e)))],
            found: true,
            charts: self.charts.iter().enumerate().map(|(i, chart)| (name(i), chart.clone())).collect(),
        }
    }
}
