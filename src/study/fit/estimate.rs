//! Fitted numbers: how sure each is, and what cannot be told apart.

use crate::numerics::least_squares::{Limits, Minimum, Parameter, Residuals};
use crate::numerics::profile::{End, interval};
use crate::numerics::student;
use crate::units::DisplaySettings;
use crate::units::{Unit, rounded, trimmed};
use nalgebra::DMatrix;

/// Of intervals \[–\].
pub const CONFIDENCE: f64 = 0.95;

/// A relative error below which data are perfect, and an interval is as wide as round-off \[–\].
const PERFECT: f64 = 1e-7;

/// Digits at most of what is written.
const FINEST: i32 = 9;

/// A fitted number.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Its name: of a law's parameter, or the dotted path of a case's key.
    pub key: String,
    /// Unit that it is told in; empty for plain numbers.
    pub unit: String,
    /// The best value.
    pub value: f64,
    /// Standard error; `None` where the points do not tell it.
    pub error: Option<f64>,
    /// Interval of [`CONFIDENCE`], by the profile of the sum of squares.
    pub ends: [End; 2],
    /// Between what it was looked for.
    pub bounds: [f64; 2],
    /// The bound that it is pushed against.
    pub pushed: Option<f64>,
}

/// Fitted numbers together.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimates {
    /// Each by itself.
    pub all: Vec<Estimate>,
    /// Covariance; `None` where some cannot be told apart at all.
    pub covariance: Option<DMatrix<f64>>,
    /// Variance of a residual.
    pub variance: f64,
    /// Residuals less free numbers.
    pub freedom: f64,
}

impl Estimates {
    /// Of a minimum whose residuals have a variance of `least` or more; `key` and `unit` of each parameter.
    pub fn of(
        names: &[(String, String)],
        parameters: &[Parameter],
        residuals: &dyn Residuals,
        minimum: &Minimum,
        least: f64,
        limits: Limits,
    ) -> Self {
        let variance = minimum.variance().max(least);
        let covariance = minimum.covariance(variance);
        let t = student(CONFIDENCE, minimum.freedom());
        let one = |(j, ((key, unit), parameter)): (usize, (&(String, String), &Parameter))| {
            let value = minimum.values[j];
            let error = covariance.as_ref().filter(|_| minimum.free[j]).map(|covariance| covariance[(j, j)].sqrt());
            let pushed = (!minimum.free[j] && parameter.low < parameter.high).then_some(value);
            let ends = match (error, &covariance) {
                (Some(error), _) if error <= PERFECT * value.abs() => {
                    [-1.0, 1.0].map(|side| End::At(value + side * t * error))
                }
                (Some(_), Some(covariance)) => {
                    interval(parameters, residuals, limits, (minimum, covariance), (variance, t), j)
                }
                (None, Some(covariance)) if pushed.is_some() => {
                    interval(parameters, residuals, limits, (minimum, covariance), (variance, t), j)
                }
                _ => [End::Unknown; 2],
            };
            Estimate {
                key: key.clone(),
                unit: unit.clone(),
                value,
                error,
                ends,
                bounds: [parameter.low, parameter.high],
                pushed,
            }
        };
        let all = names.iter().zip(parameters).enumerate().map(one).collect();
        Self { all, covariance, variance, freedom: minimum.freedom() }
    }

    /// Correlation of two of them; `None` where one has no error.
    pub fn correlation(&self, i: usize, j: usize) -> Option<f64> {
        let c = self.covariance.as_ref()?;
        let size = (c[(i, i)] * c[(j, j)]).sqrt();
        (size > 0.0).then(|| c[(i, j)] / size)
    }

    /// Pairs that cannot be told apart by the points: of a correlation of this size or more, the closest first.
    pub fn alike(&self, least: f64) -> Vec<(usize, usize, f64)> {
        let n = self.all.len();
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let mut alike: Vec<_> = pairs.filter_map(|(i, j)| Some((i, j, self.correlation(i, j)?))).collect();
        alike.retain(|(.., correlation)| correlation.abs() >= least);
        alike.sort_by(|a, b| b.2.abs().total_cmp(&a.2.abs()));
        alike
    }

    /// Half the width of the interval of a number with these derivatives by the parameters.
    pub fn half(&self, gradient: &[f64]) -> Option<f64> {
        let covariance = self.covariance.as_ref()?;
        let gradient = nalgebra::DVector::from_column_slice(gradient);
        let variance = (gradient.transpose() * covariance * &gradient)[(0, 0)];
        (variance >= 0.0).then(|| student(CONFIDENCE, self.freedom) * variance.sqrt())
    }
}

impl Estimate {
    /// Converts to display units; keeps a unit that has no other.
    pub fn displayed(self) -> Self {
        let Ok((unit, own)) = Unit::of_header(&format!("value_{}", self.unit)) else { return self };
        let to = unit.display(own * self.value);
        if DisplaySettings::current() == DisplaySettings::Si || to.symbol == unit.symbol() || to.offset != 0.0 {
            return self;
        }
        let scaled = |value: f64| own * to.factor * value;
        let end = |end: End| match end {
            End::At(value) => End::At(scaled(value)),
            open => open,
        };
        Self {
            unit: to.symbol.to_owned(),
            value: scaled(self.value),
            error: self.error.map(scaled),
            ends: self.ends.map(end),
            bounds: self.bounds.map(scaled),
            pushed: self.pushed.map(scaled),
            ..self
        }
    }

    /// The value with no digit that its error does not allow: two digits of the error.
    pub fn told(&self) -> String {
        self.number(self.value)
    }

    /// The value for a file that is computed with: with two digits more, because errors of several numbers go together.
    pub fn written(&self) -> String {
        match self.error.filter(|error| *error > 0.0) {
            Some(error) => {
                trimmed(self.value, (3 - magnitude(error)).clamp(0, (FINEST - magnitude(self.value)).max(0)))
            }
            None => rounded(self.value).to_string(),
        }
    }

    /// The standard error, to two digits.
    pub fn told_error(&self) -> Option<String> {
        let is_told = |error: f64| error > PERFECT * self.value.abs();
        self.error.map(|error| if is_told(error) { self.number(error) } else { format!("{error:.1e}") })
    }

    /// The interval: `0.11 to 0.13`, `below 0.13`.
    pub fn interval(&self) -> Option<String> {
        let [low, high] = self.ends;
        match (low, high) {
            (End::At(low), End::At(high)) => Some(format!("{} … {}", self.number(low), self.number(high))),
            (End::Open, End::At(high)) => Some(format!("< {}", self.number(high))),
            (End::At(low), End::Open) => Some(format!("> {}", self.number(low))),
            _ => None,
        }
    }

    /// Whether a value lies in the interval; an open end holds all, and one that was not found nothing.
    pub fn holds(&self, value: f64) -> bool {
        let holds = |end: End, beyond: &dyn Fn(f64) -> bool| match end {
            End::At(end) => !beyond(end),
            End::Open => true,
            End::Unknown => false,
        };
        holds(self.ends[0], &|low| value < low) && holds(self.ends[1], &|high| value > high)
    }

    fn number(&self, value: f64) -> String {
        match self.error.filter(|error| *error > PERFECT * self.value.abs()) {
            Some(error) => trimmed(value, 1 - magnitude(error)),
            None => crate::units::significant(value, 6).to_string(),
        }
    }
}

/// The power of ten of a number.
fn magnitude(value: f64) -> i32 {
    if value == 0.0 { 0 } else { value.abs().log10().floor() as i32 }
}
