//! Hardening laws fitted to tension tests, with a rate law if the tests differ in their rate.

use super::estimate::{Estimate, correlated, estimates};
use super::flow_curve::{FlowCurve, FlowPoint};
use super::hardening::{HardeningKind, RateKind};
use crate::material::hardening::Hardening;
use crate::material::rate::Rate;
use crate::numerics::least_squares::{Limits, Minimum, Parameter, minimise};
use crate::study::StudyError;

/// A fitted law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFit {
    /// Its kind.
    pub kind: HardeningKind,
    /// The law with its parameters.
    pub hardening: Hardening,
    /// Rate law, if the tests differ in their rate.
    pub rate: Option<Rate>,
    /// Its parameters, those of the rate law last.
    pub estimates: Vec<Estimate>,
    /// Pairs of parameters that the points cannot tell apart, with their correlation.
    pub correlated: Vec<(usize, usize, f64)>,
    /// Law less point, in the order of the points \[MPa\].
    pub misses: Vec<f64>,
    /// Root mean square of the misses \[MPa\].
    pub rms: f64,
    /// Share of the points' variance that the law explains \[–\].
    pub r2: f64,
    /// Akaike's criterion with the correction for few points; the smaller, the better.
    pub aic: f64,
}

/// Laws fitted to the same tests.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFits {
    /// All tests.
    pub tests: Vec<FlowCurve>,
    /// Each law.
    pub fits: Vec<LawFit>,
    /// Index of the law with the smallest criterion, of those within their ranges.
    pub best: usize,
    /// Directions of the sheet; empty if none is given.
    pub directions: Vec<Direction>,
}

/// A direction of the sheet: means of its tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// To the rolling direction \[°\].
    pub angle: f64,
    /// Number of tests.
    pub tests: usize,
    /// Mean stress over that of the law, which is of the first direction \[–\].
    pub ratio: f64,
    /// r-value \[–\].
    pub r: Option<f64>,
    /// Standard error of r \[–\].
    pub r_error: Option<f64>,
}

const LIMITS: Limits = Limits { steps: 200, change: 1e-9 };
/// Starting points that are followed.
const FOLLOWED: usize = 3;
/// Half of a central difference over the parameter \[–\].
const DIFFERENCE: f64 = 1e-5;
/// Least variance of perfect data in the criterion \[MPa²\].
const ROUND_OFF: f64 = 1e-8;
/// Correlation from which parameters cannot be told apart \[–\].
const TIED: f64 = 0.98;

/// Fits laws to tests: all, or the wanted one. Tests in the first direction, 0° if there is one, are fitted to.
///
/// # Errors
/// When no law can be fitted.
pub fn fit_laws(tests: Vec<FlowCurve>, wanted: Option<HardeningKind>, rate: RateKind) -> Result<LawFits, StudyError> {
    let kinds = wanted.map_or_else(|| HardeningKind::ALL.to_vec(), |kind| vec![kind]);
    let mut angles: Vec<f64> = tests.iter().filter_map(|test| test.direction).collect();
    let first = angles.iter().copied().find(|angle| *angle == 0.0).or(angles.first().copied());
    let fitted: Vec<&FlowCurve> = tests.iter().filter(|test| test.direction == first).collect();
    let (mut fits, mut wrong) = (Vec::new(), None);
    for kind in kinds {
        match LawFit::new(kind, &fitted, rate) {
            Ok(fit) => fits.push(fit),
            Err(error) => wrong = wrong.or(Some(error)),
        }
    }
    let rank = |fit: &LawFit| (fit.estimates.iter().any(|e| e.bound.is_some()), fit.aic);
    let order = |a: &usize, b: &usize| {
        let (a, b) = (rank(&fits[*a]), rank(&fits[*b]));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    };
    let Some(best) = (0..fits.len()).min_by(order) else {
        return Err(wrong.unwrap_or_else(|| StudyError::new("no law is asked for", "name one by --law")));
    };
    angles.sort_by(f64::total_cmp);
    angles.dedup();
    let directions = angles.into_iter().map(|angle| direction(angle, &tests, &fits[best])).collect();
    Ok(LawFits { tests, fits, best, directions })
}

