//! Error bars of a verified case: on its numbers, and on the lights of its verdict.

use super::{tear::remedy, *};

const RUN: &str = "stop";
/// Contributions in text: the largest, each at least this share of the bar \[–\].
const MOST: usize = 3;
const SHARE: f64 = 0.05;

named! {
    /// List that a number stands in; keys are unique there.
    pub enum Origin;
    /// Name in files.
    fn key;
    Answer: "answer", "Numbers of the [`Answer`].";
    Part: "part", "Numbers of the part and the press.";
    Verdict: "verdict", "Rows of the verdict.";
}

/// Number of a solution, of all its stages together.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// List that it stands in.
    pub origin: Origin,
    /// Value with its error bar.
    pub quantity: Quantity,
    /// Place to look other runs' values up at, as initial distance from the axis \[mm\]: the worst place jumps.
    pub s0: Option<f64>,
    /// Contributions to the error bar, the largest first.
    pub contributions: Vec<Contribution>,
    /// Smallest and largest value of the finer runs.
    pub finer: Option<[f64; 2]>,
}

/// Contribution of one direction of refinement to an error bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// Refined direction: `contact stiffness`.
    pub direction: &'static str,
    /// Estimated upper bound of the discretisation error, in the number's unit.
    pub error: f64,
    /// Observed order of convergence, if the differences keep their sign \[–\].
    pub order: Option<f64>,
    /// True if it was extrapolated with that order, false if it is from the spread.
    pub extrapolated: bool,
    /// Share of the whole bar \[–\].
    pub share: f64,
}

/// Discretisation errors of a solution.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ErrorBars {
    /// Every number with its error bar.
    pub numbers: Vec<Number>,
    /// Sentences on whatever is no small error.
    pub notes: Vec<String>,
    /// Number of refined runs.
    pub runs: usize,
    /// Refinement of a run that came to another end for a reason of the part's: `2 times the elements`.
    pub finer_that_differs: Option<String>,
    /// Reason of the run's end.
    pub why: String,
}

impl Number {
    /// Number without an error bar.
    pub fn new(origin: Origin, quantity: Quantity) -> Self {
        Self { origin, quantity, s0: None, contributions: Vec::new(), finer: None }
    }

    /// True of the same number of another run.
    pub fn is(&self, other: &Self) -> bool {
        (self.origin, self.quantity.key) == (other.origin, other.quantity.key)
    }

    /// Half its error bar, in its unit; 0 if no refinement moves it.
    pub fn half(&self) -> Option<f64> {
        if let ErrorBar::Half(half) = self.quantity.error { Some(half) } else { None }
    }

    /// Number that has no error bar for a reason.
    pub fn without_bar(&self, why: &str) -> Self {
        Self { quantity: self.quantity.clone().with_error(ErrorBar::Missing(why.to_owned())), ..self.clone() }
    }

    /// Origin, key and unit in files.
    pub fn name(&self) -> [&'static str; 3] {
        [self.origin.key(), self.quantity.key, self.quantity.amount.unit.spelled()]
    }

    /// Contributions, such as `contact smoothing 62 % (1.1)` with an observed order if extrapolated; or why there is no bar.
    pub fn made_of(&self) -> String {
        match &self.quantity.error {
            ErrorBar::Missing(why) => return format!("no bar: {why}"),
            ErrorBar::Half(half) if *half > 0.0 => {}
            _ => return ErrorBar::UNMOVED.to_owned(),
        }
        let parts = self.contributions.iter().filter(|part| part.share >= SHARE).take(MOST).map(|part| {
            let order = part.order.filter(|_| part.extrapolated).map(|order| format!(" ({})", Amount::norm(order)));
            format!("{} {}{}", part.direction, Amount::share(part.share), order.unwrap_or_default())
        });
        joined(parts, ", ")
    }
}

impl Serialize for Number {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Quantity { key, amount, error, .. } = &self.quantity;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("key", key)?;
        map.serialize_entry("value", &rounded(amount.value))?;
        error.write(&mut map)?;
        map.serialize_entry("unit", amount.unit.spelled())?;
        map.serialize_entry("told", &amount.to_string())?;
        map.serialize_entry("made_of", &self.made_of())?;
        map.end()
    }
}

/// Answer to a solved case with its findings; with error bars if it was verified.
pub fn answered(solution: &Solution, bars: Option<&ErrorBars>) -> (Answer, Vec<Finding>) {
    weighed(solution, after(&solution.case, &solution.stages), bars)
}

/// Answer by findings that are known, with error bars if the case was verified.
pub fn weighed(solution: &Solution, findings: Vec<Finding>, bars: Option<&ErrorBars>) -> (Answer, Vec<Finding>) {
    let Solution { case, stages, .. } = solution;
    let Some(bars) = bars else { return (Answer::of(case, stages, &findings), findings) };
    let findings = bars.weigh(case.model(), findings);
    let mut answer = Answer::of(case, stages, &findings);
    for number in &mut answer.numbers {
        let error = bars.error(Origin::Answer, number.key, "given, not computed");
        let half = if let ErrorBar::Half(half) = error { Some(half) } else { None };
        let loaded = half.filter(|_| number.key == "punch_force").and_then(|half| press::load(case, stages, half));
        *number = loaded.unwrap_or_else(|| number.clone()).with_error(error);
    }
    (answer, findings)
}

impl ErrorBars {
    /// Sentence on an answer without them.
    pub const NONE: &str = "without error bars, which `check --run` and `report` judge by too";

    /// Number by its origin and key.
    pub fn number(&self, origin: Origin, key: &str) -> Option<&Number> {
        self.numbers.iter().find(|number| number.origin == origin && number.quantity.key == key)
    }

