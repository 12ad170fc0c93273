//! Hardening laws fitted to tension tests, with a power of the rate if the tests differ in their rate.

use super::estimate::{Estimate, estimates};
use super::flow_curve::FlowCurve;
use super::law::{HardeningKind, ParameterRange};
use super::tension::FlowPoint;
use crate::material::hardening::Hardening;
use crate::material::rate::{PowerRate, Rate};
use crate::numerics::least_squares::{Parameter, minimise};
use crate::study::error::ensure;
use crate::study::{StudyError, fail};
use std::cmp::Ordering;

/// A fitted law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFit {
    /// Its kind.
    pub kind: HardeningKind,
    /// The law with its parameters.
    pub hardening: Hardening,
    pub(super) rate: Option<PowerRate>,
    /// Its parameters, that of the rate last.
    pub estimates: Vec<Estimate>,
    /// Root mean square of law less point \[MPa\].
    pub rms: f64,
    /// Akaike's criterion.
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

const MOST_STEPS: usize = 200;
const LEAST_CHANGE: f64 = 1e-9;
const FOLLOWED: usize = 3;
/// Half of a central difference over the parameter \[–\].
const DIFFERENCE: f64 = 1e-5;
/// Least variance of perfect data in the criterion \[MPa²\].
const ROUND_OFF: f64 = 1e-8;
/// Exponent of the rate and its start \[–\].
const EXPONENT: (ParameterRange, f64) = (("rate.exponent", "", 0.0, 1.0), 0.02);

/// Fits all laws, or the wanted one, to the tests in the first direction, 0° if there is one.
pub fn fit_laws(tests: Vec<FlowCurve>, wanted: Option<HardeningKind>) -> Result<LawFits, StudyError> {
    let kinds = wanted.map_or_else(|| HardeningKind::ALL.to_vec(), |kind| vec![kind]);
    let fitted: Vec<&FlowCurve> = in_first_direction(&tests).collect();
    let (fits, errors): (Vec<_>, Vec<_>) =
        kinds.into_iter().map(|kind| LawFit::new(kind, &fitted)).partition(Result::is_ok);
    let fits: Vec<LawFit> = fits.into_iter().flatten().collect();
    let rank = |i: &usize| (fits[*i].estimates.iter().any(|e| e.bound.is_some()), fits[*i].aic);
    let by_rank = |a: &usize, b: &usize| rank(a).partial_cmp(&rank(b)).unwrap_or(Ordering::Equal);
    let Some(best) = (0..fits.len()).min_by(by_rank) else {
        let error = errors.into_iter().find_map(Result::err);
        return Err(error.unwrap_or_else(|| StudyError::new("no law is asked for", "name one by --law")));
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
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let own: Vec<&FlowCurve> = tests.iter().filter(|test| test.direction == Some(angle)).collect();
        let pairs = own.iter().flat_map(|test| test.points.iter().map(|point| (point, test.rate)));
        let ratios: Vec<f64> = pairs.map(|(point, rate)| point.stress / law.stress(point.strain, rate)).collect();
        let (r, errors): (Vec<f64>, Vec<f64>) = own.iter().filter_map(|test| test.r).unzip();
        let error = errors.iter().map(|error| error * error).sum::<f64>().sqrt() / r.len() as f64;
        Self { angle, tests: own.len(), ratio: mean(&ratios), r: (!r.is_empty()).then(|| (mean(&r), error)) }
    }
}

