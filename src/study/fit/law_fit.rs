//! Hardening laws fitted to tension tests, with a rate law if the tests differ in their rate.

use super::estimate::{Correlated, Estimate, estimates};
use super::flow_curve::{FlowCurve, FlowPoint};
use super::hardening::{HardeningKind, ParameterRange, RateKind};
use crate::material::hardening::Hardening;
use crate::material::rate::Rate;
use crate::numerics::least_squares::{Limits, Parameter, minimise};
use crate::study::{StudyError, fail};

/// A fitted law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFit {
    /// Its kind.
    pub kind: HardeningKind,
    /// The law with its parameters.
    pub hardening: Hardening,
    pub(super) rate: Option<Rate>,
    /// Its parameters, those of the rate law last.
    pub estimates: Vec<Estimate>,
    pub(super) correlated: Vec<Correlated>,
    /// Law less point, in the order of the points \[MPa\].
    pub(super) misses: Vec<f64>,
    /// Root mean square of the misses \[MPa\].
    pub rms: f64,
    /// Share of the points' variance that the law explains \[–\].
    pub r2: f64,
    pub(super) aic: f64,
}

/// Laws fitted to the same tests.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFits {
    /// All tests.
    pub tests: Vec<FlowCurve>,
    pub(super) fits: Vec<LawFit>,
    /// Index of the law with the smallest criterion, of those within their ranges.
    best: usize,
    /// Directions of the sheet.
    pub directions: Vec<Direction>,
}

/// A direction of the sheet: means of its tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// Angle to the rolling direction \[°\].
    pub(super) angle: f64,
    pub(super) tests: usize,
    /// Mean stress over that of the law, which is of the first direction \[–\].
    pub ratio: f64,
    /// r-value and its standard error \[–\].
    pub(super) r: Option<(f64, f64)>,
}

const LIMITS: Limits = Limits { steps: 200, change: 1e-9 };
const FOLLOWED: usize = 3;
/// Half of a central difference over the parameter \[–\].
const DIFFERENCE: f64 = 1e-5;
/// Least variance of perfect data in the criterion \[MPa²\].
const ROUND_OFF: f64 = 1e-8;
/// Correlation from which parameters cannot be told apart \[–\].
const TIED: f64 = 0.98;

/// Fits all laws, or the wanted one, to the tests in the first direction, 0° if there is one.
pub fn fit_laws(tests: Vec<FlowCurve>, wanted: Option<HardeningKind>, rate: RateKind) -> Result<LawFits, StudyError> {
    let kinds = wanted.map_or_else(|| HardeningKind::ALL.to_vec(), |kind| vec![kind]);
    let fitted: Vec<&FlowCurve> = in_first_direction(&tests).collect();
    let results = kinds.into_iter().map(|kind| LawFit::new(kind, &fitted, rate));
    let (fits, errors): (Vec<_>, Vec<_>) = results.partition(Result::is_ok);
    let fits: Vec<LawFit> = fits.into_iter().flatten().collect();
    let is_bound = |fit: &LawFit| fit.estimates.iter().any(|e| e.bound.is_some());
    let order = |a: &usize, b: &usize| {
        let (a, b) = (&fits[*a], &fits[*b]);
        is_bound(a).cmp(&is_bound(b)).then(a.aic.total_cmp(&b.aic))
    };
    let Some(best) = (0..fits.len()).min_by(order) else {
        let error = errors.into_iter().find_map(Result::err);
        return error.map_or_else(|| fail("no law is asked for", "name one by --law"), Err);
    };
    let mut angles: Vec<f64> = tests.iter().filter_map(|test| test.direction).collect();
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let directions = angles.into_iter().map(|angle| Direction::new(angle, &tests, &fits[best])).collect();
    Ok(LawFits { tests, fits, best, directions })
}

fn in_first_direction(tests: &[FlowCurve]) -> impl Iterator<Item = &FlowCurve> {
    let mut angles = tests.iter().filter_map(|test| test.direction);
    let first = angles.clone().find(|angle| *angle == 0.0).or(angles.next());
    tests.iter().filter(move |test| test.direction == first)
}

impl Direction {
    fn new(angle: f64, tests: &[FlowCurve], law: &LawFit) -> Self {
        let own: Vec<&FlowCurve> = tests.iter().filter(|test| test.direction == Some(angle)).collect();
        let pairs = own.iter().flat_map(|test| test.points.iter().map(|point| (point, test.rate)));
        let ratios: Vec<f64> = pairs.map(|(point, rate)| point.stress / law.stress(point.strain, rate)).collect();
        let r: Vec<(f64, f64)> = own.iter().filter_map(|test| test.r).collect();
        let count = r.len() as f64;
        let mean = || r.iter().map(|r| r.0).sum::<f64>() / count;
        let error = || r.iter().map(|r| r.1 * r.1).sum::<f64>().sqrt() / count;
        let ratio = ratios.iter().sum::<f64>() / ratios.len() as f64;
        Self { angle, tests: own.len(), ratio, r: (!r.is_empty()).then(|| (mean(), error())) }
    }
}