fn direction(angle: f64, tests: &[FlowCurve], law: &LawFit) -> Direction {
    let own: Vec<&FlowCurve> = tests.iter().filter(|test| test.direction == Some(angle)).collect();
    let stress = |test: &FlowCurve, point: &FlowPoint| point.stress / law.stress(point.strain, test.rate);
    let ratios: Vec<f64> = own.iter().flat_map(|test| test.points.iter().map(|point| stress(test, point))).collect();
    let r: Vec<(f64, f64)> = own.iter().filter_map(|test| test.r).collect();
    let count = r.len() as f64;
    Direction {
        angle,
        tests: own.len(),
        ratio: ratios.iter().sum::<f64>() / ratios.len() as f64,
        r: (!r.is_empty()).then(|| r.iter().map(|r| r.0).sum::<f64>() / count),
        r_error: (!r.is_empty()).then(|| r.iter().map(|r| r.1 * r.1).sum::<f64>().sqrt() / count),
    }
}

impl LawFit {
    /// Fits a law to tests, and a rate law if they have several rates.
    ///
    /// # Errors
    /// When there are no more points than parameters, or the law cannot be fitted.
    pub fn new(kind: HardeningKind, tests: &[&FlowCurve], rate: RateKind) -> Result<Self, StudyError> {
        let rates: Vec<f64> = tests.iter().filter_map(|test| test.rate).collect();
        let slowest = rates.iter().copied().fold(f64::INFINITY, f64::min);
        let has_rate = rates.iter().any(|rate| *rate > slowest);
        let mut ranges = kind.parameters();
        let split = ranges.len();
        let rate_parameters = if has_rate { rate.parameters() } else { Vec::new() };
        ranges.extend(rate_parameters.iter().map(|(range, _)| *range));
        let points: Vec<(&FlowPoint, Option<f64>)> =
            tests.iter().flat_map(|test| test.points.iter().map(|point| (point, test.rate))).collect();
        if points.len() <= ranges.len() {
            let what = format!("{} points for the {} parameters of {}", points.len(), ranges.len(), kind.label());
            return Err(StudyError::new(
                what,
                "a fit needs more points than parameters: another --law, or more points",
            ));
        }
        let is_weighted = points.iter().all(|(point, _)| point.scatter.is_some());
        let weight = |point: &FlowPoint| point.scatter.filter(|_| is_weighted).map_or(1.0, |scatter| 1.0 / scatter);
        let stresses = |values: &[f64]| -> Option<Vec<f64>> {
            let law = kind.law(&values[..split])?;
            let rate = has_rate.then(|| rate.law(&values[split..], slowest));
            let factor = |at: Option<f64>| rate.zip(at).map_or(1.0, |(law, at)| law.at(at).value);
            Some(points.iter().map(|(point, at)| law.at(point.strain).stress * factor(*at)).collect())
        };
        let residuals = |values: &[f64]| -> Option<Vec<f64>> {
            let pairs = stresses(values)?.into_iter().zip(&points);
            Some(pairs.map(|(stress, (point, _))| (stress - point.stress) * weight(point)).collect())
        };
        let parameters = |start: &[f64]| -> Vec<Parameter> {
            let starts = start.iter().copied().chain(rate_parameters.iter().map(|(_, start)| *start));
            let parameter = |(range, start): (&super::hardening::ParameterRange, f64)| {
                let start = start.clamp(range.low, range.high);
                let step = DIFFERENCE * start.abs().max(1e-3 * (range.high - range.low).min(1.0));
                Parameter { start, low: range.low, high: range.high, step }
            };
            ranges.iter().zip(starts).map(parameter).collect()
        };
        let plain: Vec<(f64, f64)> = points.iter().map(|(point, _)| (point.strain, point.stress)).collect();
        let sum = |start: &[f64]| {
            let start: Vec<f64> = parameters(start).iter().map(|p| p.start).collect();
            residuals(&start).map_or(f64::INFINITY, |r| r.iter().map(|r| r * r).sum::<f64>())
        };
        let mut starts = kind.starts(&plain);
        starts.retain(|start| sum(start).is_finite());
        starts.sort_by(|a, b| sum(a).total_cmp(&sum(b)));
        let minima = starts.iter().take(FOLLOWED).filter_map(|start| {
            let parameters = parameters(start);
            minimise(&parameters, &residuals, LIMITS).map(|minimum| (minimum, parameters))
        });
        let none = || {
            let what = format!("{} cannot be fitted to the points", kind.label());
            StudyError::new(what, "do stresses rise with the strain?")
        };
        let best = minima.min_by(|a, b| a.0.sum().total_cmp(&b.0.sum()));
        let (minimum, parameters) = best.ok_or_else(none)?;
        let names: Vec<(String, String)> = ranges.iter().map(|r| (r.key.to_owned(), r.unit.to_owned())).collect();
        let least = if is_weighted { 1.0 } else { 0.0 };
        let (estimates, covariance) = estimates(&names, &parameters, &minimum, least);
        let stresses = stresses(&minimum.values).unwrap_or_default();
        let misses: Vec<f64> = stresses.iter().zip(&points).map(|(stress, (point, _))| stress - point.stress).collect();
        Ok(Self {
            kind,
            hardening: kind.law(&minimum.values[..split]).ok_or_else(none)?,
            rate: has_rate.then(|| rate.law(&minimum.values[split..], slowest)),
            estimates,
            correlated: correlated(covariance.as_ref(), TIED),
            rms: (misses.iter().map(|miss| miss * miss).sum::<f64>() / misses.len() as f64).sqrt(),
            misses,
            r2: r2(&minimum, &points, weight),
            aic: aic(&minimum, ranges.len()),
        })
    }

