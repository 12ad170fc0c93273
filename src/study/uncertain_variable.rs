//! Uncertain variables: keys of the case with a distribution.
//!
//! ```text
//! uniform LOW..HIGH UNIT                         alike likely from LOW to HIGH
//! uniform MIDDLE ± HALF UNIT                     the same, by its middle
//! normal MEAN ± DEVIATION UNIT                   the bell curve; DEVIATION is the standard deviation
//! normal MEAN ± DEVIATION UNIT in LOW..HIGH UNIT the same cut off at both ends
//! tolerance                                      of `blank.thickness`: uniform within that of its sheet's standard
//! ```
//! Without MIDDLE or MEAN it is the case's own value; a HALF or DEVIATION in % is of the middle. `+-` and `+/-` are ±.

use super::{variable::NumberReader, variable::split_number, *};
use crate::grade;
use statrs::distribution::{ContinuousCDF, Normal};
use toml_edit::Value;

const STRENGTH: &str = "strength";
const HARDENING: &str = "material.hardening";
const THICKNESS: &str = "blank.thickness";
const TOLERANCE: &str = "tolerance";

#[derive(Clone, Debug)]
pub(super) struct UncertainVariable {
    pub variable: Variable,
    distribution: Distribution,
    /// The law that must be written into the case before one of its numbers can be changed.
    hardening: Option<Value>,
    pub is_absolute: bool,
    /// Source of the distribution, if it is not the study's.
    pub source: Option<String>,
}

impl UncertainVariable {
    /// Variable of a study without any: the thickness within its standard's tolerance; `None` if that is not known.
    pub fn default_of(case: &Case) -> Option<String> {
        tolerance(case).ok().map(|_| format!("{THICKNESS}={TOLERANCE}"))
    }

    /// Reads `KEY=DISTRIBUTION`.
    pub fn read(base: &BaseCase, case: &Case, text: &str) -> Result<Self> {
        let help = "write KEY=DISTRIBUTION, such as \"friction=uniform 0.05..0.12\"";
        let wrong = || StudyError::new(format!("`{text}` gives no key a distribution"), help);
        let is_coil = ["coil", "material.coil"].contains(&text.split('=').next().unwrap_or_default().trim());
        let coil = "give one end with --coil, or scatter the strength: \"strength=uniform ± 8 %\"";
        ensure(!is_coil, "a coil is strong or weak, and no number that scatters", coil)?;
        let (key, distribution) = split_pair(text).ok_or_else(wrong)?;
        let is_tolerance = key == THICKNESS && distribution.trim() == TOLERANCE;
        let (distribution, source) = if is_tolerance { tolerance(case)? } else { (distribution.to_owned(), None) };
        let mut is_absolute = true;
        let own = || {
            is_absolute = false;
            base.value(key).or_else(|| (key == STRENGTH).then(|| "1".to_owned()))
        };
        let (distribution, unit) = Distribution::read(key, &distribution, own)?;
        let hardening = library_law(case, key);
        is_absolute &= hardening.is_none();
        Ok(Self { variable: Variable::new(key, unit), distribution, hardening, is_absolute, source })
    }

    pub fn value(&self, coordinate: f64) -> String {
        written(self.distribution.quantile(coordinate))
    }

    pub fn settings(&self, value: &str) -> Vec<String> {
        self.hardening.iter().map(|law| format!("{HARDENING}={law}")).chain([self.variable.setting(value)]).collect()
    }
}

fn tolerance(case: &Case) -> Result<(String, Option<String>)> {
    let thickness = case.model().blank.thickness;
    let standard = case.sheet().and_then(|sheet| sheet.about.band?.thickness_tolerance);
    let what = || format!("no standard's tolerance is known of this sheet at {thickness} mm");
    let help = "write \"blank.thickness=uniform ± 0.05 mm\", or name a sheet of the library such as dc04";
    let known = standard.and_then(|standard| grade::tolerance(&standard, thickness));
    let (half, source) = known.ok_or_else(|| StudyError::new(what(), help))?;
    let source = format!("Thickness: ± {half} mm by {source}; alike likely within it (declared).");
    Ok((format!("uniform ± {half} mm"), Some(source)))
}

fn library_law(case: &Case, key: &str) -> Option<Value> {
    let text = case.text.parse::<toml_edit::DocumentMut>();
    let is_own = text.is_ok_and(|text| text.get("material").and_then(|material| material.get("hardening")).is_some());
    case.hardening().filter(|_| !is_own && key.starts_with(HARDENING))
}

/// Least probability between the limits of a normal distribution: less is a mistake in its numbers.
const LEAST: f64 = 1e-4;