impl LawFit {
    fn new(kind: HardeningKind, tests: &[&FlowCurve], rate: RateKind) -> Result<Self, StudyError> {
        let slowest = tests.iter().filter_map(|test| test.rate).fold(f64::INFINITY, f64::min);
        let rate = Some(rate).filter(|_| tests.iter().any(|test| test.rate.is_some_and(|rate| rate > slowest)));
        let (rate_ranges, rate_starts): (Vec<_>, Vec<f64>) = rate.into_iter().flat_map(RateKind::parameters).unzip();
        let mut ranges = kind.parameters();
        let split = ranges.len();
        ranges.extend(rate_ranges);
        let points: Vec<(FlowPoint, Option<f64>)> =
            tests.iter().flat_map(|test| test.points.iter().map(|point| (*point, test.rate))).collect();
        if points.len() <= ranges.len() {
            let what = format!("{} points for the {} parameters of {}", points.len(), ranges.len(), kind.label());
            return fail(what, "a fit needs more points than parameters: another --law, or more points");
        }
        let is_weighted = points.iter().all(|(point, _)| point.scatter.is_some());
        let weight = |point: &FlowPoint| point.scatter.filter(|_| is_weighted).map_or(1.0, |scatter| 1.0 / scatter);
        let laws =
            |values: &[f64]| Some((kind.law(&values[..split])?, rate.map(|rate| rate.law(&values[split..], slowest))));
        let misses = |values: &[f64]| -> Option<Vec<f64>> {
            let (law, rate) = laws(values)?;
            Some(points.iter().map(|(point, at)| stress(&law, rate, point.strain, *at) - point.stress).collect())
        };
        let residuals = |values: &[f64]| -> Option<Vec<f64>> {
            Some(misses(values)?.into_iter().zip(&points).map(|(miss, (point, _))| miss * weight(point)).collect())
        };
        let mut all = |points: &[Vec<f64>]| points.iter().map(|point| residuals(point)).collect::<Vec<_>>();
        let parameters = |start: Vec<f64>| -> Vec<Parameter> {
            let parameter = |(range, start): (&ParameterRange, f64)| {
                let start = start.clamp(range.low, range.high);
                let step = DIFFERENCE * start.abs().max(1e-3 * (range.high - range.low).min(1.0));
                Parameter { start, low: range.low, high: range.high, step }
            };
            ranges.iter().zip(start.into_iter().chain(rate_starts.iter().copied())).map(parameter).collect()
        };
        let sum = |start: &[Parameter]| {
            let start: Vec<f64> = start.iter().map(|p| p.start).collect();
            residuals(&start).map_or(f64::INFINITY, |r| r.iter().map(|r| r * r).sum::<f64>())
        };
        let plain: Vec<(f64, f64)> = points.iter().map(|(point, _)| (point.strain, point.stress)).collect();
        let mut starts: Vec<Vec<Parameter>> = kind.starts(&plain).into_iter().map(parameters).collect();
        starts.retain(|start| sum(start).is_finite());
        starts.sort_by(|a, b| sum(a).total_cmp(&sum(b)));
        let minima = starts.iter().take(FOLLOWED).filter_map(|start| Some((minimise(start, &mut all, LIMITS)?, start)));
        let best = minima.min_by(|a, b| a.0.sum().total_cmp(&b.0.sum()));
        let solved = best.and_then(|best| Some((laws(&best.0.values)?, misses(&best.0.values)?, best)));
        let Some(((hardening, rate), misses, (minimum, parameters))) = solved else {
            let what = format!("{} cannot be fitted to the points", kind.label());
            return fail(what, "do stresses rise with the strain?");
        };
        let names: Vec<(&str, &str)> = ranges.iter().map(|range| (range.key, range.unit)).collect();
        let (estimates, correlated) = estimates(&names, parameters, &minimum, is_weighted, TIED);
        let squares = || points.iter().map(|(point, _)| (weight(point).powi(2), point.stress));
        let mean = squares().map(|(w, stress)| w * stress).sum::<f64>() / squares().map(|(w, _)| w).sum::<f64>();
        let variance = squares().map(|(w, stress)| w * (stress - mean).powi(2)).sum::<f64>();
        // n ln(S/n) + 2k + 2k(k + 1)/(n − k − 1), k with the variance.
        let (n, k) = (points.len() as f64, ranges.len() as f64 + 1.0);
        let few = 2.0 * k * (k + 1.0) / (n - k - 1.0).max(0.5);
        Ok(Self {
            kind,
            hardening,
            rate,
            estimates,
            correlated,
            rms: (misses.iter().map(|miss| miss * miss).sum::<f64>() / n).sqrt(),
            misses,
            r2: 1.0 - minimum.sum() / variance,
            aic: n * (minimum.sum() / n).max(ROUND_OFF).ln() + 2.0 * k + few,
        })
    }

    /// Stress at a strain and a rate \[MPa\].
    pub(super) fn stress(&self, strain: f64, rate: Option<f64>) -> f64 {
        stress(&self.hardening, self.rate, strain, rate)
    }

    /// A parameter by its name.
    pub fn estimate(&self, key: &str) -> Option<&Estimate> {
        self.estimates.iter().find(|estimate| estimate.key == key)
    }
}

fn stress(law: &Hardening, rate: Option<Rate>, strain: f64, at: Option<f64>) -> f64 {
    law.at(strain).stress * rate.zip(at).map_or(1.0, |(rate, at)| rate.at(at).value)
}

impl LawFits {
    /// The best law.
    pub fn best(&self) -> &LawFit {
        &self.fits[self.best]
    }

    pub(super) fn fitted(&self) -> impl Iterator<Item = &FlowCurve> {
        in_first_direction(&self.tests)
    }

    /// Largest plastic strain of the points \[–\].
    pub fn end(&self) -> f64 {
        self.fitted().map(FlowCurve::end).fold(0.0, f64::max)
    }

    /// r-values at 0°, 45° and 90°, if all three were measured.
    pub fn r_values(&self) -> Option<[f64; 3]> {
        let at = |angle: f64| Some(self.directions.iter().find(|d| d.angle == angle)?.r?.0);
        Some([at(0.0)?, at(45.0)?, at(90.0)?])
    }
}
