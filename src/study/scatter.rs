//! Scatter: a quasi-random sample of uncertain variables, the probability of each light, and the main influences.
//!
//! The sample is a scrambled Sobol sequence. Wilson's intervals take its points as independent, which is on the safe side.

use super::base_case::short_hash;
use super::charts;
use super::default_scatter::DefaultScatter;
use super::report::{Cell, ReportTable, StudyReport};
use super::statistics::{Probability, quantile, rank_correlation, wilson};
use super::uncertain_variable::UncertainVariable;
use super::variable::{Value, split_pair};
use super::{BaseCase, Design, Run, RunTable, Study, StudyError, StudyFile};
use crate::assess::Light;
use crate::units::Amount;
use sobol_burley::sample;
use std::path::Path;

/// Default sample size; a Sobol sequence is most even at a power of two.
pub const RUNS: u64 = 1024;
/// Points of one sequence; further points are of another scrambling.
const LONGEST: u64 = 1 << 16;
const MOST: u64 = 1 << 32;
const VARIABLES: usize = 128;
/// Half the resolution of the sequence: no coordinate is 0 or 1.
const HALF: f64 = 0.5 / (1u32 << 24) as f64;
/// Quantiles of the tables.
const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];
/// Rank correlations that are named \[–\].
const NAMED: f64 = 0.3;

/// A sample of uncertain variables.
#[derive(Clone, Debug)]
pub struct Scatter {
    base: BaseCase,
    variables: Vec<UncertainVariable>,
    runs: u64,
    seed: u32,
    /// Sources of default distributions.
    defaults: Vec<String>,
}

/// Results of a sample.
#[derive(Clone, Debug)]
pub struct UncertaintyResult {
    /// Lights by their rows, the most important first.
    pub events: Vec<Event>,
    /// Spread of every response that varies, by its place.
    pub spreads: Vec<Spread>,
}

/// Object of an event.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EventKind {
    /// The sheet tears.
    Tear,
    /// The whole verdict.
    Verdict,
    /// A row of the verdict.
    Row(String),
}

/// A light and its probability.
#[derive(Clone, Debug)]
pub struct Event {
    /// Object that has the light.
    pub kind: EventKind,
    /// Red or amber.
    pub light: Light,
    /// Runs that have it.
    pub hits: usize,
    /// Its probability.
    pub probability: Probability,
    /// Rank correlation with each variable.
    pub correlations: Vec<Option<f64>>,
}

/// Spread of a response.
#[derive(Clone, Debug)]
pub struct Spread {
    /// Place of the response.
    pub response: usize,
    /// Sorted values.
    pub values: Vec<f64>,
    /// Rank correlation with each variable.
    pub correlations: Vec<Option<f64>>,
}

impl Scatter {
    /// Reads a case or study file; `vary` replaces the study's own variables.
    ///
    /// # Errors
    /// Those of [`new`](Self::new).
    pub fn load(
        path: &Path,
        set: Vec<String>,
        vary: &[String],
        runs: Option<u64>,
        seed: Option<u32>,
    ) -> Result<Self, StudyError> {
        let (file, vary) = StudyFile::load(path, set, vary)?;
        let (runs, seed) = (runs.or(file.runs), seed.or(file.seed));
        Self::new(BaseCase::load(file.case, file.set)?, &vary, runs.unwrap_or(RUNS), seed.unwrap_or(1))
    }

