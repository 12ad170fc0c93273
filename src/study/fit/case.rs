//! Keys of a case from measured curves.

use super::case_spec::CaseFitSpec;
use super::estimate::Estimates;
use super::noise;
use super::target::Target;
use crate::compare::{Computed, Point};
use crate::numerics::least_squares::{Ended, Limits, Minimum, Parameter, Residuals, minimise};
use crate::study::verify::Watch;
use crate::study::{StudyError, Subject, side_by_side};
use crate::table::Axis;
use std::convert::Infallible;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Keys that fit.
#[derive(Clone, Debug, PartialEq)]
pub struct CaseFit {
    /// The keys, in the order of the ranges.
    pub estimates: Estimates,
    /// Where it began.
    pub start: Vec<f64>,
    /// Each curve beside the runs.
    pub matched: Vec<Matched>,
    /// Root of the mean square of the weighted residuals, at the start and at the end \[–\].
    pub rms: [f64; 2],
    /// The same of a run's numerical noise \[–\].
    pub noise: f64,
    /// The same of what each key moves over its whole range \[–\].
    pub felt: Vec<f64>,
    /// Half of each key's central difference.
    pub steps: Vec<f64>,
    /// Why it ended.
    pub ended: Ended,
    /// Runs, and those of them that failed or did not come as far as the curves.
    pub runs: [usize; 2],
    /// The overrides that make the fitted case.
    pub settings: Vec<String>,
    /// The fitted case.
    pub text: String,
}

/// A measured curve beside the run that begins and the one that fits.
#[derive(Clone, Debug, PartialEq)]
pub struct Matched {
    /// Name of the file.
    pub name: String,
    /// Of x and y.
    pub axes: [Axis; 2],
    /// Whether each point has its standard deviation.
    pub is_weighted: bool,
    /// The points with what the fitted run has there.
    pub points: Vec<Point>,
    /// Points that no run came to.
    pub left_out: usize,
    /// Curve of the run at the start.
    pub before: Vec<(f64, f64)>,
    /// Curve of the fitted run.
    pub after: Vec<(f64, f64)>,
}

const LIMITS: Limits = Limits { steps: 25, change: 1e-6 };
/// Of the fits that profiles are made of: they begin near their ends.
const PROFILE: Limits = Limits { steps: 4, change: 1e-3 };
/// Runs that a fit takes, for the time that is left: of each step and of each key's two ends.
const STEPS_EXPECTED: usize = 7;
const END_EXPECTED: usize = 3;

/// A run beside each curve: its points, and the run's own curve.
type Beside = Vec<(Vec<Point>, Vec<(f64, f64)>)>;

/// Runs the case with some values.
fn beside(spec: &CaseFitSpec, values: &[f64], watch: &dyn Watch) -> Result<Beside, String> {
    let case = spec.subject.case(&spec.settings(values)).map_err(|error| error.to_string())?;
    let solution = Subject::solution(case, watch)?;
    let computed = Computed::of(solution.stages.first().ok_or("nothing was solved")?);
    let of = |target: &Target| {
        let (x, y) = target.spec.quantity.columns(&computed);
        let points = target.points(&computed).map_err(|error| error.to_string())?;
        Ok((points, x.values.into_iter().zip(y.values).collect()))
    };
    spec.targets.iter().map(of).collect()
}

/// Residuals of runs side by side: of the points that the run at the start came to, each over its weight.
struct Runner<'a> {
    spec: &'a CaseFitSpec,
    /// Of each curve and point; 0 of what is left out.
    weights: Vec<Vec<f64>>,
    threads: usize,
    watch: &'a dyn Watch,
    done: AtomicUsize,
    expected: usize,
    failed: AtomicUsize,
    why: Mutex<Option<String>>,
}

/// Tells runs of all batches together.
struct Batch<'a>(&'a Runner<'a>);

impl Watch for Batch<'_> {
    fn wants_to_stop(&self) -> bool {
        self.0.watch.wants_to_stop()
    }

    fn ran(&self, _: usize, _: usize) {
        let done = 1 + self.0.done.fetch_add(1, Ordering::Relaxed);
        self.0.watch.ran(done, self.0.expected.max(done + 1));
    }
}

