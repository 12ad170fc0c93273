//! The run table: one row per evaluation, and its CSV.
//!
//! ```text
//! study,designs,index,inputs_sha256, variables ..., responses ..., verdict,fails,red,amber,end,reason,version
//! ```

use super::{run::column, *};

pub(super) const BEGINNING: &str = "study,designs,index,";
const FIRST: [&str; 4] = ["study", "designs", "index", "inputs_sha256"];
const LAST: [&str; 7] = ["verdict", "fails", "red", "amber", "end", "reason", "version"];
const VERSION: &str = env!("CARGO_PKG_VERSION");

/// Evaluations of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct RunTable {
    pub(super) plan: Plan,
    pub(super) responses: Vec<Number>,
    pub(super) rows: Vec<(String, String)>,
    /// The base case.
    pub base: Run,
    /// Evaluations, by their indices.
    pub runs: Vec<Run>,
}

impl RunTable {
    /// Place of a response by its key, its column or its label.
    pub fn response(&self, name: &str) -> Result<usize> {
        let plain = |text: &str| text.trim().to_lowercase().replace([' ', '-'], "_");
        let wanted = plain(name);
        let wanted = wanted.strip_prefix("springback_").unwrap_or(&wanted);
        let is = |number: &Number| {
            let (key, label) = (number.quantity.key, number.quantity.label);
            [plain(key), format!("{key}_judged"), plain(&column(number)), plain(label)].contains(&wanted.to_owned())
        };
        let mut keys: Vec<&str> = self.responses.iter().map(|response| response.quantity.key).collect();
        keys.dedup();
        let help = format!("{}it has {}", did_you_mean(wanted, keys.iter().copied()), keys.join(", "));
        let what = format!("a run of this case has no number `{}`", name.trim());
        self.responses.iter().position(is).ok_or_else(|| StudyError::new(what, help))
    }

    pub(super) fn display(&self, place: usize, value: f64) -> String {
        self.responses[place].quantity.amount.with_value(value).to_string()
    }

    pub(super) fn labels(&self, keys: &[String]) -> String {
        let label = |key: &String| self.rows.iter().find(|row| row.0 == *key).map_or(key, |row| &row.1).clone();
        joined(keys.iter().map(label), ", ")
    }

    /// ` (Flange to the horizontal 2.1°; Press force 1120 kN; red there: Spring-back; amber there: Tearing)`, or nothing.
    pub(super) fn lights_there(&self, run: &Run) -> String {
        let lights = [("red", &run.red), ("amber", &run.amber)].into_iter().filter(|(_, keys)| !keys.is_empty());
        let lights = lights.map(|(light, keys)| format!("{light} there: {}", self.labels(keys)));
        let numbers = ["flange_angle", "press_force_judged"].into_iter().filter_map(|name| self.response(name).ok());
        let number = |at: usize| format!("{} {}", self.responses[at].quantity.label, self.display(at, run.numbers[at]));
        let text = joined(numbers.map(number).chain(lights), "; ");
        if text.is_empty() { text } else { format!(" ({text})") }
    }

    pub(super) fn no_result(&self) -> Option<String> {
        let reasons = self.runs.iter().map(|run| if run.reason.is_empty() { &run.end } else { &run.reason });
        let reason = reasons.map(|reason| reason.trim_end_matches('.')).next().unwrap_or("nothing was run");
        let is_lost = !self.runs.iter().any(Run::is_known);
        is_lost.then(|| format!("None of {} runs came to a result: {reason}.", self.runs.len()))
    }

    /// Number of runs with each light, and of those that were not run.
    pub fn lights(&self) -> BTreeMap<&'static str, usize> {
        let count = |light: Option<Light>| self.runs.iter().filter(|run| run.light == light).count();
        let run = Light::ALL.map(|light| (light.name(), count(Some(light))));
        run.into_iter().chain([("not_run", count(None))]).collect()
    }

    /// First line of the CSV.
    pub fn header(&self) -> Vec<String> {
        let first = FIRST.map(str::to_owned).into_iter().chain(self.plan.columns.iter().cloned());
        first.chain(self.responses.iter().map(column)).chain(LAST.map(str::to_owned)).collect()
    }

    /// Line of a run.
    pub fn line(&self, run: &Run) -> Vec<String> {
        let number = |value: &f64| if value.is_finite() { value.to_string() } else { String::new() };
        let [designs, index] = [self.plan.designs, run.index].map(|number| number.to_string());
        let mut line = vec![self.plan.key.clone(), designs, index, run.inputs.clone()];
        line.extend(run.values.iter().cloned().chain(run.numbers.iter().map(number)));
        line.push(run.light.map_or("", Light::name).to_owned());
        line.push(joined(run.failures.iter().map(|mode| mode.key().to_owned()), " "));
        line.extend([run.red.join(" "), run.amber.join(" "), run.end.clone(), run.reason.clone(), VERSION.to_owned()]);
        line
    }

    /// Run of a line; `None` if it is of another study, or cut.
    pub fn read(&self, line: &csv::StringRecord) -> Option<Run> {
        let fields: Vec<&str> = line.iter().map(|field| field.strip_prefix('\'').unwrap_or(field)).collect();
        let [key, designs, index, inputs, rest @ ..] = &fields[..] else { return None };
        let is_own = *key == self.plan.key && *designs == self.plan.designs.to_string();
        let (values, rest) = rest.split_at_checked(self.plan.columns.len()).filter(|_| is_own)?;
        let (numbers, rest) = rest.split_at_checked(self.responses.len())?;
        let [light, failures, red, amber, end, reason, VERSION] = rest else { return None };
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect();
        let modes = FailureMode::ALL.into_iter().filter(|mode| failures.split(' ').any(|key| key == mode.key()));
        let [inputs, end, reason] = [inputs, end, reason].map(|text| (*text).to_owned());
        let (index, red, amber, failures) = (index.parse().ok()?, words(red), words(amber), modes.collect());
        let values = values.iter().map(|value| (*value).to_owned()).collect();
        let numbers = numbers.iter().map(|text| text.parse().unwrap_or(f64::NAN)).collect();
        let light = Light::ALL.into_iter().find(|own| own.name() == *light);
        Some(Run { index, values, inputs, numbers, light, failures, red, amber, end, reason })
    }

    /// The whole table as CSV.
    pub fn csv(&self) -> Vec<u8> {
        let lines = self.runs.iter().map(|run| self.line(run));
        std::iter::once(self.header()).chain(lines).flat_map(|line| record(&line)).collect()
    }
}

/// A line of CSV without line breaks inside its fields, so that a cut row can be recognised.
pub(super) fn record(fields: &[String]) -> Vec<u8> {
    records([fields.iter().map(|field| field.replace(['\n', '\r'], " "))])
}