/// Probability distribution of a number, in the unit of its key: uniform between its limits, or normal and cut off there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Distribution {
    /// Mean and standard deviation before it is cut off.
    normal: Option<(f64, f64)>,
    limits: (f64, f64),
}

const HELP: &str = "write \"uniform 0.05..0.12\", \"normal 1 ± 0.02 mm\", \"normal ± 3 %\" of the case's own value, or \
                    \"normal 1 ± 0.02 mm in 0.95..1.05 mm\"";

impl Distribution {
    pub fn quantile(&self, probability: f64) -> f64 {
        let (low, high) = self.limits;
        let Some((mean, deviation)) = self.normal else { return low + probability * (high - low) };
        let normal = Normal::standard();
        let [a, b] = [low, high].map(|end| normal.cdf((end - mean) / deviation));
        (mean + deviation * normal.inverse_cdf(a + probability * (b - a))).clamp(low, high)
    }

    /// Reads a distribution of a key and its unit; `own` is the case's value with its unit.
    pub fn read(key: &str, text: &str, own: impl FnOnce() -> Option<String>) -> Result<(Self, String)> {
        let plain = text.trim().replace("+/-", "±").replace("+-", "±");
        let mut reader = NumberReader::new(key, &plain, HELP)?;
        let (word, rest) = plain.split_once(char::is_whitespace).unwrap_or((&plain, ""));
        reader.ensure(["uniform", "normal"].contains(&word), "is no distribution")?;
        let cut = rest.rsplit_once(" in ").filter(|(_, cut)| word == "normal" && cut.contains(".."));
        let (main, cut) = cut.map_or((rest, None), |(main, cut)| (main, Some(cut)));
        let distribution = if word == "uniform" && main.contains("..") {
            Self { normal: None, limits: ends(&mut reader, main)? }
        } else {
            let (middle, half) = pair(&mut reader, main, own)?;
            let normal = Some((middle, half)).filter(|_| word == "normal");
            let whole = if normal.is_some() { f64::INFINITY } else { half };
            let limits = cut.map_or(Ok((middle - whole, middle + whole)), |cut| ends(&mut reader, cut))?;
            let [a, b] = [limits.0, limits.1].map(|end| Normal::standard().cdf((end - middle) / half));
            reader.ensure(b - a >= LEAST, "has next to nothing between its limits")?;
            Self { normal, limits }
        };
        Ok((distribution, reader.unit()?))
    }
}

fn ends(reader: &mut NumberReader, text: &str) -> Result<(f64, f64)> {
    let (low, high) = text.split_once("..").ok_or_else(|| reader.wrong("has no .."))?;
    let (low, high) = (reader.number(low)?, reader.number(high)?);
    reader.ensure(low < high, format!("has no width from {low} to {high}"))?;
    Ok((low, high))
}

/// Reads `MIDDLE ± HALF`; without a middle it is the case's own value. HALF may be a share of it.
fn pair(reader: &mut NumberReader, text: &str, own: impl FnOnce() -> Option<String>) -> Result<(f64, f64)> {
    let (middle, half) = text.split_once('±').ok_or_else(|| reader.wrong("has no ±"))?;
    let (number, unit) = split_number(half.trim()).ok_or_else(|| reader.wrong("has no number behind ±"))?;
    reader.ensure(number > 0.0, format!("scatters by {number}: more than 0 is wanted"))?;
    let half = if unit == "%" { None } else { Some(reader.number(half)?) };
    let middle = if middle.trim().is_empty() {
        let own = own().ok_or_else(|| reader.wrong("has no middle, and the case has no one value of this key"))?;
        if let (Some((_, unit)), "") = (split_number(&own), reader.unit.as_str()) {
            reader.unit = unit.to_owned();
        }
        let wrong = || reader.wrong(format!("is in {}, and the case has {own}", reader.unit));
        in_unit(&own, &reader.unit()?).ok_or_else(wrong)?
    } else {
        reader.number(middle)?
    };
    let half = half.unwrap_or(0.01 * number * middle.abs());
    reader.ensure(half > 0.0, "is a share of 0")?;
    Ok((middle, half))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const OPEN: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

    /// Trust: tables of the normal distribution: Φ(−1) = 0.158 655 and Φ(1) − Φ(−1) = 0.682 689, so that the quarter between −1
    /// and 1 is at Φ⁻¹(0.329 327) = −0.441 78.
    #[test]
    fn quantiles_are_those_of_tables() {
        for (limits, probability, expected) in
            [(OPEN, 0.975, 1.195_996), ((0.9, 1.1), 0.5, 1.0), ((0.9, 1.1), 0.25, 1.0 - 0.044_178)]
        {
            let normal = Distribution { normal: Some((1.0, 0.1)), limits };
            assert_relative_eq!(normal.quantile(probability), expected, max_relative = 1e-6);
        }
    }
}
