//! The run table: one row per evaluation, and its CSV.
//!
//! ```text
//! study,designs,index,inputs_sha256, variables ..., responses ..., errors ..., verdict,fails,red,amber,end,reason,version
//! ```

use super::run::{Response, Run, column};
use super::{FailureMode, Study, StudyError};
use crate::assess::Light;
use crate::units::did_you_mean;
use serde::Serialize;

/// Header of every table, up to the variables.
pub(super) const BEGINNING: &str = "study,designs,index,";
const FIRST: [&str; 4] = ["study", "designs", "index", "inputs_sha256"];
const LAST: [&str; 7] = ["verdict", "fails", "red", "amber", "end", "reason", "version"];
const VERSION: &str = env!("CARGO_PKG_VERSION");
const LIGHTS: [Light; 4] = [Light::Grey, Light::Green, Light::Amber, Light::Red];

/// Evaluations of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct RunTable {
    /// Hash of the base case and the variables.
    pub study: String,
    /// Number of designs; 0 if each depends on the runs before.
    pub designs: u64,
    /// Columns of the variables.
    pub variables: Vec<String>,
    /// Numbers of the base case.
    pub responses: Vec<Response>,
    /// Keys and labels of the verdict's rows.
    pub rows: Vec<(String, String)>,
    /// Whether numbers have error bars.
    pub has_errors: bool,
    /// The base case.
    pub base: Run,
    /// Evaluations, by their indices.
    pub runs: Vec<Run>,
}

/// Counts of lights, for JSON.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct LightCounts {
    /// Sound without a doubt.
    pub green: usize,
    /// In doubt.
    pub amber: usize,
    /// Beyond a limit.
    pub red: usize,
    /// Not judged.
    pub grey: usize,
    /// No case, or ended by the numerics.
    pub not_run: usize,
}

impl RunTable {
    pub(super) fn new(
        study: &dyn Study,
        responses: Vec<Response>,
        rows: Vec<(String, String)>,
        base: Run,
        has_errors: bool,
    ) -> Self {
        Self {
            study: study.key(),
            designs: study.designs(),
            variables: study.columns(),
            responses,
            rows,
            has_errors,
            base,
            runs: Vec::new(),
        }
    }

    /// Place of a response by its key, its column or its label.
    ///
    /// # Errors
    /// When no run has a number of this name.
    pub fn response(&self, name: &str) -> Result<usize, StudyError> {
        let plain = |text: &str| text.trim().to_lowercase().replace([' ', '-'], "_");
        let wanted = plain(name);
        let wanted = wanted.strip_prefix("springback_").unwrap_or(&wanted);
        let is = |response: &Response| {
            let number = &response.number;
            let key = number.quantity.key.to_string();
            [plain(&key), format!("{key}_judged"), plain(&response.column), plain(number.quantity.label)]
                .iter()
                .any(|own| own == wanted)
        };
        self.responses.iter().position(is).ok_or_else(|| {
            let mut keys: Vec<&str> = self.responses.iter().map(|response| response.number.quantity.key).collect();
            keys.dedup();
            let near = did_you_mean(wanted, keys.iter().copied());
            let what = format!("a run of this case has no number `{}`", name.trim());
            StudyError::new(what, format!("{near}it has {}", keys.join(", ")))
        })
    }

    /// Label of a row of the verdict.
    pub fn label<'a>(&'a self, row: &'a str) -> &'a str {
        self.rows.iter().find(|(key, _)| key == row).map_or(row, |(_, label)| label)
    }

    /// Number of runs with each light.
    pub fn lights(&self) -> LightCounts {
        let count = |light: Option<Light>| self.runs.iter().filter(|run| run.light == light).count();
        LightCounts {
            green: count(Some(Light::Green)),
            amber: count(Some(Light::Amber)),
            red: count(Some(Light::Red)),
            grey: count(Some(Light::Grey)),
            not_run: count(None),
        }
    }

    /// First line of the CSV.
    pub fn header(&self) -> Vec<String> {
        let numbers = self.responses.iter().map(|response| response.column.clone());
        let errors = self.responses.iter().filter(|_| self.has_errors).map(|r| column(&r.number, "_error"));
        let first = FIRST.map(str::to_owned).into_iter();
        first
            .chain(self.variables.iter().cloned())
            .chain(numbers)
            .chain(errors)
            .chain(LAST.map(str::to_owned))
            .collect()
    }

    /// Line of a run.
    pub fn line(&self, run: &Run) -> Vec<String> {
        let number = |value: &f64| if value.is_finite() { value.to_string() } else { String::new() };
        let mut line = vec![self.study.clone(), self.designs.to_string(), run.index.to_string(), run.inputs.clone()];
        line.extend(run.values.iter().cloned());
        line.extend(run.numbers.iter().chain(&run.errors).map(number));
        line.push(run.light.map_or("", Light::name).to_owned());
        line.push(run.failures.iter().map(|mode| mode.key()).collect::<Vec<_>>().join(" "));
        line.extend([run.red.join(" "), run.amber.join(" "), run.end.clone(), run.reason.clone(), VERSION.to_owned()]);
        line
    }

    /// Run of a line; `None` if it is of another study, or cut.
    pub fn read(&self, line: &csv::StringRecord) -> Option<Run> {
        let mut fields = line.iter().map(str::to_owned);
        let mut next = || fields.next();
        let is_own = next()? == self.study && next()? == self.designs.to_string();
        let index = next()?.parse().ok().filter(|_| is_own)?;
        let inputs = next()?;
        let values = (0..self.variables.len()).map(|_| next()).collect::<Option<_>>()?;
        let count = self.responses.len();
        let mut numbers = |count| {
            let parsed = (0..count).map(|_| Some(next()?.parse().unwrap_or(f64::NAN)));
            parsed.collect::<Option<Vec<f64>>>()
        };
        let (numbers, errors) = (numbers(count)?, numbers(if self.has_errors { count } else { 0 })?);
        let light = next()?;
        let words = |text: String| text.split_whitespace().map(str::to_owned).collect::<Vec<String>>();
        let failures = words(next()?).iter().filter_map(|key| FailureMode::from_key(key)).collect();
        let (red, amber, end, reason) = (words(next()?), words(next()?), next()?, next()?);
        let light = LIGHTS.into_iter().find(|own| own.name() == light);
        (next()? == VERSION).then_some(Run {
            index,
            values,
            inputs,
            numbers,
            errors,
            light,
            failures,
            red,
            amber,
            end,
            reason,
        })
    }

    /// The whole table as CSV.
    pub fn csv(&self) -> Vec<u8> {
        let lines = self.runs.iter().map(|run| record(&self.line(run)));
        std::iter::once(record(&self.header())).chain(lines).flatten().collect()
    }
}

/// A line of CSV without line breaks inside its fields, so that a cut row can be recognised.
pub(super) fn record(fields: &[String]) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let never = "memory does not refuse a row";
    writer.write_record(fields.iter().map(|field| field.replace(['\n', '\r'], " "))).expect(never);
    writer.into_inner().expect(never)
}
