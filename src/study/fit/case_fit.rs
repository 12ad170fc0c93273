//! Keys of a case fitted to measured curves by Levenberg-Marquardt.

use super::estimate::{Estimate, correlated, estimates, table};
use crate::numerics::least_squares::{Ended, Limits, Parameter, Residuals, minimise};
use crate::plot::chart::{Chart, Panel, Series, Style};
use crate::plot::palette::BLACK;
use crate::results::comparison::{Computed, Point};
use crate::study::measured_curve::MeasuredCurve;
use crate::study::parallel_map::parallel_map;
use crate::study::report::StudyReport;
use crate::study::variable::{Value, Variable};
use crate::study::{BaseCase, MeasuredData, StudyError, StudyFile};
use crate::table::Axis;
use crate::verification::Watch;
use std::convert::Infallible;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Keys and the curves that they are fitted to.
#[derive(Clone, Debug)]
pub struct CaseFitRequest {
    base: BaseCase,
    variables: Vec<Variable>,
    /// Start and ends of each variable.
    ranges: Vec<(f64, [f64; 2])>,
    curves: Vec<MeasuredCurve>,
}

/// Fitted keys.
#[derive(Clone, Debug)]
pub struct CaseFit {
    /// The keys, in the order of the request.
    pub estimates: Vec<Estimate>,
    /// Pairs of keys that the curves cannot tell apart, with their correlation.
    pub correlated: Vec<(usize, usize, f64)>,
    /// Root mean square of the weighted residuals, at the start and at the end \[–\].
    pub rms: [f64; 2],
    /// Reason of the end.
    pub ended: Ended,
    /// Number of runs, and of those that failed or ended before the curves.
    pub runs: [usize; 2],
    /// Overrides that make the fitted case.
    pub settings: Vec<String>,
    /// The fitted case.
    pub text: String,
    /// Each curve beside the runs.
    pub misfits: Vec<CurveMisfit>,
}

/// A measured curve beside the first and the fitted run.
#[derive(Clone, Debug)]
pub struct CurveMisfit {
    curve: MeasuredCurve,
    axes: [Axis; 2],
    /// The points with the fitted run's values.
    pub points: Vec<Point>,
    /// Points that the first run did not reach.
    pub left_out: usize,
    before: Vec<(f64, f64)>,
    after: Vec<(f64, f64)>,
}

const LIMITS: Limits = Limits { steps: 25, change: 1e-6 };
/// Half of a central difference over the range: wide enough for the noise of single increments \[–\].
const DIFFERENCE: f64 = 0.01;
/// Correlation from which keys cannot be told apart \[–\].
const TIED: f64 = 0.95;

