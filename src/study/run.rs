//! One evaluation: a design and the responses of its run.

use super::{verify::Outcome, *};

/// A point of a study: values of its variables and the overrides that set them.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Position in the study, from 0.
    pub index: u64,
    /// One per variable; empty texts stand for the case's own value.
    pub values: Vec<String>,
    pub(super) settings: Vec<String>,
}

/// A row of a run table.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Run {
    /// Position in the study, from 0.
    pub index: u64,
    /// Values of the variables, see [`Design::values`].
    pub values: Vec<String>,
    pub(super) inputs: String,
    /// Responses, rounded as they are written; NaN if the run has none.
    pub numbers: Vec<f64>,
    /// Worst light of the verdict; `None` if it was not run.
    pub light: Option<Light>,
    /// Failure modes; empty for a sound part.
    pub failures: Vec<FailureMode>,
    /// Red rows of the verdict.
    pub red: Vec<String>,
    /// Amber rows of the verdict.
    pub amber: Vec<String>,
    pub(super) end: String,
    /// Reason of an early end; else empty.
    pub reason: String,
}

/// A run with the curves that no table keeps.
#[derive(Clone, Debug)]
pub struct Evaluated {
    /// The row.
    pub run: Run,
    /// Numbers and curves; `None` if it was not run.
    pub outcome: Option<Outcome>,
}

impl Run {
    pub(super) fn failed(design: &Design, inputs: String, responses: usize) -> Self {
        let (index, values) = (design.index, design.values.clone());
        let (numbers, failures) = (vec![f64::NAN; responses], vec![FailureMode::NoResult]);
        Self { index, values, inputs, numbers, failures, end: "not run".into(), ..Self::default() }
    }

    /// Whether it came to a result.
    pub fn is_known(&self) -> bool {
        !self.failures.contains(&FailureMode::NoResult)
    }

    /// Whether the part is sound.
    pub fn is_sound(&self) -> bool {
        self.failures.is_empty()
    }

    /// Whether the sheet tears.
    pub fn tears(&self) -> bool {
        self.failures.contains(&FailureMode::Tears)
    }

    /// A variable as a number.
    pub fn value(&self, variable: usize) -> f64 {
        self.values.get(variable).and_then(|text| number(text)).unwrap_or(f64::NAN)
    }

    /// A response, if the run came to one.
    pub fn response(&self, place: usize) -> Option<f64> {
        Some(self.numbers[place]).filter(|value| self.is_known() && value.is_finite())
    }
}

pub(super) fn response_key(number: &Number) -> String {
    format!("{}{}", number.quantity.key, if number.origin == Origin::Verdict { "_judged" } else { "" })
}

pub(super) fn column(number: &Number) -> String {
    number.quantity.amount.unit.keyed(&response_key(number))
}

pub(super) fn responses(solution: &Solution) -> (Vec<Number>, Vec<(String, String)>) {
    let findings = assess::after(&solution.case, &solution.stages);
    let rows = assess::judgements(&findings).map(|row| (row.key.to_owned(), row.label.to_owned()));
    (Outcome::with_findings(solution, &findings).numbers, rows.collect())
}

pub(super) fn evaluate_design(base: &BaseCase, design: &Design, responses: &[Number], watch: &dyn Watch) -> Evaluated {
    let case = base.case(&design.settings).map_err(|error| error.to_string());
    let run = Run::failed(design, case.as_ref().map_or_else(|_| String::new(), BaseCase::input_hash), responses.len());
    match case.and_then(|case| BaseCase::solve(case, watch)) {
        Ok(solution) => evaluated(run, &solution, responses),
        Err(reason) => Evaluated { run: Run { reason: one_line(&reason), ..run }, outcome: None },
    }
}

pub(super) fn evaluated(mut run: Run, solution: &Solution, responses: &[Number]) -> Evaluated {
    let findings = assess::after(&solution.case, &solution.stages);
    let outcome = Outcome::with_findings(solution, &findings);
    let own = |response: &Number| outcome.numbers.iter().find(|number| number.is(response));
    run.numbers = responses.iter().map(|r| own(r).map_or(f64::NAN, |own| rounded(own.quantity.amount.value))).collect();
    let rows = |light: Light| assess::judgements(&findings).filter(move |row| row.light == light);
    [run.red, run.amber] = [Light::Red, Light::Amber].map(|light| rows(light).map(|row| row.key.to_owned()).collect());
    run.light = assess::judgements(&findings).map(|row| row.light).max().or(Some(Light::Grey));
    run.failures = FailureMode::all(&solution.stages, &findings);
    run.end = outcome.end.kind.to_owned();
    if !outcome.end.complete {
        run.reason = one_line(&outcome.end.why.to_string());
    }
    Evaluated { run, outcome: Some(outcome) }
}

pub(super) struct Silent<'a>(pub &'a dyn Watch);

impl Watch for Silent<'_> {
    fn wants_to_stop(&self) -> bool {
        self.0.wants_to_stop()
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().filter(|word| *word != "×").collect::<Vec<_>>().join(" ")
}
