//! Uncertain variables: a key of the case with a distribution, or the strength of its sheet.
//!
//! ```text
//! uniform LOW..HIGH UNIT                         alike likely from LOW to HIGH
//! uniform MIDDLE ± HALF UNIT                     the same, by its middle
//! normal MEAN ± DEVIATION UNIT                   the bell curve; DEVIATION is the standard deviation
//! normal MEAN ± DEVIATION UNIT in LOW..HIGH UNIT the same cut off at both ends: `truncated normal` says it too
//! normal MEAN ± DEVIATION UNIT in ± LIMIT UNIT   the same, as far from its mean
//! ```
//! Without MIDDLE or MEAN it is the case's own value; a HALF, DEVIATION or LIMIT in % is of the middle. `+-` and `+/-` are ±.

use super::variable::{NumberReader, number, split_number, split_pair, written};
use super::{StudyError, Variable};
use crate::case::Case;
use crate::material::chaboche;
use crate::units::{Dimensioned, Stress, parse, significant};
use statrs::distribution::{ContinuousCDF, Normal};
use toml_edit::Value;

pub(super) const STRENGTH: &str = "strength";

const HARDENING: &str = "material.hardening";

/// A key with a distribution, or [`STRENGTH`].
#[derive(Clone, Debug)]
pub(super) struct UncertainVariable {
    pub variable: Variable,
    distribution: Distribution,
    /// The law that the strength scales, or that must be written into the case before one of its numbers can be changed.
    hardening: Option<Value>,
}

impl UncertainVariable {
    /// Reads `KEY=DISTRIBUTION`.
    pub fn read(case: &Case, text: &str) -> Result<Self, StudyError> {
        let help = "write KEY=DISTRIBUTION, such as \"friction=uniform 0.05..0.12\"";
        let wrong = || StudyError::new(format!("`{text}` gives no key a distribution"), help);
        let (key, distribution) = split_pair(text).ok_or_else(wrong)?;
        let is_strength = key == STRENGTH;
        let own = || if is_strength { Ok((1.0, String::new())) } else { own_value(case, key) };
        let (distribution, unit) = Distribution::read(key, distribution, own)?;
        let hardening = if is_strength { Some(scalable_law(case)?) } else { library_law(case, key) };
        Ok(Self { variable: Variable::new(key, unit), distribution, hardening })
    }

    /// Its value at a coordinate between 0 and 1.
    pub fn value(&self, coordinate: f64) -> String {
        written(self.distribution.quantile(coordinate))
    }

    /// The overrides that set a value.
    pub fn settings(&self, value: &str) -> Vec<String> {
        let law = |law: &Value| format!("{HARDENING}={law}");
        match &self.hardening {
            Some(own) if self.variable.key == STRENGTH => {
                let mut scaled = own.clone();
                scale(&mut scaled, number(value).unwrap_or(1.0));
                vec![law(&scaled)]
            }
            own => own.iter().map(law).chain([self.variable.setting(value)]).collect(),
        }
    }

    /// Whether both set the same key.
    pub fn conflicts_with(&self, other: &Self) -> bool {
        let (own, other) = (&self.variable.key, &other.variable.key);
        own == other || own == STRENGTH && other.starts_with(HARDENING)
    }
}

fn own_value(case: &Case, key: &str) -> Result<(f64, String), StudyError> {
    let all = case.written(key);
    let wrong = |what: String| StudyError::new(what, "write the middle too: \"normal 1 ± 0.02 mm\"");
    let (path, text) = all.first().ok_or_else(|| wrong(format!("the case writes no {key} to scatter about")))?;
    if let Some((other, differs)) = all.iter().find(|(_, other)| other != text) {
        return Err(wrong(format!("the case has {text} at {path} and {differs} at {other}")));
    }
    let (number, unit) = split_number(text).ok_or_else(|| wrong(format!("{path} is no number in the case: {text}")))?;
    Ok((number, unit.to_owned()))
}

fn library_law(case: &Case, key: &str) -> Option<Value> {
    let text = case.text.parse::<toml_edit::DocumentMut>();
    let is_own = text.is_ok_and(|text| text.get("material").and_then(|material| material.get("hardening")).is_some());
    case.hardening().filter(|_| !is_own && key.starts_with(HARDENING))
}

fn scalable_law(case: &Case) -> Result<Value, StudyError> {
    let help = "vary the law's own numbers: \"material.hardening.swift.k=normal ± 5 %\"";
    let law = match case.hardening() {
        _ if chaboche::shifting(case.model().material.chaboche).is_some() => {
            Err("the sheet has back-stresses, which are not of its hardening law")
        }
        None => Err("the case writes no hardening law"),
        Some(law) if scale(&mut law.clone(), 1.0) == 0 => Err("the hardening law has no stresses in the case's text"),
        Some(law) => Ok(law),
    };
    law.map_err(|what| StudyError::new(format!("{STRENGTH}: {what}"), help))
}

/// Multiplies all stresses in a value; returns how many there are.
fn scale(value: &mut Value, factor: f64) -> usize {
    match value {
        Value::InlineTable(table) => table.iter_mut().map(|(_, value)| scale(value, factor)).sum(),
        Value::Array(array) => array.iter_mut().map(|item| scale(item, factor)).sum(),
        Value::String(text) => {
            let is_stress = parse(text.value()).is_ok_and(|x| x.dimension == Stress::KIND.dimension());
            let Some((number, unit)) = split_number(text.value()).filter(|_| is_stress) else { return 0 };
            *value = format!("{} {unit}", significant(number * factor, 12)).into();
            1
        }
        _ => 0,
    }
}

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

