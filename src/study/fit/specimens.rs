//! Tension tests with their rates and directions.

use super::flow_curve::{FlowCurve, Reduction};
use super::tension::Tension;
use crate::study::{StudyError, fail};
use std::path::PathBuf;

/// Tension tests and the settings of their reduction.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tests {
    /// A CSV file for each test.
    pub tests: Vec<PathBuf>,
    /// Settings of the reduction.
    pub reduction: Reduction,
    /// Section of the specimen, for forces \[mm²\].
    pub section: Option<f64>,
    /// Gauge length, for elongations \[mm\].
    pub gauge: Option<f64>,
    /// Strain rate of each test, or none \[1/s\].
    pub rate: Vec<f64>,
    /// Angle of each test to the rolling direction, or none \[°\].
    pub direction: Vec<f64>,
}

impl Tests {
    /// Reads and reduces the tests.
    pub fn curves(&self) -> Result<Vec<FlowCurve>, StudyError> {
        let count = self.tests.len();
        for (option, values) in [("--rate", &self.rate), ("--direction", &self.direction)] {
            if !values.is_empty() && values.len() != count {
                return fail(format!("{option} has {} values for {count} tests", values.len()), "give one each");
            }
        }
        if let Some(rate) = self.rate.iter().find(|rate| !(**rate > 0.0 && rate.is_finite())) {
            return fail(format!("a strain rate of {rate} /s"), "it must be above 0");
        }
        let mut curves: Vec<FlowCurve> = Vec::new();
        for (i, path) in self.tests.iter().enumerate() {
            let curve = FlowCurve::of(&Tension::load(path, self.section, self.gauge)?, &self.reduction)?;
            let (rate, direction) = (self.rate.get(i).copied(), self.direction.get(i).copied());
            let curve = FlowCurve { rate, direction, ..curve };
            // Equal numbers are no second measurement, and would make every interval narrower.
            if let Some(twin) = curves.iter().position(|before| before.is_again(&curve)) {
                let (first, again) = (self.tests[twin].display(), path.display());
                return fail(format!("{first} and {again} are one test"), "give every test once");
            }
            curves.push(curve);
        }
        Ok(curves)
    }
}
