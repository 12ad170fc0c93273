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
pub(super) enum Distribution {
    Uniform {
        low: f64,
        high: f64,
    },
    /// Mean and deviation before it is cut off at its limits, which may be infinite.
    Normal {
        mean: f64,
        deviation: f64,
        limits: (f64, f64),
    },
}

/// Size, and whether it is a share of the middle.
type Width = (f64, bool);

enum Limits {
    Ends(f64, f64),
    About(Width),
}

impl Distribution {
    /// The value that is not exceeded with a probability between 0 and 1.
    pub fn quantile(&self, probability: f64) -> f64 {
        let normal = Normal::standard();
        match *self {
            Self::Uniform { low, high } => low + probability * (high - low),
            Self::Normal { mean, deviation, limits: (low, high) } => {
                let [a, b] = [low, high].map(|end| normal.cdf((end - mean) / deviation));
                (mean + deviation * normal.inverse_cdf(a + probability * (b - a))).clamp(low, high)
            }
        }
    }

    /// Reads a distribution of a key and its unit; `own` is the case's value with its unit.
    pub fn read(
        key: &str,
        text: &str,
        own: impl FnOnce() -> Result<(f64, String), StudyError>,
    ) -> Result<(Self, String), StudyError> {
        reject_decimal_comma(key, text)?;
        let plain = text.trim().replace("+/-", "±").replace("+-", "±");
        let mut reader = Reader { key, text: text.trim(), units: Vec::new() };
        let (is_cut, rest) =
            plain.strip_prefix("truncated").map_or((false, plain.as_str()), |rest| (true, rest.trim_start()));
        let (word, rest) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        let (main, limits) = match (word, rest.rsplit_once(" in ")) {
            ("uniform", _) if !is_cut => (rest, None),
            ("normal", Some((main, limits))) => (main, Some(limits)),
            ("normal", None) if is_cut => return Err(reader.wrong("is truncated and does not say where")),
            ("normal", None) => (rest, None),
            _ => return Err(reader.wrong("is no distribution")),
        };
        if let Some(ends) = main.split_once("..").filter(|_| word == "uniform") {
            let (low, high) = reader.ends(ends)?;
            return Ok((Self::Uniform { low, high }, reader.unit()?));
        }
        let (middle, width) = reader.about(main)?;
        let limits = match limits.map(|limits| (limits, limits.split_once(".."))) {
            None => None,
            Some((_, Some(ends))) => reader.ends(ends).map(|(low, high)| Some(Limits::Ends(low, high)))?,
            Some((limits, None)) => match reader.about(limits)? {
                (None, width) => Some(Limits::About(width)),
                _ => {
                    let what = "has a middle between its limits: `in ± 0.05 mm`, or `in 0.95..1.05 mm`";
                    return Err(reader.wrong(what));
                }
            },
        };
        let unit = reader.unit()?;
        let (middle, unit) = match middle.map_or_else(|| own().map(Err), |middle| Ok(Ok(middle)))? {
            Ok(middle) => (middle, unit),
            Err((value, of_case)) if unit.is_empty() => (value, of_case),
            Err((value, of_case)) => {
                let wrong = || reader.wrong(&format!("is in {unit}, and the case has {value} {of_case}"));
                (converted(value, &of_case, &unit).ok_or_else(wrong)?, unit)
            }
        };
        let size = |(width, is_share): Width| match is_share {
            true if middle == 0.0 => Err(reader.wrong("is a share of 0")),
            true => Ok(width * middle.abs()),
            false => Ok(width),
        };
        let deviation = size(width)?;
        if word == "uniform" {
            return Ok((Self::Uniform { low: middle - deviation, high: middle + deviation }, unit));
        }
        let limits = match limits {
            None => (f64::NEG_INFINITY, f64::INFINITY),
            Some(Limits::Ends(low, high)) => (low, high),
            Some(Limits::About(limit)) => (middle - size(limit)?, middle + size(limit)?),
        };
        let [a, b] = [limits.0, limits.1].map(|end| Normal::standard().cdf((end - middle) / deviation));
        if b - a < LEAST {
            return Err(reader.wrong("has next to nothing between its limits"));
        }
        Ok((Self::Normal { mean: middle, deviation, limits }, unit))
    }
}

/// A number of one unit in another; `None` if they measure different things, or one needs more than a factor.
fn converted(value: f64, from: &str, to: &str) -> Option<f64> {
    if from == to {
        return Some(value);
    }
    let quantity = |number: f64, unit: &str| parse(&format!("{number} {unit}")).ok();
    let has_factor = [from, to].iter().all(|unit| quantity(0.0, unit).is_some_and(|zero| zero.value == 0.0));
    let (one, other) = (quantity(1.0, from)?, quantity(1.0, to)?);
    (has_factor && one.dimension == other.dimension).then_some(value * one.value / other.value)
}

struct Reader<'a> {
    key: &'a str,
    text: &'a str,
    units: Vec<String>,
}