enum Interval {
    Ends(f64, f64),
    /// The case's own value is in the middle if none is given.
    About(Option<f64>, Width),
}

const HELP: &str = "write \"uniform 0.05..0.12\", \"normal 1 ± 0.02 mm\", \"normal ± 3 %\" of the case's own value, or \
                    \"normal 1 ± 0.02 mm in 0.95..1.05 mm\"";

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
        let plain = text.trim().replace("+/-", "±").replace("+-", "±");
        let mut reader = NumberReader::new(key, &plain, HELP)?;
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
        let main = Interval::read(&mut reader, main)?;
        let limits = limits.map(|limits| Interval::read(&mut reader, limits)).transpose()?;
        let unit = reader.unit()?;
        let (middle, width) = match main {
            Interval::Ends(low, high) if word == "uniform" => return Ok((Self::Uniform { low, high }, unit)),
            Interval::Ends(..) => return Err(reader.wrong("has no ±")),
            Interval::About(middle, width) => (middle, width),
        };
        let (middle, unit) = match middle {
            Some(middle) => (middle, unit),
            None => {
                let (value, of_case) = own()?;
                let unit = if unit.is_empty() { of_case.clone() } else { unit };
                let wrong = || reader.wrong(format!("is in {unit}, and the case has {value} {of_case}"));
                (converted(value, &of_case, &unit).ok_or_else(wrong)?, unit)
            }
        };
        let size = |(width, is_share): Width| if is_share { width * middle.abs() } else { width };
        let deviation = size(width);
        reader.ensure(deviation > 0.0, "is a share of 0")?;
        if word == "uniform" {
            return Ok((Self::Uniform { low: middle - deviation, high: middle + deviation }, unit));
        }
        let limits = match limits {
            None => (f64::NEG_INFINITY, f64::INFINITY),
            Some(Interval::Ends(low, high)) => (low, high),
            Some(Interval::About(None, limit)) => (middle - size(limit), middle + size(limit)),
            Some(Interval::About(Some(_), _)) => {
                return Err(reader.wrong("has a middle between its limits: `in ± 0.05 mm`, or `in 0.95..1.05 mm`"));
            }
        };
        let [a, b] = [limits.0, limits.1].map(|end| Normal::standard().cdf((end - middle) / deviation));
        reader.ensure(b - a >= LEAST, "has next to nothing between its limits")?;
        Ok((Self::Normal { mean: middle, deviation, limits }, unit))
    }
}

impl Interval {
    /// `LOW..HIGH`, `MIDDLE ± HALF` or `± HALF`.
    fn read<'a>(reader: &mut NumberReader<'a>, text: &'a str) -> Result<Self, StudyError> {
        if let Some((low, high)) = text.split_once("..") {
            let (low, high) = (reader.number(low)?, reader.number(high)?);
            reader.ensure(low < high, format!("has no width from {low} to {high}"))?;
            return Ok(Self::Ends(low, high));
        }
        let (middle, width) = text.split_once('±').ok_or_else(|| reader.wrong("has no ± and no .."))?;
        let middle = if middle.trim().is_empty() { None } else { Some(reader.number(middle)?) };
        let (number, unit) = split_number(width.trim()).ok_or_else(|| reader.wrong("has no number behind ±"))?;
        reader.ensure(number > 0.0, format!("scatters by {number}: more than 0 is wanted"))?;
        Ok(Self::About(middle, if unit == "%" { (0.01 * number, true) } else { (reader.number(width)?, false) }))
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

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// Trust: by hand; the case's own value is 2 mm.
    #[test]
    fn distributions_are_read_as_they_are_written() {
        let read = |text: &str| Distribution::read("key", text, || Ok((2.0, "mm".into())));
        for (text, expected) in [
            ("uniform 4 .. 6 mm", "Uniform { low: 4.0, high: 6.0 } mm"),
            ("uniform 5 ± 1 mm", "Uniform { low: 4.0, high: 6.0 } mm"),
            ("uniform ± 50 %", "Uniform { low: 1.0, high: 3.0 } mm"),
            ("normal 4 mm +/- 25 %", "Normal { mean: 4.0, deviation: 1.0, limits: (-inf, inf) } mm"),
            ("normal ± 0.05 cm", "Normal { mean: 0.2, deviation: 0.05, limits: (-inf, inf) } cm"),
            ("normal 1 +- 0.25 in in 0.5..2 in", "Normal { mean: 1.0, deviation: 0.25, limits: (0.5, 2.0) } in"),
            ("truncated normal ± 25 % in ± 50 %", "Normal { mean: 2.0, deviation: 0.5, limits: (1.0, 3.0) } mm"),
        ] {
            let (distribution, unit) = read(text).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(format!("{distribution:?} {unit}"), expected, "{text}");
        }
    }

    /// Trust: tables of the normal distribution: Φ(−1) = 0.158 655 and Φ(1) − Φ(−1) = 0.682 689, so that the quarter between −1
    /// and 1 is at Φ⁻¹(0.329 327) = −0.441 78.
    #[test]
    fn quantiles_are_those_of_tables() {
        for (limits, probability, expected) in [
            ((f64::NEG_INFINITY, f64::INFINITY), 0.975, 1.195_996),
            ((0.9, 1.1), 0.5, 1.0),
            ((0.9, 1.1), 0.25, 1.0 - 0.044_178),
        ] {
            let normal = Distribution::Normal { mean: 1.0, deviation: 0.1, limits };
            assert_relative_eq!(normal.quantile(probability), expected, max_relative = 1e-6);
        }
    }
}