    /// Samples `KEY=DISTRIBUTION` variables of a case; default distributions if there are none.
    ///
    /// # Errors
    /// When a distribution makes no sense, two set the same key, a key makes no case, or the sample is too small or too large.
    pub fn new(base: BaseCase, vary: &[String], runs: u64, seed: u32) -> Result<Self, StudyError> {
        let case = base.case(&[])?;
        let DefaultScatter { vary, notes: defaults } = match vary.is_empty() {
            true => DefaultScatter::new(&case),
            false => DefaultScatter { vary: vary.to_vec(), notes: Vec::new() },
        };
        let read = |text: &String| {
            let (key, scatter) = split_pair(text).ok_or_else(|| {
                let help = "write KEY=DISTRIBUTION, such as \"friction=uniform 0.05..0.12\"";
                StudyError::new(format!("`{text}` gives no key a distribution"), help)
            })?;
            UncertainVariable::new(&case, key, scatter)
        };
        let variables = vary.iter().map(read).collect::<Result<Vec<_>, _>>()?;
        let fail = |what: String, help: &str| Err(StudyError::new(what, help));
        if variables.is_empty() {
            return fail("nothing scatters: the case gives no friction".into(), "give --vary \"KEY=DISTRIBUTION\"");
        }
        if variables.len() > VARIABLES {
            return fail(format!("{} keys scatter", variables.len()), "128 at most");
        }
        for (i, one) in variables.iter().enumerate() {
            let conflicts = |other: &&UncertainVariable| one.conflicts_with(other) || other.conflicts_with(one);
            if let Some(other) = variables[..i].iter().find(conflicts) {
                return fail(format!("{} and {} set the same", other.key, one.key), "leave one out");
            }
        }
        if !(8..=MOST).contains(&runs) {
            return fail(format!("{runs} runs"), "give 8 to 4294967296, best a power of two");
        }
        for variable in &variables {
            let tried = [0.5, 0.001, 0.999].map(|u| base.case(&variable.settings(&variable.value(u))).map(drop));
            if let [Err(error), Err(_), Err(_)] = tried {
                return Err(error.into());
            }
        }
        Ok(Self { base, variables, runs, seed, defaults })
    }

    fn values(&self, index: u64) -> Vec<Value> {
        let seed = self.seed.wrapping_add((index / LONGEST) as u32);
        let point = (index % LONGEST) as u32;
        let coordinate = |i: usize| f64::from(sample(point, i as u32, seed)) + HALF;
        self.variables.iter().enumerate().map(|(i, variable)| variable.value(coordinate(i))).collect()
    }

    /// Statistics of all runs.
    pub fn result(&self, runs: &RunTable) -> UncertaintyResult {
        let known: Vec<&Run> = runs.runs.iter().filter(|run| run.light.is_some() && run.is_known()).collect();
        let inputs: Vec<Vec<f64>> =
            (0..self.variables.len()).map(|i| known.iter().map(|run| run.value(i)).collect()).collect();
        let correlations = |y: &[f64]| inputs.iter().map(|x| rank_correlation(x, y)).collect::<Vec<Option<f64>>>();
        let spreads = (0..runs.responses.len()).filter_map(|response| {
            let all: Vec<f64> = known.iter().map(|run| run.numbers[response]).collect();
            let mut values: Vec<f64> = all.iter().copied().filter(|value| value.is_finite()).collect();
            values.sort_by(f64::total_cmp);
            (!values.is_empty()).then(|| Spread { response, values, correlations: correlations(&all) })
        });
        let event = |kind: EventKind, light: Light, has: &dyn Fn(&Run) -> bool| {
            let hits: Vec<f64> = known.iter().map(|run| f64::from(u8::from(has(run)))).collect();
            let count = hits.iter().filter(|hit| **hit > 0.0).count();
            Some(Event {
                kind,
                light,
                hits: count,
                probability: wilson(count, known.len())?,
                correlations: correlations(&hits),
            })
        };
        let mut events = vec![event(EventKind::Tear, Light::Red, &Run::tears)];
        for light in [Light::Red, Light::Amber] {
            events.push(event(EventKind::Verdict, light, &|run: &Run| run.light == Some(light)));
        }
        for (key, _) in &runs.rows {
            let row = || EventKind::Row(key.clone());
            let hit = |event: Option<Event>| event.filter(|event| event.hits > 0);
            events.push(hit(event(row(), Light::Red, &|run: &Run| run.red.contains(key))));
            events.push(hit(event(row(), Light::Amber, &|run: &Run| run.amber.contains(key))));
        }
        UncertaintyResult { events: events.into_iter().flatten().collect(), spreads: spreads.collect() }
    }

