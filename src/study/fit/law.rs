//! Hardening laws fitted to tension tests, with a power of the rate if the tests differ in their rate.

use super::{Estimate, estimates, flow_curve::FlowCurve, flow_curve::straight_line, tension::FlowPoint};
use crate::material::hardening::{Hardening, HockettSherby, Ludwik, Swift, Voce};
use crate::material::rate::{PowerRate, Rate};
use crate::numerics::{least_squares::Parameter, least_squares::minimise, statistics::block_means};
use crate::study::{Result, StudyError, Watch, ensure};
use statrs::statistics::Statistics;
use std::{cmp::Ordering, str::FromStr};

named! {
    /// A hardening law of the solver.
    pub enum HardeningKind;
    /// Name as people write it.
    fn label;
    Swift: "Swift", "k (offset + ε)^n.";
    Voce: "Voce", "saturation − (saturation − initial) exp(−rate ε).";
    HockettSherby: "Hockett-Sherby", "Voce's law with a power of ε.";
    Ludwik: "Ludwik", "initial + k ε^n.";
}

/// Strain \[–\], stress and its standard deviation or 1 \[MPa\], strain rate \[1/s\].
type Row = [f64; 4];

/// Name, unit (`MPa` or none), least and largest value.
type ParameterRange = (&'static str, &'static str, f64, f64);

impl HardeningKind {
    /// Name on the command line.
    pub fn name(self) -> String {
        self.label().to_lowercase()
    }

    fn parameters(self) -> Vec<ParameterRange> {
        let (stress, rate) = (|key| (key, "MPa", 1.0, 1e5), ("rate", "", 0.0, 1e3));
        match self {
            Self::Swift => vec![stress("k"), ("n", "", 0.0, 1.0), ("offset", "", 1e-6, 1.0)],
            Self::Voce => vec![stress("initial"), stress("saturation"), rate],
            Self::HockettSherby => vec![stress("initial"), stress("saturation"), rate, ("exponent", "", 0.05, 1.0)],
            Self::Ludwik => vec![stress("initial"), stress("k"), ("n", "", 0.01, 1.0)],
        }
    }

    /// The solver's law of some parameters; `None` if they make none.
    pub fn law(self, p: &[f64]) -> Option<Hardening> {
        match self {
            Self::Swift => Swift::new(p[0], p[1], p[2]).ok().map(Hardening::Swift),
            Self::Voce => Voce::new(p[0], p[1], p[2], 1.0).ok().map(Hardening::Voce),
            Self::HockettSherby => HockettSherby::new(p[0], p[1], p[2], p[3]).ok().map(Hardening::HockettSherby),
            Self::Ludwik => Ludwik::new(p[0], p[1], p[2]).ok().map(Hardening::Ludwik),
        }
    }

    fn starts(self, rows: &[Row]) -> Vec<Vec<f64>> {
        let line = |x: &dyn Fn(f64) -> f64, y: fn(f64) -> f64| {
            straight_line(rows.iter().map(|row| [x(row[0].max(0.0)), y(row[1])]).collect())
        };
        let swift = |offset: f64| {
            let [k, n, _] = line(&|e| (offset + e).ln(), |stress| stress.max(1.0).ln());
            vec![k.exp(), n, offset]
        };
        let saturating = |rate: f64, exponent: f64| {
            let [end, span, _] = line(&|e| (-rate * e.powf(exponent)).exp(), |stress| stress);
            vec![end + span, end, rate, exponent]
        };
        let ludwik = |n: f64| {
            let [initial, k, _] = line(&|e| e.powf(n), |stress| stress);
            vec![initial, k, n]
        };
        let rates = [1.0, 3.0, 8.0, 20.0, 60.0];
        match self {
            Self::Swift => [1e-4, 1e-3, 5e-3, 2e-2, 0.1].map(swift).to_vec(),
            Self::Voce => rates.map(|rate| saturating(rate, 1.0)[..3].to_vec()).to_vec(),
            Self::HockettSherby => rates.map(|rate| saturating(rate, 0.75)).to_vec(),
            Self::Ludwik => [0.2, 0.4, 0.6, 0.8].map(ludwik).to_vec(),
        }
    }
}

impl FromStr for HardeningKind {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        let kind = Self::ALL.into_iter().find(|kind| kind.name() == name);
        kind.ok_or_else(|| format!("the laws are {}", Self::ALL.map(Self::name).join(", ")))
    }
}

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

const MOST_STEPS: usize = 2000;
const LEAST_CHANGE: f64 = 1e-9;
/// Most means of successive rows in the search of a minimum, a hundred a parameter.
pub(super) const MEANS: usize = 400;
/// Most steps on all rows from the minimum of means, which is nearer to theirs than a standard error.
const CORRECTIONS: usize = 5;
/// Half of a central difference over the parameter \[–\].
const DIFFERENCE: f64 = 1e-5;
/// Least variance of perfect data in the criterion \[MPa²\].
const ROUND_OFF: f64 = 1e-8;
/// Exponent of the rate and its start \[–\].
const EXPONENT: (ParameterRange, f64) = (("rate.exponent", "", 0.0, 1.0), 0.02);