impl LawFit {
    fn new(kind: HardeningKind, tests: &[&FlowCurve]) -> Result<Self, StudyError> {
        let slowest = tests.iter().filter_map(|test| test.rate).fold(f64::INFINITY, f64::min);
        let exponent = tests.iter().any(|test| test.rate > Some(slowest)).then_some(EXPONENT);
        let ranges: Vec<ParameterRange> = kind.parameters().into_iter().chain(exponent.map(|e| e.0)).collect();
        let points: Vec<(FlowPoint, Option<f64>)> =
            tests.iter().flat_map(|test| test.points.iter().map(|point| (*point, test.rate))).collect();
        let what = format!("{} points for the {} parameters of {}", points.len(), ranges.len(), kind.label());
        let help = "a fit needs more points than parameters: another --law, or more points";
        ensure(points.len() > ranges.len(), what, help)?;
        let laws = |values: &[f64]| {
            let rate = exponent.map(|_| PowerRate { exponent: values[ranges.len() - 1], reference: slowest });
            Some((kind.law(values)?, rate))
        };
        let is_weighted = points.iter().all(|(point, _)| point.scatter.is_some());
        let size = |point: &FlowPoint| point.scatter.filter(|_| is_weighted).unwrap_or(1.0);
        let residuals = |values: &Vec<f64>| -> Option<Vec<f64>> {
            let (law, rate) = laws(values)?;
            let miss = |point: &FlowPoint, at| stress(&law, rate, point.strain, at) - point.stress;
            Some(points.iter().map(|(point, at)| miss(point, *at) / size(point)).collect())
        };
        let parameters = |start: Vec<f64>| -> Vec<Parameter> {
            let parameter = |(&(_, _, low, high), start): (&ParameterRange, f64)| {
                let start = start.clamp(low, high);
                let step = DIFFERENCE * start.abs().max(1e-3 * (high - low).min(1.0));
                Parameter { start, low, high, step }
            };
            ranges.iter().zip(start.into_iter().chain(exponent.map(|e| e.1))).map(parameter).collect()
        };
        let squares = |all: &[f64]| all.iter().map(|r| r * r).sum::<f64>();
        let plain: Vec<(f64, f64)> = points.iter().map(|(point, _)| (point.strain, point.stress)).collect();
        let sum = |start: &Vec<Parameter>| {
            residuals(&start.iter().map(|p| p.start).collect()).map_or(f64::INFINITY, |all| squares(&all))
        };
        let mut starts: Vec<Vec<Parameter>> = kind.starts(&plain).into_iter().map(parameters).collect();
        starts.retain(|start| sum(start).is_finite());
        starts.sort_by(|a, b| sum(a).total_cmp(&sum(b)));
        let mut all = |points: &[Vec<f64>]| points.iter().map(residuals).collect::<Vec<_>>();
        let minima = starts.iter().take(FOLLOWED);
        let minima = minima.filter_map(|start| Some((minimise(start, &mut all, MOST_STEPS, LEAST_CHANGE)?, start)));
        let best = minima.min_by(|a, b| a.0.sum().total_cmp(&b.0.sum()));
        let solved = best.and_then(|(minimum, start)| Some((laws(&minimum.values)?, minimum, start)));
        let Some(((hardening, rate), minimum, parameters)) = solved else {
            let what = format!("{} cannot be fitted to the points", kind.label());
            return fail(what, "do stresses rise with the strain?");
        };
        let estimates = estimates(ranges.iter().map(|range| (range.0, range.1)), parameters, &minimum, is_weighted);
        // n ln(S/n) + 2k + 2k(k + 1)/(n − k − 1), k with the variance.
        let (n, k) = (points.len() as f64, ranges.len() as f64 + 1.0);
        let few = 2.0 * k * (k + 1.0) / (n - k - 1.0).max(0.5);
        let misses: Vec<f64> = minimum.residuals.iter().zip(&points).map(|(r, (point, _))| r * size(point)).collect();
        let aic = n * (minimum.sum() / n).max(ROUND_OFF).ln() + 2.0 * k + few;
        Ok(Self { kind, hardening, rate, estimates, rms: (squares(&misses) / n).sqrt(), aic })
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

fn stress(law: &Hardening, rate: Option<PowerRate>, strain: f64, at: Option<f64>) -> f64 {
    law.at(strain).stress * rate.zip(at).map_or(1.0, |(rate, at)| Rate::PowerRate(rate).at(at).value)
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
