//! Scatter: a quasi-random sample of uncertain variables, the probability of each light, and the main influences.
//!
//! The sample is a scrambled Sobol sequence. Wilson's intervals take its points as independent, which is on the safe side.

use super::{uncertain_variable::UncertainVariable, variable::check_distinct, *};
use crate::numerics::statistics::{rank_correlation, wilson};
use sobol_burley::sample;

/// Default sample size; a Sobol sequence is most even at a power of two.
const RUNS: u64 = 1024;
/// Points of one sequence; further points are of another scrambling.
const LONGEST: u64 = 1 << 16;
const MOST: u64 = 1 << 32;
const VARIABLES: usize = 128;
/// Half the resolution of the sequence: no coordinate is 0 or 1.
const HALF: f64 = 0.5 / (1u32 << 24) as f64;
const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];
/// Rank correlations that are named \[–\].
const NAMED: f64 = 0.3;
const TEARS: &str = "Tears";
const ALL: &str = "All together";

/// A sample of uncertain variables.
#[derive(Clone, Debug)]
pub struct Scatter {
    plan: Plan,
    variables: Vec<UncertainVariable>,
    seed: u32,
}

/// A light and its probability.
#[derive(Clone, Debug)]
pub struct Event {
    /// Label of the row that has the light, or of the whole verdict.
    pub label: String,
    pub(super) light: Light,
    /// Runs that have it.
    pub hits: usize,
    /// Share of the runs and its interval of 95 %.
    pub probability: [f64; 3],
    pub(super) correlations: Vec<Option<f64>>,
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
    pub fn load(path: &Path, set: Vec<String>, vary: &[String], runs: Option<u64>, seed: Option<u32>) -> Result<Self> {
        let file = StudyFile::load(path, set, vary)?;
        let (runs, seed) = (runs.or(file.runs).unwrap_or(RUNS), seed.or(file.seed).unwrap_or(1));
        Self::new(BaseCase::load(file.case, file.set)?, &file.variables, runs, seed)
    }

    /// Samples `KEY=DISTRIBUTION` variables of a case; if none is given, its thickness within the tolerance of its standard.
    pub fn new(base: BaseCase, vary: &[String], runs: u64, seed: u32) -> Result<Self> {
        let case = base.case(&[])?;
        let variable = |text: &String| UncertainVariable::read(&base, &case, text);
        let default = Vec::from_iter(UncertainVariable::default_of(&case).filter(|_| vary.is_empty()));
        let variables = vary.iter().chain(&default).map(variable).collect::<Result<Vec<_>, _>>()?;
        let help = "give --vary \"KEY=DISTRIBUTION\", such as \"friction=uniform 0.05..0.12\"";
        ensure(!variables.is_empty(), "nothing of the case scatters", help)?;
        ensure(variables.len() <= VARIABLES, format!("{} keys scatter", variables.len()), "128 at most")?;
        check_distinct(variables.iter().map(|uncertain| &uncertain.variable), "is given twice", "leave one out")?;
        ensure((8..=MOST).contains(&runs), format!("{runs} runs"), "give 8 to 4294967296, best a power of two")?;
        let at = |variable: &UncertainVariable, share: f64| variable.settings(&variable.value(share));
        variables.iter().try_for_each(|one| base.check_any([0.5, 0.001, 0.999].map(|share| at(one, share))))?;
        let absolute = variables.iter().filter(|variable| variable.is_absolute);
        base.check_effective(&absolute.flat_map(|variable| at(variable, 0.5)).collect::<Vec<_>>())?;
        let columns = variables.iter().map(|uncertain| uncertain.variable.header()).collect();
        Ok(Self { plan: Plan::new(base, &format!("{variables:?}{runs}{seed}"), columns, runs), variables, seed })
    }