/// Fits all laws, or the wanted one, to the tests in the first direction, 0° if there is one.
pub fn fit_laws(tests: Vec<FlowCurve>, law: Option<HardeningKind>, watch: &dyn Watch) -> Result<LawFits> {
    let kinds = law.map_or_else(|| HardeningKind::ALL.to_vec(), |kind| vec![kind]);
    let fitted: Vec<&FlowCurve> = in_first_direction(&tests).collect();
    let (mut fits, mut errors) = (Vec::new(), Vec::new());
    for (i, kind) in kinds.iter().enumerate() {
        LawFit::new(*kind, &fitted, watch).map_or_else(|error| errors.push(error), |fit| fits.push(fit));
        ensure(!watch.wants_to_stop(), "interrupted", "begin again")?;
        watch.ran(i + 1, kinds.len());
    }
    let rank = |i: &usize| (fits[*i].estimates.iter().any(|e| e.bound.is_some()), fits[*i].aic);
    let by_rank = |a: &usize, b: &usize| rank(a).partial_cmp(&rank(b)).unwrap_or(Ordering::Equal);
    let best = (0..fits.len()).min_by(by_rank).ok_or_else(|| errors.swap_remove(0))?;
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
        let ratios = pairs.map(|(point, rate)| point.stress / law.stress(point.strain, rate));
        let (r, errors): (Vec<f64>, Vec<f64>) = own.iter().filter_map(|test| test.r).unzip();
        let error = errors.iter().map(|error| error * error).sum::<f64>().sqrt() / r.len() as f64;
        Self { angle, tests: own.len(), ratio: ratios.mean(), r: (!r.is_empty()).then(|| (r.mean(), error)) }
    }
}

impl LawFit {
    fn new(kind: HardeningKind, tests: &[&FlowCurve], watch: &dyn Watch) -> Result<Self> {
        let slowest = tests.iter().filter_map(|test| test.rate).fold(f64::INFINITY, f64::min);
        let exponent = tests.iter().any(|test| test.rate > Some(slowest)).then_some(EXPONENT);
        let ranges: Vec<ParameterRange> = kind.parameters().into_iter().chain(exponent.map(|e| e.0)).collect();
        let is_weighted = tests.iter().all(|test| test.points.iter().all(|point| point.scatter.is_some()));
        let row = |test: &FlowCurve, point: &FlowPoint| {
            let size = point.scatter.filter(|_| is_weighted).unwrap_or(1.0);
            [point.strain, point.stress, size, test.rate.unwrap_or(slowest)]
        };
        let rows = tests.iter().flat_map(|test| test.points.iter().map(move |point| row(test, point)));
        let rows: Vec<Row> = rows.collect();
        let what = format!("{} points for the {} parameters of {}", rows.len(), ranges.len(), kind.label());
        let help = "a fit needs more points than parameters: another --law, or more points";
        ensure(rows.len() > ranges.len(), what, help)?;
        let laws = |values: &[f64]| {
            let rate = exponent.map(|_| PowerRate { exponent: values[ranges.len() - 1], reference: slowest });
            Some((kind.law(values)?, rate))
        };
        let residuals = |values: &[f64], rows: &[Row]| -> Option<Vec<f64>> {
            let (law, rate) = laws(values)?;
            let miss = |[strain, measured, size, at]: &Row| (stress(&law, rate, *strain, Some(*at)) - measured) / size;
            Some(rows.iter().map(miss).collect())
        };
        let parameter = |(&(_, _, low, high), value): (&ParameterRange, f64)| {
            let start = value.clamp(low, high);
            Parameter { start, low, high, step: DIFFERENCE * start.abs().max(1e-3 * (high - low).min(1.0)) }
        };
        let parameters = |values: Vec<f64>| -> Vec<Parameter> { ranges.iter().zip(values).map(parameter).collect() };
        let minimum = |start: Vec<f64>, rows: &[Row], steps| {
            let is_wanted = |_: &&Vec<f64>| !watch.wants_to_stop();
            let mut all = |tries: &[Vec<f64>]| tries.iter().take_while(is_wanted).map(|x| residuals(x, rows)).collect();
            minimise(&parameters(start), &mut all, steps, LEAST_CHANGE)
        };
        let means = block_means(&rows, MEANS);
        let starts = kind.starts(&means).into_iter().map(|x| x.into_iter().chain(exponent.map(|e| e.1)).collect());
        let minima = starts.filter_map(|start| minimum(start, &means, MOST_STEPS));
        let mut best = minima.min_by(|a, b| a.sum().total_cmp(&b.sum()));
        if means.len() < rows.len() {
            best = best.and_then(|best| minimum(best.values, &rows, CORRECTIONS));
        }
        let what = format!("{} cannot be fitted to the points", kind.label());
        let no_fit = || StudyError::new(what, "do stresses rise with the strain?");
        let ((hardening, rate), minimum) = best.and_then(|own| Some((laws(&own.values)?, own))).ok_or_else(no_fit)?;
        let bounds = parameters(minimum.values.clone());
        let estimates = estimates(ranges.iter().map(|range| (range.0, range.1)), &bounds, &minimum, is_weighted);
        // n ln(S/n) + 2k + 2k(k + 1)/(n − k − 1), k with the variance.
        let (n, k) = (rows.len() as f64, ranges.len() as f64 + 1.0);
        let misses = minimum.residuals.iter().zip(&rows).map(|(r, row)| (r * row[2]).powi(2));
        let aic = n * (minimum.sum() / n).max(ROUND_OFF).ln() + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0).max(0.5);
        Ok(Self { kind, hardening, rate, estimates, rms: (misses.sum::<f64>() / n).sqrt(), aic })
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
