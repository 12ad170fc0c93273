//! One evaluation: a design and the responses of its run.

use super::variable::Value;
use super::{BaseCase, FailureMode};
use crate::assess::{self, Light};
use crate::case::Solution;
use crate::units::{Limits, rounded};
use crate::verification::{Number, Origin, Outcome, Watch, quick};

/// A point of a study: values of its variables and the overrides that set them.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// Position in the study, from 0.
    pub index: u64,
    /// One per variable; empty texts stand for the case's own value.
    pub values: Vec<String>,
    /// Overrides of the case.
    pub settings: Vec<String>,
}

impl Design {
    /// A design with these values and overrides.
    pub fn new(index: u64, values: &[Value], settings: Vec<String>) -> Self {
        Self { index, values: values.iter().map(|value| value.text.clone()).collect(), settings }
    }
}

/// A number that every run of a study has.
#[derive(Clone, Debug, PartialEq)]
pub struct Response {
    /// Column of the table: `thinnest_mm`.
    pub column: String,
    /// The base case's number.
    pub number: Number,
    /// Its limits, if a row of the verdict judges it.
    pub limits: Option<Limits>,
}

impl Response {
    /// A value of it with its unit.
    pub fn display(&self, value: f64) -> String {
        self.number.quantity.amount.of(value).to_string()
    }
}

/// A row of a run table.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// Position in the study, from 0.
    pub index: u64,
    /// Values of the variables, see [`Design::values`].
    pub values: Vec<String>,
    /// Hash of all inputs; empty if the design is no case.
    pub inputs: String,
    /// Responses, rounded as they are written; NaN if the run has none.
    pub numbers: Vec<f64>,
    /// Half the error bars; empty without error bars, NaN where a number has none.
    pub errors: Vec<f64>,
    /// Worst light of the verdict; `None` if it was not run.
    pub light: Option<Light>,
    /// Failure modes; empty for a sound part.
    pub failures: Vec<FailureMode>,
    /// Red rows of the verdict.
    pub red: Vec<String>,
    /// Amber rows of the verdict.
    pub amber: Vec<String>,
    /// How it ended: `full travel`.
    pub end: String,
    /// Why it did not complete; else empty.
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
        self.values.get(variable).and_then(|text| text.replace('−', "-").parse().ok()).unwrap_or(f64::NAN)
    }
}

/// Column of a number; a judged one may have the key of another.
pub(super) fn column(number: &Number, suffix: &str) -> String {
    let judged = if number.origin == Origin::Verdict { "_judged" } else { "" };
    number.quantity.amount.unit.keyed(&format!("{}{judged}{suffix}", number.quantity.key))
}

/// Responses of a solved base case.
pub(super) fn responses(solution: &Solution) -> (Outcome, Vec<Response>, Vec<(String, String)>) {
    let findings = assess::after_one_of_many(&solution.case, &solution.stages);
    let outcome = Outcome::with_findings(solution, None, &findings);
    let limits = |number: &Number| {
        assess::judgements(&findings)
            .find(|row| number.origin == Origin::Verdict && row.key == number.quantity.key)?
            .quantity
            .as_ref()?
            .limits
    };
    let responses = outcome.numbers.iter().map(|number| Response {
        column: column(number, ""),
        number: number.clone(),
        limits: limits(number),
    });
    let rows = assess::judgements(&findings).map(|row| (row.key.to_owned(), row.label.to_owned())).collect();
    (outcome.clone(), responses.collect(), rows)
}

/// Runs a design; with `errors` also one coarser run for error bars.
pub(super) fn evaluate_design(
    base: &BaseCase,
    design: &Design,
    responses: &[Response],
    errors: bool,
    watch: &dyn Watch,
) -> Evaluated {
    let mut inputs = String::new();
    let solved = base.case(&design.settings).map_err(|error| error.to_string()).and_then(|case| {
        inputs = BaseCase::input_hash(&case);
        BaseCase::solve(case, watch)
    });
    match solved {
        Ok(solution) => evaluated(&solution, design, inputs, responses, errors, watch),
        Err(reason) => {
            let none = vec![f64::NAN; responses.len()];
            let run = Run {
                index: design.index,
                values: design.values.clone(),
                inputs,
                errors: if errors { none.clone() } else { Vec::new() },
                numbers: none,
                light: None,
                failures: vec![FailureMode::NoResult],
                red: Vec::new(),
                amber: Vec::new(),
                end: "not run".into(),
                reason: one_line(&reason),
            };
            Evaluated { run, outcome: None }
        }
    }
}

/// The row of a solved design.
pub(super) fn evaluated(
    solution: &Solution,
    design: &Design,
    inputs: String,
    responses: &[Response],
    errors: bool,
    watch: &dyn Watch,
) -> Evaluated {
    let findings = assess::after_one_of_many(&solution.case, &solution.stages);
    let outcome = Outcome::with_findings(solution, None, &findings);
    let of = |light: Light| {
        assess::judgements(&findings).filter(move |row| row.light == light).map(|row| row.key.to_owned()).collect()
    };
    let own = |response: &Response| outcome.numbers.iter().find(|number| number.is(&response.number));
    let numbers =
        responses.iter().map(|r| own(r).map_or(f64::NAN, |number| rounded(number.quantity.value()))).collect();
    let half_widths = if errors {
        let verification = quick(solution, &Silent(watch));
        let half = |r: &Response| verification.number(r.number.origin, r.number.quantity.key)?.half();
        responses.iter().map(|r| half(r).map_or(f64::NAN, rounded)).collect()
    } else {
        Vec::new()
    };
    let run = Run {
        index: design.index,
        values: design.values.clone(),
        inputs,
        numbers,
        errors: half_widths,
        light: Some(assess::judgements(&findings).map(|row| row.light).max().unwrap_or(Light::Grey)),
        failures: FailureMode::all(&solution.stages, &findings),
        red: of(Light::Red),
        amber: of(Light::Amber),
        end: outcome.end.kind.to_owned(),
        reason: if outcome.end.complete { String::new() } else { one_line(&outcome.end.why.to_string()) },
    };
    Evaluated { run, outcome: Some(outcome) }
}

/// Watch that ends a coarser run with the study and does not count it.
pub(super) struct Silent<'a>(pub &'a dyn Watch);

impl Watch for Silent<'_> {
    fn wants_to_stop(&self) -> bool {
        self.0.wants_to_stop()
    }
}

fn one_line(text: &str) -> String {
    text.split_whitespace().filter(|word| *word != "×").collect::<Vec<_>>().join(" ")
}
