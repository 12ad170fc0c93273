//! One hardening law through the points of tension tests, and a rate law where they differ in their rate.

use super::estimate::{Estimate, Estimates};
use super::flow_curve::{FlowCurve, FlowPoint};
use super::kind::Kind;
use super::runs::{PATTERN, runs};
use crate::material::hardening::Hardening;
use crate::material::rate::{CowperSymonds, JohnsonCook, PowerRate, Rate};
use crate::numerics::least_squares::{Limits, Minimum, Parameter, minimise};
use crate::study::StudyError;
use std::str::FromStr;

/// A law that was fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFit {
    /// Which.
    pub kind: Kind,
    /// With its numbers.
    pub hardening: Hardening,
    /// The rate law, where tests differ in their rate.
    pub rate: Option<Rate>,
    /// Its numbers, those of the rate law last.
    pub estimates: Estimates,
    /// Law less point, in the order of the points \[MPa\].
    pub misses: Vec<f64>,
    /// Root of their mean square \[MPa\].
    pub rms: f64,
    /// Share of the points' variance that the law explains \[–\].
    pub r2: f64,
    /// Akaike's criterion with the correction for few points: the less, the better the law for its numbers.
    pub aic: f64,
    /// Whether misses bow to one side and the other: the law is not of the points' shape.
    pub bows: bool,
    rate_kind: Option<(RateKind, f64)>,
}

/// A rate law of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateKind {
    /// (rate/reference)^m.
    Power,
    /// 1 + C ln(rate/reference).
    JohnsonCook,
    /// 1 + (rate/C)^(1/p).
    CowperSymonds,
}

const LIMITS: Limits = Limits { steps: 200, change: 1e-9 };
/// How many of the starts with the least sum are followed.
const FOLLOWED: usize = 3;
/// Half of a central difference over the start: half of the digits of a number, or a third for its square \[–\].
const DIFFERENCE: f64 = 1e-5;
/// A variance that no test is as exact as, for the logarithm of perfect data: that of 1e-4 MPa, or standard deviations.
const ROUND_OFF: f64 = 1e-8;

impl FromStr for RateKind {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        match name {
            "power" => Ok(Self::Power),
            "johnson-cook" => Ok(Self::JohnsonCook),
            "cowper-symonds" => Ok(Self::CowperSymonds),
            _ => Err("the laws are power, johnson-cook and cowper-symonds".to_owned()),
        }
    }
}

impl RateKind {
    /// Name, unit, bounds and start of each parameter.
    fn parameters(self) -> Vec<(&'static str, &'static str, [f64; 2], f64)> {
        match self {
            Self::Power => vec![("rate.exponent", "", [0.0, 1.0], 0.02)],
            Self::JohnsonCook => vec![("rate.coefficient", "", [1e-9, 1.0], 0.02)],
            Self::CowperSymonds => {
                vec![("rate.rate", "/s", [1e-6, 1e12], 1e4), ("rate.exponent", "", [0.5, 50.0], 5.0)]
            }
        }
    }

    /// The law; `reference` is the rate of the slowest test \[1/s\].
    fn law(self, p: &[f64], reference: f64) -> Rate {
        match self {
            Self::Power => Rate::PowerRate(PowerRate { exponent: p[0], reference }),
            Self::JohnsonCook => Rate::JohnsonCook(JohnsonCook { coefficient: p[0], reference }),
            Self::CowperSymonds => Rate::CowperSymonds(CowperSymonds { rate: p[0], exponent: p[1] }),
        }
    }
}

/// Points of all tests with the rate of each.
fn points<'a>(tests: &'a [&FlowCurve]) -> impl Iterator<Item = (&'a FlowPoint, Option<f64>)> {
    tests.iter().flat_map(|test| test.points.iter().map(|point| (point, test.rate)))
}