    fn error(&self, origin: Origin, key: &str, why_none: &str) -> ErrorBar {
        let missing = || ErrorBar::Missing(why_none.to_owned());
        self.number(origin, key).map_or_else(missing, |number| number.quantity.error.clone())
    }

    /// Findings with their bars: a light is green only if the whole bar is.
    pub fn weigh(&self, model: &Model, mut findings: Vec<Finding>) -> Vec<Finding> {
        for finding in &mut findings {
            let clause = self.clause(finding);
            let error = self.error(Origin::Verdict, finding.key, "not estimated: it judges the solution, not the part");
            finding.quantity = finding.quantity.take().map(|number| number.with_error(error));
            if let Some(clause) = clause {
                finding.text = joined([format!("{clause}: {}", finding.text), self.finer(finding.key)], "; ");
                finding.advice = match finding.key {
                    RUN => "take the worse end as the true one, or refine until all runs end alike".into(),
                    "tearing" => remedy(model).into(),
                    _ => std::mem::take(&mut finding.advice),
                };
                finding.light = finding.light.max(Light::Amber);
            }
            finding.advice = joined([self.refinement(finding), std::mem::take(&mut finding.advice)], "; ");
        }
        findings
    }

    fn refinement(&self, finding: &Finding) -> String {
        let tolerance = finding.limits().and_then(|limits| limits.red).filter(|_| finding.key == "springback");
        let half = self.number(Origin::Verdict, finding.key).and_then(Number::half);
        let is_wider = half.zip(tolerance).is_some_and(|(half, tolerance)| half > tolerance);
        let keys = "a finer mesh and steps narrow it (blank.elements, solver.max_step, blank.layers)";
        if is_wider { format!("the error bar is wider than the tolerance: {keys}") } else { String::new() }
    }

    fn finer(&self, key: &str) -> String {
        let number = self.number(Origin::Verdict, key);
        let Some(Number { quantity, finer: Some(ends), .. }) = number else { return String::new() };
        let [low, high] = ends.map(|end| Amount::new(end, quantity.amount.unit, Digits::Significant(3)));
        format!("the finer runs give {low} to {high}")
    }

    /// Sentences on rows of the verdict whose bar reaches a worse light.
    pub fn moved(&self, Solution { case, stages, .. }: &Solution) -> Vec<String> {
        let findings = after(case, stages);
        let weighed = self.weigh(case.model(), findings.clone());
        let moved = weighed.iter().zip(&findings).filter(|(after, before)| after.text != before.text);
        moved.map(|(after, _)| format!("{}: {}", after.label, after.statement())).collect()
    }

    fn clause(&self, finding: &Finding) -> Option<String> {
        if finding.kind != Kind::Judgement || finding.light == Light::Grey {
            return None;
        }
        if finding.key == RUN {
            let finer = self.finer_that_differs.as_ref().filter(|_| finding.light == Light::Green)?;
            return Some(format!("with {finer} it ends otherwise"));
        }
        let (bar, amount) = (self.number(Origin::Verdict, finding.key)?.half()?, finding.quantity.as_ref()?.amount);
        let Limits { sense, amber, red } = finding.limits()?;
        let is_beyond = |limit: &f64| match sense {
            Sense::AtMost => amount.value + bar > *limit,
            Sense::AtLeast => amount.value - bar < *limit,
        };
        let red = red.filter(is_beyond).map(|limit| (Light::Red, "red at", limit));
        let (light, at, limit) = red.or_else(|| Some((Light::Amber, "the limit of", amber.filter(is_beyond)?)))?;
        let limit = amount.with_value(limit).to(Digits::Given(3));
        (light > finding.light).then(|| format!("with its error bar it reaches {at} {limit}"))
    }

    /// Origin of the bars in a few words.
    pub fn method(&self) -> String {
        if self.runs == 0 { "no error bars".into() } else { format!("error bars from {} finer runs", self.runs) }
    }

    /// Every number with its error bar.
    pub fn amounts(&self) -> Vec<Amount> {
        self.numbers.iter().map(|number| number.quantity.amount).collect()
    }

    /// Sentences below the answer's numbers: origin of the bars, numbers without one and why, and all notes.
    pub fn sentences(&self) -> Vec<String> {
        let answer = || self.numbers.iter().filter(|number| number.origin == Origin::Answer);
        let reason = |number: &Number| match &number.quantity.error {
            ErrorBar::Missing(why) => Some((number.quantity.label, why.clone())),
            _ => None,
        };
        let without: Vec<(&str, String)> = answer().filter_map(reason).collect();
        if answer().all(|number| number.half().is_none()) && without.iter().all(|(_, why)| *why == without[0].1) {
            let why = without.first().map_or(&self.why, |(_, why)| why);
            let notes = self.notes.iter().filter(|note| *note != why).cloned();
            return [format!("no error bars: {why}")].into_iter().chain(notes).collect();
        }
        let what = "mesh, steps and contact, not laws and friction";
        let without = without.into_iter().map(|(label, why)| format!("{label}: no error bar, {why}"));
        [format!("{}: {what}", self.method())].into_iter().chain(without).chain(self.notes.iter().cloned()).collect()
    }
}

/// JSON of the bars: method, number of further runs, sentences, and the numbers of the part and the press.
impl Serialize for ErrorBars {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let numbers: Vec<_> = self.numbers.iter().filter(|number| number.origin != Origin::Verdict).collect();
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("method", &self.method())?;
        map.serialize_entry("runs", &self.runs)?;
        map.serialize_entry("told", &self.sentences())?;
        map.serialize_entry("numbers", &numbers)?;
        map.end()
    }
}
