//! Distributions of uncertain variables.
//!
//! ```text
//! uniform LOW..HIGH UNIT                         alike likely from LOW to HIGH
//! uniform MIDDLE ± HALF UNIT                     the same, by its middle
//! normal MEAN ± DEVIATION UNIT                   the bell curve; DEVIATION is the standard deviation
//! normal MEAN ± DEVIATION UNIT in LOW..HIGH UNIT the same cut off at both ends: `truncated normal` says it too
//! normal MEAN ± DEVIATION UNIT in ± LIMIT UNIT   the same, as far from its mean
//! ```
//! Without MIDDLE or MEAN it is the case's own value; a HALF, DEVIATION or LIMIT in % is of the middle. `+-` and `+/-` are ±.

use super::StudyError;
use super::variable::{check_unit, reject_decimal_comma, split_number};
use crate::units::parse;
use statrs::distribution::{ContinuousCDF, Normal};

/// Least probability between the limits of a normal distribution: less is a mistake in its numbers.
const LEAST: f64 = 1e-4;

/// Probability distribution of a number, in the unit of its key.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Alike likely between two ends.
    Uniform {
        /// The lower end.
        low: f64,
        /// The upper end.
        high: f64,
    },
    /// The bell curve, cut off at limits where there are some.
    Normal {
        /// Before it is cut off.
        mean: f64,
        /// Standard deviation before it is cut off.
        deviation: f64,
        /// Least and largest value.
        limits: Option<(f64, f64)>,
    },
}