    /// The variables with a noticeable rank correlation, the largest first: `friction +0.92, strength -0.31`.
    fn influences(&self, correlations: &[Option<f64>]) -> String {
        let mut all: Vec<(&str, f64)> =
            self.variables.iter().zip(correlations).filter_map(|(v, c)| Some((v.key.as_str(), (*c)?))).collect();
        all.retain(|(_, c)| c.abs() >= NAMED);
        all.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        all.iter().map(|(key, c)| format!("{key} {c:+.2}")).collect::<Vec<_>>().join(", ")
    }

    fn headline(&self, runs: &RunTable, result: &UncertaintyResult) -> String {
        let n = runs.runs.len();
        let percent = |share: f64| Amount::share(share).to_string();
        let Some(tear) = result.events.first() else { return format!("None of {n} runs came to a result.") };
        let p = tear.probability;
        match tear.hits {
            0 => format!("No tear in {n} parts: fewer than {} scrap, 95 % sure.", percent(p.high)),
            hits => format!("{hits} of {n} parts tear: {} to {}, 95 % sure.", percent(p.low), percent(p.high)),
        }
    }

    fn events_table(&self, runs: &RunTable, result: &UncertaintyResult) -> ReportTable {
        let columns = ["Light", "Row", "Share of parts", "from", "to", "Rank correlation"];
        let mut table = ReportTable::new("scatter_lights", &columns);
        for event in &result.events {
            let label = match &event.kind {
                EventKind::Tear => "Tears",
                EventKind::Verdict => "All together",
                EventKind::Row(key) => runs.label(key),
            };
            let Probability { value, low, high } = event.probability;
            let mut row = vec![Cell::Light(event.light, String::new()), label.into()];
            row.extend([value, low, high].map(|share| Cell::from(Amount::share(share))));
            row.push(self.influences(&event.correlations).into());
            table.rows.push(row);
        }
        table
    }

    fn numbers_table(&self, runs: &RunTable, result: &UncertaintyResult) -> ReportTable {
        let mut table = ReportTable::new("scatter_numbers", &["Number", "5 %", "Median", "95 %", "Rank correlation"]);
        for spread in &result.spreads {
            let number = &runs.responses[spread.response].number;
            let quantiles = QUANTILES.map(|share| quantile(&spread.values, share));
            if quantiles[0] == quantiles[2] {
                continue;
            }
            let mut row = vec![Cell::from(number.quantity.label)];
            row.extend(quantiles.map(|value| Cell::from(number.quantity.amount.of(value))));
            row.push(self.influences(&spread.correlations).into());
            table.rows.push(row);
        }
        table
    }
}

impl Study for Scatter {
    fn base(&self) -> &BaseCase {
        &self.base
    }

    fn key(&self) -> String {
        short_hash([self.base.key(), &format!("{:?}{}{}", self.variables, self.runs, self.seed)])
    }

    fn columns(&self) -> Vec<String> {
        self.variables.iter().map(UncertainVariable::header).collect()
    }

    fn designs(&self) -> u64 {
        self.runs
    }

    fn next(&mut self, _: &RunTable) -> Vec<Design> {
        let design = |index: u64| {
            let values = self.values(index);
            let settings = self.variables.iter().zip(&values).flat_map(|(variable, value)| variable.settings(value));
            Design::new(index, &values, settings.collect())
        };
        (0..self.runs).map(design).collect()
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let result = self.result(runs);
        let mut notes = Vec::new();
        let verdict = |light: Light| {
            let of = |event: &&Event| event.kind == EventKind::Verdict && event.light == light;
            result.events.iter().find(of).map_or(0.0, |event| event.probability.value)
        };
        let [red, amber] = [Light::Red, Light::Amber].map(|light| Amount::share(verdict(light)));
        notes.push(format!("{red} of the parts are red, {amber} amber, if the distributions are as given."));
        let failed = runs.runs.iter().filter(|run| !run.is_known()).count();
        if failed > 0 {
            notes.push(format!("{failed} runs came to no result and are left out."));
        }
        notes.extend(self.defaults.iter().cloned());
        StudyReport {
            headline: self.headline(runs, &result),
            notes,
            tables: vec![self.events_table(runs, &result), self.numbers_table(runs, &result)],
            found: true,
            charts: charts::scatter(runs, &result).map(|chart| ("scatter".to_owned(), chart)).into_iter().collect(),
        }
    }
}