impl CaseFitRequest {
    /// Reads a case or study file; `vary` and `to` replace the study's own.
    ///
    /// # Errors
    /// When it cannot be read, or as [`new`](Self::new).
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], to: &[MeasuredData]) -> Result<Self, StudyError> {
        let (file, vary) = StudyFile::load(path, set, vary)?;
        let own: Vec<MeasuredData> = file.curves().iter().cloned().map(MeasuredData::File).collect();
        let to = if to.is_empty() { &own } else { to };
        Self::new(BaseCase::load(&file.case, file.set.clone())?, &vary, to)
    }

    /// Fits `KEY=START in LOW..HIGH UNIT` keys to curves; to those of the case's comparisons if there are none.
    ///
    /// # Errors
    /// When a key has no range, is given twice or makes no case, or there is no curve.
    pub fn new(base: BaseCase, vary: &[String], to: &[MeasuredData]) -> Result<Self, StudyError> {
        let variables = vary.iter().map(|text| Variable::read(text)).collect::<Result<Vec<_>, _>>()?;
        if variables.is_empty() {
            let help = "give --vary \"tools.punch.friction=0.1 in 0.01..0.3\"";
            return Err(StudyError::new("no key is to be fitted", help));
        }
        if let Some(i) = (1..variables.len()).find(|&i| variables[..i].iter().any(|v| v.key == variables[i].key)) {
            return Err(StudyError::new(format!("{} is given twice", variables[i].key), "give each key once"));
        }
        let range = |variable: &Variable| {
            let range = variable.search_range()?;
            let [low, high] = [range.ends[0].min(range.ends[1]), range.ends[0].max(range.ends[1])];
            Ok((range.start.unwrap_or(0.5 * (low + high)), [low, high]))
        };
        let ranges = variables.iter().map(range).collect::<Result<Vec<_>, StudyError>>()?;
        let curves = match to {
            [] => MeasuredCurve::of_case(&base.case(&[])?),
            to => to.iter().map(MeasuredCurve::load).collect::<Result<_, _>>()?,
        };
        if curves.is_empty() {
            let what = "there is no curve to fit to, and the case has no [[compare]] with one";
            return Err(StudyError::new(what, "give --to curve.csv"));
        }
        let request = Self { base, variables, ranges, curves };
        request.base.case(&request.settings(&request.starts()))?;
        Ok(request)
    }

    fn starts(&self) -> Vec<f64> {
        self.ranges.iter().map(|(start, _)| *start).collect()
    }

    fn settings(&self, values: &[f64]) -> Vec<String> {
        self.variables.iter().zip(values).map(|(v, value)| v.setting(&Value::number(*value))).collect()
    }

    /// Points of every curve with the values of a run, and the run's own curve.
    fn run(&self, values: &[f64], watch: &dyn Watch) -> Result<Vec<RunCurve>, String> {
        let case = self.base.case(&self.settings(values)).map_err(|error| error.to_string())?;
        let solution = BaseCase::solve(case, watch)?;
        let computed = Computed::of(solution.stages.first().ok_or("nothing was solved")?);
        let of = |curve: &MeasuredCurve| {
            let (x, y) = computed.columns(curve.spec.quantity);
            let points = curve.points(&computed).map_err(|error| error.to_string())?;
            Ok((points, x.values.into_iter().zip(y.values).collect()))
        };
        self.curves.iter().map(of).collect()
    }

    /// One over each point's standard deviation, or over the mean height of its curve; 0 where the run has no value.
    fn weights(&self, first: &[RunCurve]) -> Result<Vec<Vec<f64>>, StudyError> {
        let is_known = self.is_weighted(first);
        let of = |(curve, (points, _)): (&MeasuredCurve, &RunCurve)| -> Vec<f64> {
            let mean = points.iter().map(|p| p.reference.abs()).sum::<f64>() / points.len() as f64;
            let deviations = curve.deviations(points).filter(|_| is_known);
            let sizes = deviations.unwrap_or_else(|| vec![mean.max(f64::MIN_POSITIVE); points.len()]);
            points.iter().zip(sizes).map(|(p, size)| if p.computed.is_some() { 1.0 / size } else { 0.0 }).collect()
        };
        let weights: Vec<Vec<f64>> = self.curves.iter().zip(first).map(of).collect();
        let used = |weights: &Vec<f64>| weights.iter().filter(|weight| **weight > 0.0).count();
        if let Some(i) = weights.iter().position(|weights| used(weights) == 0) {
            let what = format!("{} does not overlap the run", self.curves[i].path.display());
            return Err(StudyError::new(what, "check its unit and where its travel begins"));
        }
        let count: usize = weights.iter().map(used).sum();
        if count <= self.variables.len() {
            let what = format!("{count} points for {} keys", self.variables.len());
            return Err(StudyError::new(what, "a fit needs more points than keys"));
        }
        Ok(weights)
    }

    fn is_weighted(&self, first: &[RunCurve]) -> bool {
        self.curves.iter().zip(first).all(|(curve, (points, _))| curve.deviations(points).is_some())
    }
}

/// Points with the values of a run, and the run's curve.
type RunCurve = (Vec<Point>, Vec<(f64, f64)>);

struct Runner<'a> {
    request: &'a CaseFitRequest,
    weights: Vec<Vec<f64>>,
    threads: usize,
    watch: &'a dyn Watch,
    done: AtomicUsize,
    failed: AtomicUsize,
    why: Mutex<Option<String>>,
}

impl Watch for Runner<'_> {
    fn wants_to_stop(&self) -> bool {
        self.watch.wants_to_stop()
    }

    fn ran(&self, _: usize, _: usize) {
        let done = 1 + self.done.fetch_add(1, Ordering::Relaxed);
        let expected = 1 + 7 * (2 * self.request.variables.len() + 2);
        self.watch.ran(done, expected.max(done + 1));
    }
}

impl Runner<'_> {
    fn one(&self, values: &[f64]) -> Option<Vec<f64>> {
        let curves = self
            .request
            .run(values, self.watch)
            .and_then(|curves| self.residuals(&curves).ok_or_else(|| "a run ended before the curve does".to_owned()));
        let failed = |why: &String| {
            self.failed.fetch_add(1, Ordering::Relaxed);
            if let Ok(mut first) = self.why.lock() {
                first.get_or_insert_with(|| why.clone());
            }
        };
        curves.inspect_err(failed).ok()
    }

    fn residuals(&self, curves: &[RunCurve]) -> Option<Vec<f64>> {
        let all = curves.iter().zip(&self.weights).flat_map(|((points, _), weights)| points.iter().zip(weights));
        let used = all.filter(|(_, weight)| **weight > 0.0);
        used.map(|(point, weight)| Some((point.computed? - point.reference) * weight)).collect()
    }
}

impl Residuals for Runner<'_> {
    fn at(&self, points: &[Vec<f64>]) -> Vec<Option<Vec<f64>>> {
        let mut all = Vec::with_capacity(points.len());
        let Ok(()) = parallel_map(
            points,
            self.threads,
            self,
            |point| self.one(point),
            |one| {
                all.push(one);
                Ok::<_, Infallible>(())
            },
        );
        if all.len() < points.len() { Vec::new() } else { all }
    }
}