/// A distribution as it was written: what is relative, or of the case, is open.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenDistribution {
    shape: Shape,
    /// Unit behind its numbers; empty where there is none.
    unit: String,
    /// Text as written.
    text: String,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Shape {
    Ends(f64, f64),
    Uniform { middle: Option<f64>, half: Width },
    Normal { mean: Option<f64>, deviation: Width, limits: Option<Limits> },
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Limits {
    Ends(f64, f64),
    About(Width),
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Width {
    Absolute(f64),
    /// Share of the middle \[–\].
    Relative(f64),
}

/// The standard normal distribution.
fn standard() -> Normal {
    Normal::standard()
}

/// Φ, the probability of less than `z` standard deviations above the mean.
pub(super) fn normal_probability(z: f64) -> f64 {
    standard().cdf(z)
}

/// Φ⁻¹.
pub(super) fn normal_quantile(probability: f64) -> f64 {
    standard().inverse_cdf(probability)
}

impl Distribution {
    /// The value that is not exceeded with a probability between 0 and 1.
    pub fn quantile(&self, probability: f64) -> f64 {
        match *self {
            Self::Uniform { low, high } => low + probability * (high - low),
            Self::Normal { mean, deviation, limits: None } => mean + deviation * normal_quantile(probability),
            Self::Normal { mean, deviation, limits: Some((low, high)) } => {
                let [a, b] = [low, high].map(|end| normal_probability((end - mean) / deviation));
                (mean + deviation * normal_quantile(a + probability * (b - a))).clamp(low, high)
            }
        }
    }
}

impl WrittenDistribution {
    /// Reads a distribution of a key.
    ///
    /// # Errors
    /// When it is none, has no width, two units or one that is unknown, or its ends leave nothing between them.
    pub fn read(key: &str, text: &str) -> Result<Self, StudyError> {
        reject_decimal_comma(key, text)?;
        let reader = Reader { key, text };
        let plain = text.trim().replace("+/-", "±").replace("+-", "±");
        let (is_cut, rest) = match plain.strip_prefix("truncated") {
            Some(rest) => (true, rest.trim_start()),
            None => (false, plain.as_str()),
        };
        let (word, rest) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        let mut units = Vec::new();
        let shape = match word {
            "uniform" if !is_cut => match rest.split_once("..") {
                Some(ends) => reader.ends(ends, &mut units).map(|(low, high)| Shape::Ends(low, high))?,
                None => {
                    let (middle, half) = reader.about(rest, &mut units)?;
                    Shape::Uniform { middle, half }
                }
            },
            "normal" => {
                let (main, limits) = match rest.rsplit_once(" in ") {
                    Some((main, limits)) => (main, Some(limits.trim())),
                    None if is_cut => return Err(reader.wrong("is truncated and does not say where")),
                    None => (rest, None),
                };
                let (mean, deviation) = reader.about(main, &mut units)?;
                let limits = limits.map(|limits| match limits.split_once("..") {
                    Some(ends) => reader.ends(ends, &mut units).map(|(low, high)| Limits::Ends(low, high)),
                    None => match reader.about(limits, &mut units)? {
                        (None, width) => Ok(Limits::About(width)),
                        _ => {
                            Err(reader.wrong("has a middle between its limits: `in ± 0.05 mm`, or `in 0.95..1.05 mm`"))
                        }
                    },
                });
                Shape::Normal { mean, deviation, limits: limits.transpose()? }
            }
            _ => return Err(reader.wrong("is no distribution")),
        };
        units.retain(|unit| !unit.is_empty());
        if let Some(other) = units.iter().find(|other| **other != units[0]) {
            return Err(reader.wrong(&format!("has two units, {} and {other}", units[0])));
        }
        let unit = units.first().cloned().unwrap_or_default();
        check_unit(key, &unit)?;
        Ok(Self { shape, unit, text: text.trim().to_owned() })
    }

    /// The distribution and its unit; `own` is the case's value with its unit.
    ///
    /// # Errors
    /// When the case's value is needed and is not known or measured otherwise, a share is asked for of 0, or nothing lies
    /// between the limits.
    pub fn of(
        &self,
        key: &str,
        own: impl FnOnce() -> Result<(f64, String), StudyError>,
    ) -> Result<(Distribution, String), StudyError> {
        let reader = Reader { key, text: &self.text };
        let middle = match self.shape {
            Shape::Ends(low, high) => return Ok((Distribution::Uniform { low, high }, self.unit.clone())),
            Shape::Uniform { middle, .. } => middle,
            Shape::Normal { mean, .. } => mean,
        };
        let (middle, unit) = match middle {
            Some(middle) => (middle, self.unit.clone()),
            None => {
                let (value, unit) = own()?;
                match self.unit.is_empty() {
                    true => (value, unit),
                    false => (
                        converted(value, &unit, &self.unit).ok_or_else(|| {
                            reader.wrong(&format!("is in {}, and the case has {value} {unit}", self.unit))
                        })?,
                        self.unit.clone(),
                    ),
                }
            }
        };
        let wide = |width: Width| match width {
            Width::Absolute(width) => Ok(width),
            Width::Relative(_) if middle == 0.0 => Err(reader.wrong("is a share of 0")),
            Width::Relative(share) => Ok(share * middle.abs()),
        };
        let distribution = match self.shape {
            Shape::Ends(low, high) => Distribution::Uniform { low, high },
            Shape::Uniform { half, .. } => {
                let half = wide(half)?;
                Distribution::Uniform { low: middle - half, high: middle + half }
            }
            Shape::Normal { deviation, limits, .. } => {
                let limits = match limits {
                    None => None,
                    Some(Limits::Ends(low, high)) => Some((low, high)),
                    Some(Limits::About(limit)) => Some((middle - wide(limit)?, middle + wide(limit)?)),
                };
                let deviation = wide(deviation)?;
                let [a, b] = limits.map_or([0.0, 1.0], |(low, high)| {
                    [low, high].map(|end| normal_probability((end - middle) / deviation))
                });
                if b - a < LEAST {
                    return Err(reader.wrong("has next to nothing between its limits"));
                }
                Distribution::Normal { mean: middle, deviation, limits }
            }
        };
        Ok((distribution, unit))
    }
}

/// A number of one unit in another; `None` where they measure different things, or one needs more than a factor.
fn converted(value: f64, from: &str, to: &str) -> Option<f64> {
    if from == to {
        return Some(value);
    }
    let of = |number: f64, unit: &str| parse(&format!("{number} {unit}")).ok();
    let has_factor = [from, to].iter().all(|unit| of(0.0, unit).is_some_and(|zero| zero.value == 0.0));
    let (from, to) = (of(1.0, from)?, of(1.0, to)?);
    (has_factor && from.dimension == to.dimension).then(|| value * from.value / to.value)
}

/// Reads parts of a text and says what is wrong with it.
struct Reader<'a> {
    key: &'a str,
    text: &'a str,
}

impl Reader<'_> {
    fn wrong(&self, what: &str) -> StudyError {
        let help = "write \"uniform 0.05..0.12\", \"normal 1 ± 0.02 mm\", \"normal ± 3 %\" of the case's own value, or \
                    \"normal 1 ± 0.02 mm in 0.95..1.05 mm\"";
        StudyError::new(format!("{}: `{}` {what}", self.key, self.text.trim()), help)
    }

    fn number(&self, text: &str, units: &mut Vec<String>) -> Result<f64, StudyError> {
        let (number, unit) = split_number(text.trim()).ok_or_else(|| match text.trim() {
            "" => self.wrong("misses a number"),
            other => self.wrong(&format!("has no number in `{other}`")),
        })?;
        units.push(unit.to_owned());
        Ok(number)
    }

    fn ends(&self, (low, high): (&str, &str), units: &mut Vec<String>) -> Result<(f64, f64), StudyError> {
        let (low, high) = (self.number(low, units)?, self.number(high, units)?);
        if low < high { Ok((low, high)) } else { Err(self.wrong(&format!("has no width from {low} to {high}"))) }
    }

    /// Middle and width around ±.
    fn about(&self, text: &str, units: &mut Vec<String>) -> Result<(Option<f64>, Width), StudyError> {
        let (middle, width) = text.split_once('±').ok_or_else(|| self.wrong("has no ± and no .."))?;
        let middle = match middle.trim() {
            "" => None,
            middle => Some(self.number(middle, units)?),
        };
        let (number, unit) = split_number(width.trim()).ok_or_else(|| self.wrong("has no number behind ±"))?;
        if number <= 0.0 {
            return Err(self.wrong(&format!("scatters by {number}: more than 0 is wanted")));
        }
        match unit {
            "%" => Ok((middle, Width::Relative(0.01 * number))),
            unit => {
                units.push(unit.to_owned());
                Ok((middle, Width::Absolute(number)))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn read(text: &str) -> Result<(Distribution, String), StudyError> {
        WrittenDistribution::read("key", text)?.of("key", || Ok((2.0, "mm".into())))
    }

    /// Trust: by hand; the case's own value is 2 mm.
    #[test]
    fn distributions_are_read_as_they_are_written() {
        let uniform = |low, high| Distribution::Uniform { low, high };
        let normal = |mean, deviation, limits| Distribution::Normal { mean, deviation, limits };
        for (text, wanted, unit) in [
            ("uniform 0.05..0.12", uniform(0.05, 0.12), ""),
            ("uniform 4 .. 6 mm", uniform(4.0, 6.0), "mm"),
            ("uniform 5 ± 1 mm", uniform(4.0, 6.0), "mm"),
            ("uniform ± 50 %", uniform(1.0, 3.0), "mm"),
            ("normal 1 ± 0.25 mm", normal(1.0, 0.25, None), "mm"),
            ("normal 1 +- 0.25 mm", normal(1.0, 0.25, None), "mm"),
            ("normal 4 mm +/- 25 %", normal(4.0, 1.0, None), "mm"),
            ("normal ± 25 %", normal(2.0, 0.5, None), "mm"),
            ("normal ± 0.05 cm", normal(0.2, 0.05, None), "cm"),
            ("truncated normal 1 ± 0.25 mm in 0.5..1.25 mm", normal(1.0, 0.25, Some((0.5, 1.25))), "mm"),
            ("normal 1 ± 0.25 in in 0.5..1.25 in", normal(1.0, 0.25, Some((0.5, 1.25))), "in"),
            ("normal ± 25 % in ± 50 %", normal(2.0, 0.5, Some((1.0, 3.0))), "mm"),
        ] {
            let (found, of) = read(text).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!((found, of.as_str()), (wanted, unit), "{text}");
        }
    }

    /// Trust: each is wrong as its message says.
    #[test]
    fn what_is_no_distribution_is_told() {
        for (text, said) in [
            ("lognormal 1 ± 0.2", "is no distribution"),
            ("0.05..0.12", "is no distribution"),
            ("uniform 1 mm", "has no ± and no .."),
            ("uniform 3..2 mm", "no width from 3 to 2"),
            ("uniform 3..", "misses a number"),
            ("normal 1 ± -0.02 mm", "scatters by -0.02"),
            ("normal 1 ± 0 mm", "scatters by 0"),
            ("normal 1 ± mm", "no number behind ±"),
            ("normal 1 mm ± 0.2 in", "two units, mm and in"),
            ("normal 1 ± 0.2 mmm", "mmm"),
            ("truncated normal 1 ± 0.2", "does not say where"),
            ("normal 1 ± 0.2 in 5..6", "next to nothing"),
            ("normal ± 5 MPa", "is in MPa, and the case has 2 mm"),
        ] {
            let error = read(text).expect_err(text).to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
    }

    /// Trust: tables of the normal distribution; of one cut off symmetrically the median is the mean, and its ends the limits.
    #[test]
    fn quantiles_are_those_of_tables() {
        let normal = Distribution::Normal { mean: 1.0, deviation: 0.1, limits: None };
        assert_relative_eq!(normal.quantile(0.975), 1.195_996_398, max_relative = 1e-9);
        assert_relative_eq!(normal.quantile(0.5), 1.0, max_relative = 1e-12);
        assert_relative_eq!(normal.quantile(1e-6), 1.0 - 0.475_342_431, max_relative = 1e-8);
        let cut = Distribution::Normal { mean: 1.0, deviation: 0.1, limits: Some((0.9, 1.1)) };
        assert_relative_eq!(cut.quantile(0.5), 1.0, max_relative = 1e-9);
        // Φ(−1) = 0.158 655 and Φ(1) − Φ(−1) = 0.682 689: the quarter is at Φ⁻¹(0.329 327) = −0.441 78.
        assert_relative_eq!(cut.quantile(0.25), 1.0 - 0.044_178, max_relative = 1e-5);
        assert!(cut.quantile(1e-12) >= 0.9 && cut.quantile(1.0 - 1e-12) <= 1.1);
        assert_eq!(Distribution::Uniform { low: 2.0, high: 4.0 }.quantile(0.25), 2.5);
    }
}