impl Runner<'_> {
    fn one(&self, values: &[f64]) -> Option<Vec<f64>> {
        let found = beside(self.spec, values, self.watch).and_then(|found| {
            let all = found.iter().zip(&self.weights).flat_map(|((points, _), weights)| points.iter().zip(weights));
            let used = all.filter(|(_, weight)| **weight > 0.0);
            let residual = |(point, weight): (&Point, &f64)| Some((point.computed? - point.reference) * weight);
            used.map(residual)
                .collect::<Option<Vec<f64>>>()
                .ok_or_else(|| "a run ended before the curve does".to_owned())
        });
        found
            .inspect_err(|why| {
                self.failed.fetch_add(1, Ordering::Relaxed);
                if let Ok(mut first) = self.why.lock() {
                    first.get_or_insert_with(|| why.clone());
                }
            })
            .ok()
    }
}

impl Residuals for Runner<'_> {
    fn at(&self, points: &[Vec<f64>]) -> Vec<Option<Vec<f64>>> {
        let mut all = Vec::with_capacity(points.len());
        let Ok(()) = side_by_side(
            points,
            self.threads,
            &Batch(self),
            |point| self.one(point),
            |found| {
                all.push(found);
                Ok::<_, Infallible>(())
            },
        );
        if all.len() < points.len() { Vec::new() } else { all }
    }
}

/// Fits the keys of a case to its curves, with runs on so many threads; once `watch` wants to stop what was found is told.
///
/// # Errors
/// When the case cannot be run at the start, a curve does not fit it or is not reached by it, there are no more points than keys,
/// or a key's runs all fail.
pub fn fit_case(spec: &CaseFitSpec, threads: usize, watch: &dyn Watch) -> Result<CaseFit, StudyError> {
    let start: Vec<f64> = spec.ranges.iter().map(|range| range.start).collect();
    let first = beside(spec, &start, watch).map_err(|why| {
        StudyError::new(
            format!("the case at the start of the fit: {why}"),
            "begin where it can be run, with curves that it has",
        )
    })?;
    let weights = weights(spec, &first)?;
    let p = start.len();
    let expected = 6 + p + STEPS_EXPECTED * (2 * p + 2) + 2 * p * END_EXPECTED * (2 * p + 1);
    let (done, failed) = (AtomicUsize::new(1), AtomicUsize::new(0));
    let runner = Runner { spec, weights, threads, watch, done, expected, failed, why: Mutex::new(None) };
    let mut parameters: Vec<Parameter> = spec
        .ranges
        .iter()
        .map(|r| Parameter { start: r.start, low: r.low, high: r.high, step: 0.01 * (r.high - r.low) })
        .collect();
    let measured = noise::measured(&mut parameters, &runner);
    let stopped = || StudyError::new("the fit was ended before its first step", "let it run");
    let minimum = minimise(&parameters, &runner, LIMITS).ok_or_else(stopped)?;
    if let Ended::Blind(j) = minimum.ended {
        let why = runner.why.lock().ok().and_then(|why| why.clone()).unwrap_or_default();
        let what = format!("no run succeeds on either side of {} = {}: {why}", spec.ranges[j].key, minimum.values[j]);
        return Err(StudyError::new(what, "begin elsewhere, or narrow the ranges"));
    }
    let names: Vec<(String, String)> =
        spec.ranges.iter().map(|range| (range.key.clone(), range.unit.clone())).collect();
    let known = is_known(spec, &first);
    let estimates = Estimates::of(&names, &parameters, &runner, &minimum, if known { 1.0 } else { 0.0 }, PROFILE);
    let settings =
        spec.settings(&estimates.all.iter().map(|e| e.written().parse().unwrap_or(e.value)).collect::<Vec<_>>());
    // Also where it is to stop: what was found is shown.
    let last = beside(spec, &minimum.values, &()).map_err(|why| StudyError::new(why, "begin elsewhere"))?;
    let of = |minimum: &Minimum| (minimum.sum() / minimum.residuals.len() as f64).sqrt();
    let at_start = runner.weighted(&first);
    let (noise, felt) = measured.unwrap_or((f64::NAN, vec![f64::NAN; p]));
    Ok(CaseFit {
        estimates,
        start,
        rms: [at_start, of(&minimum)],
        noise,
        felt,
        steps: parameters.iter().map(|p| p.step).collect(),
        ended: if watch.wants_to_stop() { Ended::Stopped } else { minimum.ended },
        runs: [1 + runner.done.load(Ordering::Relaxed), runner.failed.load(Ordering::Relaxed)],
        text: spec.subject.case(&settings).map(|case| case.text)?,
        settings,
        matched: matched(spec, first, last, &runner.weights)?,
    })
}