impl LawFit {
    /// Fits a law to tests; a rate law too where they have several rates.
    ///
    /// # Errors
    /// When there are no more points than parameters, or the law goes through none of them.
    pub fn of(kind: Kind, tests: &[&FlowCurve], rate_kind: RateKind) -> Result<Self, StudyError> {
        let rates: Vec<f64> = tests.iter().filter_map(|test| test.rate).collect();
        let slowest = rates.iter().copied().fold(f64::INFINITY, f64::min);
        let rate_kind = Some((rate_kind, slowest)).filter(|_| rates.iter().any(|rate| *rate > slowest));
        let slots = kind.slots();
        let of_rate = rate_kind.map_or_else(Vec::new, |(rate_kind, _)| rate_kind.parameters());
        let names: Vec<(String, String)> = slots
            .iter()
            .map(|slot| (slot.key, slot.unit))
            .chain(of_rate.iter().map(|(key, unit, ..)| (*key, *unit)))
            .map(|(key, unit)| (key.to_owned(), unit.to_owned()))
            .collect();
        let all: Vec<(&FlowPoint, Option<f64>)> = points(tests).collect();
        let count = kind.count() + of_rate.len();
        if all.len() <= count {
            let what = format!("{} points for the {count} numbers of {}", all.len(), kind.label());
            return Err(StudyError::new(
                what,
                "a fit needs more points than parameters: another --law, or more of the test",
            ));
        }
        let is_weighted = all.iter().all(|(point, _)| point.scatter.is_some());
        let weight = |point: &FlowPoint| point.scatter.filter(|_| is_weighted).map_or(1.0, |scatter| 1.0 / scatter);
        let split = slots.len();
        let computed = |values: &[f64]| -> Option<Vec<f64>> {
            let law = kind.law(&values[..split])?;
            let rate = rate_kind.map(|(rate_kind, slowest)| rate_kind.law(&values[split..], slowest));
            let factor = |of: Option<f64>| rate.zip(of).map_or(1.0, |(law, of)| law.at(of).value);
            Some(all.iter().map(|(point, of)| law.at(point.strain).stress * factor(*of)).collect())
        };
        let residuals = |values: &[f64]| -> Option<Vec<f64>> {
            let of = |(stress, (point, _)): (f64, &(&FlowPoint, _))| (stress - point.stress) * weight(point);
            Some(computed(values)?.into_iter().zip(&all).map(of).collect())
        };
        let plain: Vec<(f64, f64)> = all.iter().map(|(point, _)| (point.strain, point.stress)).collect();
        let parameters = |start: &[f64]| -> Vec<Parameter> {
            let own = slots.iter().zip(start).map(|(slot, start)| (*start, [slot.low, slot.high]));
            let own = own.chain(of_rate.iter().map(|(_, _, bounds, start)| (*start, *bounds)));
            own.map(|(start, [low, high])| {
                let start = start.clamp(low, high);
                Parameter { start, low, high, step: DIFFERENCE * start.abs().max(1e-3 * (high - low).min(1.0)) }
            })
            .collect()
        };
        let sum = |start: &Vec<f64>| {
            let start: Vec<f64> = parameters(start).iter().map(|p| p.start).collect();
            residuals(&start).map_or(f64::INFINITY, |r| r.iter().map(|r| r * r).sum::<f64>())
        };
        let mut starts = kind.starts(&plain);
        starts.retain(|start| sum(start).is_finite());
        starts.sort_by(|a, b| sum(a).total_cmp(&sum(b)));
        let followed = starts.iter().take(FOLLOWED);
        let found = followed.filter_map(|start| {
            let parameters = parameters(start);
            minimise(&parameters, &residuals, LIMITS).map(|minimum| (minimum, parameters))
        });
        let best = found.min_by(|a, b| a.0.sum().total_cmp(&b.0.sum()));
        let (minimum, parameters) = best.ok_or_else(|| {
            StudyError::new(
                format!("{} cannot be fitted to the points", kind.label()),
                "do stresses rise with the strain?",
            )
        })?;
        let estimates =
            Estimates::of(&names, &parameters, &residuals, &minimum, if is_weighted { 1.0 } else { 0.0 }, LIMITS);
        let misses: Vec<f64> = match computed(&minimum.values) {
            Some(computed) => computed.iter().zip(&all).map(|(stress, (point, _))| stress - point.stress).collect(),
            None => Vec::new(),
        };
        let hardening =
            kind.law(&minimum.values[..split]).ok_or_else(|| StudyError::new("no law", "try another --law"))?;
        Ok(Self {
            kind,
            hardening,
            rate: rate_kind.map(|(rate_kind, slowest)| rate_kind.law(&minimum.values[split..], slowest)),
            estimates,
            rms: (misses.iter().map(|miss| miss * miss).sum::<f64>() / misses.len() as f64).sqrt(),
            misses,
            r2: r2(&minimum, &all, weight),
            aic: aic(&minimum, count),
            bows: runs(&minimum.residuals) < PATTERN,
            rate_kind,
        })
    }

    /// The stress at a strain in a test at this rate, and half the width of its interval \[MPa\].
    pub fn band(&self, strain: f64, rate: Option<f64>) -> (f64, Option<f64>) {
        let values: Vec<f64> = self.estimates.all.iter().map(|estimate| estimate.value).collect();
        let split = self.kind.slots().len();
        let stress = |values: &[f64]| {
            let of_rate = self.rate_kind.zip(rate);
            let factor =
                of_rate.map_or(1.0, |((kind, slowest), rate)| kind.law(&values[split..], slowest).at(rate).value);
            self.kind.law(&values[..split]).map(|law| law.at(strain).stress * factor)
        };
        let slope = |j: usize| {
            let moved = |side: f64| {
                let mut values = values.clone();
                values[j] += side * DIFFERENCE * values[j].abs().max(1e-6);
                stress(&values).map(|stress| (values[j], stress))
            };
            let here = stress(&values).map(|stress| (values[j], stress));
            let (a, b) = (moved(-1.0).or(here)?, moved(1.0).or(here)?);
            Some((b.1 - a.1) / (b.0 - a.0))
        };
        let gradient: Option<Vec<f64>> = (0..values.len()).map(slope).collect();
        (stress(&values).unwrap_or(f64::NAN), gradient.and_then(|gradient| self.estimates.half(&gradient)))
    }

    /// The number of that name.
    pub fn estimate(&self, key: &str) -> Option<&Estimate> {
        self.estimates.all.iter().find(|estimate| estimate.key == key)
    }

    /// Whether a number of it is pushed against the end of its range.
    pub fn is_pushed(&self) -> bool {
        self.estimates.all.iter().any(|estimate| estimate.pushed.is_some())
    }
}

fn r2(minimum: &Minimum, all: &[(&FlowPoint, Option<f64>)], weight: impl Fn(&FlowPoint) -> f64) -> f64 {
    let (sum, weights) = all.iter().fold((0.0, 0.0), |(sum, weights), (point, _)| {
        let w = weight(point) * weight(point);
        (sum + w * point.stress, weights + w)
    });
    let mean = sum / weights;
    let spread: f64 = all.iter().map(|(point, _)| (weight(point) * (point.stress - mean)).powi(2)).sum();
    1.0 - minimum.sum() / spread
}

/// n ln(S/n) + 2k + 2k(k + 1)/(n − k − 1), k with the variance.
fn aic(minimum: &Minimum, count: usize) -> f64 {
    let (n, k) = (minimum.residuals.len() as f64, count as f64 + 1.0);
    n * (minimum.sum() / n).max(ROUND_OFF).ln() + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0).max(0.5)
}