    /// Lights by their rows, the most important first, and the spread of every response.
    pub fn result(&self, runs: &RunTable) -> (Vec<Event>, Vec<Spread>) {
        let known: Vec<&Run> = runs.runs.iter().filter(|run| run.light.is_some() && run.is_known()).collect();
        let inputs = (0..self.variables.len()).map(|i| known.iter().map(|run| run.value(i)).collect());
        let inputs: Vec<Vec<f64>> = inputs.collect();
        let correlations = |y: &[f64]| inputs.iter().map(|x| rank_correlation(x, y)).collect::<Vec<Option<f64>>>();
        let spreads = (0..runs.responses.len()).filter_map(|response| {
            let mut values: Vec<f64> = known.iter().map(|run| run.numbers[response]).collect();
            let correlations = correlations(&values);
            values.retain(|value| value.is_finite());
            values.sort_by(f64::total_cmp);
            (!values.is_empty()).then_some(Spread { response, values, correlations })
        });
        let event = |label: &str, light: Light, has: &dyn Fn(&Run) -> bool| {
            let all: Vec<f64> = known.iter().map(|run| f64::from(u8::from(has(run)))).collect();
            let hits = all.iter().filter(|hit| **hit > 0.0).count();
            let probability = wilson(hits, known.len())?;
            Some(Event { label: label.to_owned(), light, hits, probability, correlations: correlations(&all) })
        };
        let mut events = vec![event(TEARS, Light::Red, &Run::tears)];
        events.extend([Light::Red, Light::Amber].map(|light| event(ALL, light, &|run| run.light == Some(light))));
        for (key, label) in &runs.rows {
            events.push(event(label, Light::Red, &|run| run.red.contains(key)).filter(|event| event.hits > 0));
            events.push(event(label, Light::Amber, &|run| run.amber.contains(key)).filter(|event| event.hits > 0));
        }
        (events.into_iter().flatten().collect(), spreads.collect())
    }

    fn influences(&self, correlations: &[Option<f64>]) -> Cell {
        let pairs = self.variables.iter().zip(correlations);
        let mut all: Vec<(&str, f64)> = pairs.filter_map(|(v, c)| Some((v.variable.key.as_str(), (*c)?))).collect();
        all.retain(|(_, c)| c.abs() >= NAMED);
        all.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        joined(all.iter().map(|(key, c)| format!("{key} {c:+.2}")), ", ").into()
    }

    fn tables(&self, runs: &RunTable, events: &[Event], spreads: &[Spread]) -> Vec<ReportTable> {
        let columns = ["Light", "Row", "Share of parts", "from", "to", "Rank correlation"];
        let lights = events.iter().map(|event| {
            let [value, low, high] = event.probability.map(|share| Amount::share(share).into());
            let (light, label) = (Cell::Light(event.light, String::new()), event.label.clone().into());
            [light, label, value, low, high, self.influences(&event.correlations)]
        });
        let lights = ReportTable::new("scatter_lights", &columns, lights);
        let numbers = spreads.iter().filter_map(|spread| {
            let number = &runs.responses[spread.response].quantity;
            let quantiles = QUANTILES.map(|share| quantile(&spread.values, share));
            let [low, median, high] = quantiles.map(|value| number.amount.with_value(value).into());
            let row = [number.label.into(), low, median, high, self.influences(&spread.correlations)];
            (quantiles[0] != quantiles[2]).then_some(row)
        });
        let columns = ["Number", "5 %", "Median", "95 %", "Rank correlation"];
        vec![lights, ReportTable::new("scatter_numbers", &columns, numbers)]
    }
}

impl Study for Scatter {
    fn plan(&self) -> &Plan {
        &self.plan
    }

    fn design(&self, index: u64) -> Design {
        let seed = self.seed.wrapping_add((index / LONGEST) as u32);
        let point = (index % LONGEST) as u32;
        let coordinate = |i: usize| f64::from(sample(point, i as u32, seed)) + HALF;
        let values: Vec<String> = (0..).zip(&self.variables).map(|(i, one)| one.value(coordinate(i))).collect();
        let settings = self.variables.iter().zip(&values).flat_map(|(variable, value)| variable.settings(value));
        Design { index, settings: settings.collect(), values }
    }

    fn report(&self, runs: &RunTable) -> StudyReport {
        let (events, spreads) = self.result(runs);
        let n = runs.runs.len();
        let [tears, red, amber] = [0, 1, 2].map(|i| events.get(i).map(|event| event.probability.map(Amount::share)));
        let headline = match tears {
            None => runs.no_result().unwrap_or_default(),
            Some([_, _, high]) if events[0].hits == 0 => {
                format!("No tear in {n} parts: fewer than {high} scrap, 95 % sure.")
            }
            Some([_, low, high]) => format!("{} of {n} parts tear: {low} to {high}, 95 % sure.", events[0].hits),
        };
        let [red, amber] = [red, amber].map(|shares| shares.map_or(Amount::share(0.0), |[share, ..]| share));
        let failed = runs.runs.iter().filter(|run| !run.is_known()).count();
        let known = format!("{red} of the parts are red, {amber} amber, if the distributions are as given.");
        let mut notes: Vec<String> = (failed < n).then_some(known).into_iter().collect();
        notes.extend((1..n).contains(&failed).then(|| format!("{failed} runs came to no result and are left out.")));
        notes.extend(self.variables.iter().filter_map(|variable| variable.source.clone()));
        let (tables, charts) = (self.tables(runs, &events, &spreads), charts::scatter(runs, &spreads));
        StudyReport { headline, notes, tables, found: failed < n, charts }
    }
}