impl Runner<'_> {
    /// Root of the mean square of a run's weighted residuals.
    fn weighted(&self, found: &Beside) -> f64 {
        let all = found.iter().zip(&self.weights).flat_map(|((points, _), weights)| points.iter().zip(weights));
        let used = all.filter(|(_, weight)| **weight > 0.0).filter_map(|(p, w)| Some((p.computed? - p.reference) * w));
        let (sum, count) = used.fold((0.0, 0.0), |(sum, count), r| (sum + r * r, count + 1.0));
        f64::sqrt(sum / f64::max(count, 1.0))
    }
}

/// Whether the scatter of all curves is known.
fn is_known(spec: &CaseFitSpec, first: &Beside) -> bool {
    spec.targets.iter().zip(first).all(|(target, (points, _))| target.scatter(points).is_some())
}

/// One over each point's standard deviation where all have one, else one over the mean size of its curve; 0 of points that the
/// run does not come to.
fn weights(spec: &CaseFitSpec, first: &Beside) -> Result<Vec<Vec<f64>>, StudyError> {
    let known = is_known(spec, first);
    let of = |(target, (points, _)): (&Target, &(Vec<Point>, _))| -> Vec<f64> {
        let mean = points.iter().map(|p| p.reference.abs()).sum::<f64>() / points.len() as f64;
        let size =
            target.scatter(points).filter(|_| known).unwrap_or_else(|| vec![mean.max(f64::MIN_POSITIVE); points.len()]);
        points.iter().zip(size).map(|(point, size)| if point.computed.is_some() { 1.0 / size } else { 0.0 }).collect()
    };
    let weights: Vec<Vec<f64>> = spec.targets.iter().zip(first).map(of).collect();
    let used = |weights: &Vec<f64>| weights.iter().filter(|weight| **weight > 0.0).count();
    for ((target, (points, curve)), weights) in spec.targets.iter().zip(first).zip(&weights) {
        if used(weights) == 0 {
            let span = |all: &mut dyn Iterator<Item = f64>| {
                let (low, high) = all.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
                format!("{low:.4} to {high:.4}")
            };
            let measured = span(&mut points.iter().map(|p| p.x));
            let run = span(&mut curve.iter().map(|p| p.0));
            let what = format!(
                "{} does not overlap the run: {} is {measured} in the file and {run} in the run",
                target.path.display(),
                target.spec.x
            );
            return Err(StudyError::new(what, "check its unit and where its travel begins"));
        }
    }
    let count: usize = weights.iter().map(used).sum();
    if count <= spec.ranges.len() {
        let what = format!("{count} points for {} keys", spec.ranges.len());
        return Err(StudyError::new(what, "a fit needs more points than keys: fewer --vary, or more of the curve"));
    }
    Ok(weights)
}

fn matched(spec: &CaseFitSpec, first: Beside, last: Beside, weights: &[Vec<f64>]) -> Result<Vec<Matched>, StudyError> {
    let case = spec.subject.case(&[])?;
    let nothing = Computed::nothing(case.model());
    let known = is_known(spec, &first);
    let of = |(((target, (_, before)), (points, after)), weights): (((&Target, _), _), &Vec<f64>)| {
        let (x, y) = target.spec.quantity.columns(&nothing);
        let left_out = weights.iter().filter(|weight| **weight == 0.0).count();
        Matched { name: target.name(), axes: [x.axis(), y.axis()], is_weighted: known, points, left_out, before, after }
    };
    Ok(spec.targets.iter().zip(first).zip(last).zip(weights).map(of).collect())
}