/// Fits the keys of a case. After `watch` asks to stop, the best so far is returned.
///
/// # Errors
/// When the case cannot be run at the start, a curve does not overlap it, or all runs of a key fail.
pub fn fit_case(request: &CaseFitRequest, threads: usize, watch: &dyn Watch) -> Result<CaseFit, StudyError> {
    let start = request.starts();
    let first = request.run(&start, watch).map_err(|why| {
        StudyError::new(format!("the case at the start of the fit: {why}"), "begin where it can be run")
    })?;
    let weights = request.weights(&first)?;
    let (done, failed) = (AtomicUsize::new(1), AtomicUsize::new(0));
    let runner = Runner { request, weights, threads, watch, done, failed, why: Mutex::new(None) };
    let parameter = |(start, [low, high]): &(f64, [f64; 2])| Parameter {
        start: *start,
        low: *low,
        high: *high,
        step: DIFFERENCE * (high - low),
    };
    let parameters: Vec<Parameter> = request.ranges.iter().map(parameter).collect();
    let stopped = || StudyError::new("the fit was ended before its first step", "let it run");
    let minimum = minimise(&parameters, &runner, LIMITS).ok_or_else(stopped)?;
    if let Ended::Blind(j) = minimum.ended {
        let why = runner.why.lock().ok().and_then(|why| why.clone()).unwrap_or_default();
        let (key, value) = (&request.variables[j].key, minimum.values[j]);
        let what = format!("no run succeeds on either side of {key} = {value}: {why}");
        return Err(StudyError::new(what, "begin elsewhere, or narrow the ranges"));
    }
    let names: Vec<(String, String)> = request.variables.iter().map(|v| (v.key.clone(), v.unit.clone())).collect();
    let least = if request.is_weighted(&first) { 1.0 } else { 0.0 };
    let (estimates, covariance) = estimates(&names, &parameters, &minimum, least);
    let written: Vec<f64> = estimates.iter().map(|e| e.written().parse().unwrap_or(e.value)).collect();
    let settings = request.settings(&written);
    // Also after an interruption: the best so far is shown.
    let last = request.run(&minimum.values, &()).map_err(|why| StudyError::new(why, "begin elsewhere"))?;
    let rms = |residuals: &[f64]| (residuals.iter().map(|r| r * r).sum::<f64>() / residuals.len() as f64).sqrt();
    let before = rms(&runner.residuals(&first).unwrap_or_default());
    let case = request.base.case(&[])?;
    let misfits = request.curves.iter().zip(first).zip(last).zip(&runner.weights);
    let misfits = misfits.map(|(((curve, (_, before)), (points, after)), weights)| CurveMisfit {
        curve: curve.clone(),
        axes: curve.axes(case.model()),
        points,
        left_out: weights.iter().filter(|weight| **weight == 0.0).count(),
        before,
        after,
    });
    Ok(CaseFit {
        estimates,
        correlated: correlated(covariance.as_ref(), TIED),
        rms: [before, rms(&minimum.residuals)],
        ended: if watch.wants_to_stop() { Ended::Stopped } else { minimum.ended },
        runs: [1 + runner.done.load(Ordering::Relaxed), runner.failed.load(Ordering::Relaxed)],
        text: request.base.case(&settings)?.text,
        settings,
        misfits: misfits.collect(),
    })
}

impl CaseFit {
    /// Headline, notes, table and charts.
    pub fn report(&self) -> StudyReport {
        let keys = self.estimates.iter().map(|e| {
            let error = e.error.map_or_else(String::new, |error| format!(" ± {}", crate::units::significant(error, 2)));
            format!("{} = {}{error} {}", e.key, e.written(), e.unit).trim_end().to_owned()
        });
        let [before, after] = self.rms.map(|rms| crate::units::significant(rms, 2));
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
        for misfit in self.misfits.iter().filter(|misfit| misfit.left_out > 0) {
            let (n, all, file) = (misfit.left_out, misfit.points.len(), misfit.curve.name());
            notes.push(format!("{n} of {all} points of {file} are left out: the run at the start ended before them."));
        }
        if self.runs[1] > 0 {
            notes.push(format!("{} runs failed or ended before the curves do.", self.runs[1]));
        }
        notes.push(self.settings.iter().map(|s| format!("--set \"{s}\"")).collect::<Vec<_>>().join(" "));
        let charts = self
            .misfits
            .iter()
            .enumerate()
            .map(|(i, misfit)| (if i == 0 { "fit".to_owned() } else { format!("fit_{}", i + 1) }, misfit.chart()));
        StudyReport {
            headline: format!("{}.", keys.collect::<Vec<_>>().join(", ")),
            notes,
            tables: vec![table(&self.estimates.iter().map(|e| ("case", e)).collect::<Vec<_>>())],
            found: true,
            charts: charts.collect(),
        }
    }
}

impl CurveMisfit {
    fn chart(&self) -> Chart {
        let points = self.points.iter().map(|p| (p.x, p.reference)).collect();
        let series = vec![
            Series::new("Run at the start", self.before.clone(), Style::curve(1)),
            Series::new("Fitted run", self.after.clone(), Style::curve(0)),
            Series::new(self.curve.name(), points, Style::Circles { color: BLACK }),
        ];
        let [x, y] = self.axes.clone();
        Chart::new("", vec![Panel::fit(x, y, 350.0, 0.0).with(series)], Vec::new())
    }
}