impl Reader<'_> {
    fn wrong(&self, what: &str) -> StudyError {
        let help = "write \"uniform 0.05..0.12\", \"normal 1 ± 0.02 mm\", \"normal ± 3 %\" of the case's own value, or \
                    \"normal 1 ± 0.02 mm in 0.95..1.05 mm\"";
        StudyError::new(format!("{}: `{}` {what}", self.key, self.text), help)
    }

    fn unit(&self) -> Result<String, StudyError> {
        let unit = self.units.first().cloned().unwrap_or_default();
        if let Some(other) = self.units.iter().find(|other| **other != unit) {
            return Err(self.wrong(&format!("has two units, {unit} and {other}")));
        }
        check_unit(self.key, &unit)?;
        Ok(unit)
    }

    fn number(&mut self, text: &str) -> Result<f64, StudyError> {
        let (number, unit) = split_number(text.trim()).ok_or_else(|| match text.trim() {
            "" => self.wrong("misses a number"),
            other => self.wrong(&format!("has no number in `{other}`")),
        })?;
        self.units.extend(Some(unit.to_owned()).filter(|unit| !unit.is_empty()));
        Ok(number)
    }

    fn ends(&mut self, (low, high): (&str, &str)) -> Result<(f64, f64), StudyError> {
        let (low, high) = (self.number(low)?, self.number(high)?);
        if low < high { Ok((low, high)) } else { Err(self.wrong(&format!("has no width from {low} to {high}"))) }
    }

    fn about(&mut self, text: &str) -> Result<(Option<f64>, Width), StudyError> {
        let (middle, width) = text.split_once('±').ok_or_else(|| self.wrong("has no ± and no .."))?;
        let middle = if middle.trim().is_empty() { None } else { Some(self.number(middle)?) };
        let (number, unit) = split_number(width.trim()).ok_or_else(|| self.wrong("has no number behind ±"))?;
        if number <= 0.0 {
            return Err(self.wrong(&format!("scatters by {number}: more than 0 is wanted")));
        }
        let is_share = unit == "%";
        Ok((middle, if is_share { (0.01 * number, true) } else { (self.number(width)?, false) }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn read(text: &str) -> Result<(Distribution, String), StudyError> {
        Distribution::read("key", text, || Ok((2.0, "mm".into())))
    }

    /// Trust: by hand; the case's own value is 2 mm.
    #[test]
    fn distributions_are_read_as_they_are_written() {
        let uniform = |low, high| Distribution::Uniform { low, high };
        let normal = |mean, deviation, limits: Option<(f64, f64)>| {
            let limits = limits.unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
            Distribution::Normal { mean, deviation, limits }
        };
        for (text, wanted, unit) in [
            ("uniform 0.05..0.12", uniform(0.05, 0.12), ""),
            ("uniform 4 .. 6 mm", uniform(4.0, 6.0), "mm"),
            ("uniform 5 ± 1 mm", uniform(4.0, 6.0), "mm"),
            ("uniform ± 50 %", uniform(1.0, 3.0), "mm"),
            ("normal 1 +- 0.25 mm", normal(1.0, 0.25, None), "mm"),
            ("normal 4 mm +/- 25 %", normal(4.0, 1.0, None), "mm"),
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
    fn wrong_distributions_are_refused() {
        for (text, message) in [
            ("lognormal 1 ± 0.2", "is no distribution"),
            ("uniform 1 mm", "has no ± and no .."),
            ("uniform 3..2 mm", "no width from 3 to 2"),
            ("uniform 3..", "misses a number"),
            ("normal 1 ± -0.02 mm", "scatters by -0.02"),
            ("normal 1 ± mm", "no number behind ±"),
            ("normal 1 mm ± 0.2 in", "two units, mm and in"),
            ("normal 1 ± 0.2 mmm", "mmm"),
            ("truncated normal 1 ± 0.2", "does not say where"),
            ("normal 1 ± 0.2 in 5..6", "next to nothing"),
            ("normal ± 5 MPa", "is in MPa, and the case has 2 mm"),
        ] {
            let error = read(text).expect_err(text).to_string();
            assert!(error.contains(message), "{text}: {error}");
        }
    }

    /// Trust: tables of the normal distribution; of one cut off symmetrically the median is the mean, and its ends the limits.
    #[test]
    fn quantiles_are_those_of_tables() {
        let normal = |limits| Distribution::Normal { mean: 1.0, deviation: 0.1, limits };
        let whole = normal((f64::NEG_INFINITY, f64::INFINITY));
        assert_relative_eq!(whole.quantile(0.975), 1.195_996_398, max_relative = 1e-9);
        let cut = normal((0.9, 1.1));
        assert_relative_eq!(cut.quantile(0.5), 1.0, max_relative = 1e-9);
        // Φ(−1) = 0.158 655 and Φ(1) − Φ(−1) = 0.682 689: the quarter is at Φ⁻¹(0.329 327) = −0.441 78.
        assert_relative_eq!(cut.quantile(0.25), 1.0 - 0.044_178, max_relative = 1e-5);
        assert!(cut.quantile(1e-12) >= 0.9 && cut.quantile(1.0 - 1e-12) <= 1.1);
    }
}
