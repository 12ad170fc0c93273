//! The run table: one row per evaluation, and its CSV.
//!
//! ```text
//! study,designs,index,inputs_sha256, variables ..., responses ..., errors ..., verdict,fails,red,amber,end,reason,version
//! ```

use super::run::column;
use super::{FailureMode, Plan, Run, StudyError, fail};
use crate::assess::Light;
use crate::results::error_bars::Number;
use crate::units::did_you_mean;
use std::collections::BTreeMap;

pub(super) const BEGINNING: &str = "study,designs,index,";
const FIRST: [&str; 4] = ["study", "designs", "index", "inputs_sha256"];
const LAST: [&str; 7] = ["verdict", "fails", "red", "amber", "end", "reason", "version"];
const VERSION: &str = env!("CARGO_PKG_VERSION");
const LIGHTS: [Light; 4] = [Light::Grey, Light::Green, Light::Amber, Light::Red];

/// Evaluations of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct RunTable {
    pub(super) plan: Plan,
    pub(super) responses: Vec<Number>,
    pub(super) rows: Vec<(String, String)>,
    pub(super) has_errors: bool,
    /// The base case.
    pub base: Run,
    /// Evaluations, by their indices.
    pub runs: Vec<Run>,
}

impl RunTable {
    /// Place of a response by its key, its column or its label.
    pub fn response(&self, name: &str) -> Result<usize, StudyError> {
        let plain = |text: &str| text.trim().to_lowercase().replace([' ', '-'], "_");
        let wanted = plain(name);
        let wanted = wanted.strip_prefix("springback_").unwrap_or(&wanted);
        let is = |number: &Number| {
            let (key, label) = (number.quantity.key, number.quantity.label);
            let names = [plain(key), format!("{key}_judged"), plain(&column(number, "")), plain(label)];
            names.iter().any(|own| own == wanted)
        };
        if let Some(place) = self.responses.iter().position(is) {
            return Ok(place);
        }
        let mut keys: Vec<&str> = self.responses.iter().map(|response| response.quantity.key).collect();
        keys.dedup();
        let near = did_you_mean(wanted, keys.iter().copied());
        let what = format!("a run of this case has no number `{}`", name.trim());
        fail(what, format!("{near}it has {}", keys.join(", ")))
    }

    pub(super) fn display(&self, place: usize, value: f64) -> String {
        self.responses[place].quantity.amount.of(value).to_string()
    }

    /// Label of a row of the verdict.
    pub fn label<'a>(&'a self, row: &'a str) -> &'a str {
        self.rows.iter().find(|(key, _)| key == row).map_or(row, |(_, label)| label)
    }

    pub(super) fn worst_rows(&self, run: &Run) -> String {
        let keys = if run.red.is_empty() { &run.amber } else { &run.red };
        keys.iter().map(|key| self.label(key)).collect::<Vec<_>>().join(", ")
    }

    /// Number of runs with each light, and of those that were not run.
    pub fn lights(&self) -> BTreeMap<&'static str, usize> {
        let count = |light: Option<Light>| self.runs.iter().filter(|run| run.light == light).count();
        let counts = LIGHTS.map(|light| (light.name(), count(Some(light))));
        counts.into_iter().chain([("not_run", count(None))]).collect()
    }

    /// First line of the CSV.
    pub fn header(&self) -> Vec<String> {
        let mut header: Vec<String> = FIRST.map(str::to_owned).to_vec();
        header.extend(self.plan.columns.iter().cloned());
        header.extend(self.responses.iter().map(|number| column(number, "")));
        header.extend(self.responses.iter().filter(|_| self.has_errors).map(|r| column(r, "_error")));
        header.extend(LAST.map(str::to_owned));
        header
    }

    /// Line of a run.
    pub fn line(&self, run: &Run) -> Vec<String> {
        let number = |value: &f64| if value.is_finite() { value.to_string() } else { String::new() };
        let mut line =
            vec![self.plan.key.clone(), self.plan.designs.to_string(), run.index.to_string(), run.inputs.clone()];
        line.extend(run.values.iter().cloned());
        line.extend(run.numbers.iter().chain(&run.errors).map(number));
        line.push(run.light.map_or("", Light::name).to_owned());
        line.push(run.failures.iter().map(|mode| mode.key()).collect::<Vec<_>>().join(" "));
        line.extend([run.red.join(" "), run.amber.join(" "), run.end.clone(), run.reason.clone(), VERSION.to_owned()]);
        line
    }

    /// Run of a line; `None` if it is of another study, or cut.
    pub fn read(&self, line: &csv::StringRecord) -> Option<Run> {
        let count = self.responses.len();
        let errors = if self.has_errors { count } else { 0 };
        let (variables, all) = (self.plan.columns.len(), line.len());
        let is_own = line.get(0)? == self.plan.key && line.get(1)? == self.plan.designs.to_string();
        let is_whole = all == FIRST.len() + variables + count + errors + LAST.len() && line.get(all - 1)? == VERSION;
        let mut fields = line.iter().skip(2).filter(|_| is_own && is_whole);
        let index = fields.next()?.parse().ok()?;
        let inputs = fields.next()?.to_owned();
        let values = fields.by_ref().take(variables).map(str::to_owned).collect();
        let mut numbers =
            |count| fields.by_ref().take(count).map(|text| text.parse().unwrap_or(f64::NAN)).collect::<Vec<f64>>();
        let (numbers, errors) = (numbers(count), numbers(errors));
        let light = fields.next()?;
        let mut words = || Some(fields.next()?.split_whitespace().map(str::to_owned).collect::<Vec<String>>());
        let failures = words()?.iter().filter_map(|key| FailureMode::from_key(key)).collect();
        let (red, amber) = (words()?, words()?);
        let (end, reason) = (fields.next()?.to_owned(), fields.next()?.to_owned());
        let light = LIGHTS.into_iter().find(|own| own.name() == light);
        Some(Run { index, values, inputs, numbers, errors, light, failures, red, amber, end, reason })
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
