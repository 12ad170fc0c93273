//! Tension tests as a user names them, and the texts that say how they are reduced.

use super::flow_curve::{FlowCurve, Reduction};
use super::tension::Tension;
use crate::study::{MeasuredData, StudyError};
use crate::units::{Dimensioned, Positive, Stress, parse};

/// Tension tests, and how they are reduced.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tests {
    /// A table each.
    pub tests: Vec<MeasuredData>,
    /// How they are reduced.
    pub reduction: Reduction,
    /// Section of the specimen, for forces \[mm²\].
    pub section: Option<f64>,
    /// Gauge length, for elongations \[mm\].
    pub gauge: Option<f64>,
    /// Strain rate of each test, or none \[1/s\].
    pub rate: Vec<f64>,
    /// Direction of each test to the rolling direction, or none \[°\].
    pub direction: Vec<f64>,
}

impl Tests {
    /// The tests, reduced.
    ///
    /// # Errors
    /// When one cannot be read or reduced, rates or directions are not one for each, or one is there twice.
    pub fn curves(&self) -> Result<Vec<FlowCurve>, StudyError> {
        let count = self.tests.len();
        for (what, given) in [("--rate", self.rate.len()), ("--direction", self.direction.len())] {
            if given != 0 && given != count {
                return Err(StudyError::new(format!("{what} has {given} values for {count} tests"), "give one each"));
            }
        }
        if let Some(rate) = self.rate.iter().find(|rate| !(**rate > 0.0 && rate.is_finite())) {
            return Err(StudyError::new(format!("a strain rate of {rate} /s"), "it must be above 0"));
        }
        let one = |(i, data): (usize, &MeasuredData)| {
            let curve = FlowCurve::of(&Tension::load(data, self.section, self.gauge)?, &self.reduction)?;
            Ok(FlowCurve { rate: self.rate.get(i).copied(), direction: self.direction.get(i).copied(), ..curve })
        };
        let curves = self.tests.iter().enumerate().map(one).collect::<Result<Vec<_>, StudyError>>()?;
        // The same numbers twice are no second measurement, and would make every interval narrower.
        let twin =
            |i: usize| curves[..i].iter().position(|before| before.is_again(&curves[i])).map(|before| (before, i));
        match (1..curves.len()).find_map(twin) {
            Some((a, b)) => {
                let what = format!("{} and {} are one test", self.tests[a], self.tests[b]);
                Err(StudyError::new(what, "give every test once"))
            }
            None => Ok(curves),
        }
    }
}

/// A stress above 0 \[MPa\].
///
/// # Errors
/// When the text is none.
pub fn stress(text: &str) -> Result<f64, String> {
    text.parse::<Positive<Stress>>().map(|stress| stress.value()).map_err(|error| error.to_string())
}

/// A plain number or one in per cent, 0 or more \[–\].
///
/// # Errors
/// When the text is none.
pub fn strain(text: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    (parsed.dimension.describe() == "a plain number" && parsed.value >= 0.0)
        .then_some(parsed.value)
        .ok_or_else(|| format!("{text} is no strain: write 0.002 or \"0.2 %\""))
}

/// The section of a specimen \[mm²\].
///
/// # Errors
/// When the text is none.
pub fn section(text: &str) -> Result<f64, String> {
    measured(text, "an area", "20 mm^2")
}

/// A gauge length \[mm\].
///
/// # Errors
/// When the text is none.
pub fn gauge(text: &str) -> Result<f64, String> {
    measured(text, "a length", "80 mm")
}

fn measured(text: &str, what: &str, example: &str) -> Result<f64, String> {
    let parsed = parse(text).map_err(|error| error.to_string())?;
    let fits = parsed.dimension.describe() == what && parsed.value > 0.0;
    fits.then_some(parsed.value).ok_or_else(|| format!("{text} is not {what}: write \"{example}\""))
}