    /// Stress at a strain and a rate \[MPa\].
    pub fn stress(&self, strain: f64, rate: Option<f64>) -> f64 {
        let factor = self.rate.zip(rate).map_or(1.0, |(law, rate)| law.at(rate).value);
        self.hardening.at(strain).stress * factor
    }

    /// A parameter by its name.
    pub fn estimate(&self, key: &str) -> Option<&Estimate> {
        self.estimates.iter().find(|estimate| estimate.key == key)
    }
}

fn r2(minimum: &Minimum, points: &[(&FlowPoint, Option<f64>)], weight: impl Fn(&FlowPoint) -> f64) -> f64 {
    let squares = || points.iter().map(|(point, _)| (weight(point).powi(2), point.stress));
    let mean = squares().map(|(w, stress)| w * stress).sum::<f64>() / squares().map(|(w, _)| w).sum::<f64>();
    1.0 - minimum.sum() / squares().map(|(w, stress)| w * (stress - mean).powi(2)).sum::<f64>()
}

/// n ln(S/n) + 2k + 2k(k + 1)/(n − k − 1), k with the variance.
fn aic(minimum: &Minimum, count: usize) -> f64 {
    let (n, k) = (minimum.residuals.len() as f64, count as f64 + 1.0);
    n * (minimum.sum() / n).max(ROUND_OFF).ln() + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0).max(0.5)
}

impl LawFits {
    /// The best law.
    pub fn best(&self) -> &LawFit {
        &self.fits[self.best]
    }

    /// Tests that laws are fitted to.
    pub fn fitted(&self) -> impl Iterator<Item = &FlowCurve> {
        let zero = self.directions.iter().map(|d| d.angle).find(|angle| *angle == 0.0);
        let first = zero.or(self.tests.iter().find_map(|test| test.direction));
        self.tests.iter().filter(move |test| test.direction == first)
    }

    /// Largest plastic strain of the points \[–\].
    pub fn end(&self) -> f64 {
        self.fitted().map(FlowCurve::end).fold(0.0, f64::max)
    }

    /// r-values at 0°, 45° and 90°, if all three were measured.
    pub fn r_values(&self) -> Option<[f64; 3]> {
        let at = |angle: f64| self.directions.iter().find(|d| d.angle == angle)?.r;
        Some([at(0.0)?, at(45.0)?, at(90.0)?])
    }
}
