//! The numbers of a solution that can have a bar: one list of all.

use crate::assess::{self, Answer, Finding, forming_limit_used, largest_force};
use crate::case::Case;
use crate::measure::{Shape, changes, thickest};
use crate::model::{Motion, Role, mesh};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::units::{Amount, Digits};

/// Who tells a number; its key is one of a kind there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// One of the [`Answer`]'s.
    Answer,
    /// Number of the part or the press.
    Part,
    /// Number of a row of the verdict.
    Verdict,
}

impl Of {
    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Answer => "answer",
            Self::Part => "part",
            Self::Verdict => "verdict",
        }
    }
}

/// A number of a solution, of all its stages together.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Who tells it.
    pub of: Of,
    /// Name in files and JSON, as its teller has it.
    pub key: &'static str,
    /// Name in tables.
    pub label: &'static str,
    /// The number with its unit.
    pub amount: Amount,
    /// The element or step that a place or a travel is read off by, in the number's unit; 0 of others.
    pub resolution: f64,
    /// Initial distance from the axis \[mm\] of the place that it is of, where another run's is looked up there: the worst place
    /// jumps between places that are as near to the limit, and the share of one is no error of the other's.
    pub place: Option<f64>,
}

/// Inputs that are told among the answer's numbers, and what is one where the case gives the force.
const GIVEN: [&str; 2] = ["blank", "holder_gap"];
const HOLDER: &str = "holder_force";

/// The row of the verdict whose number is of one place of the sheet.
const LIMIT: &str = "forming_limit";

/// Rows of the verdict that judge the numerics themselves: what a refinement does to them says nothing of a part.
const OF_THE_SOLVER: [&str; 1] = ["solution_quality"];

impl Number {
    fn new(key: &'static str, label: &'static str, amount: Amount) -> Self {
        Self { of: Of::Part, key, label, amount, resolution: 0.0, place: None }
    }

    fn by(self, resolution: f64) -> Self {
        Self { resolution, ..self }
    }

    /// Whether it is the same number as another run's.
    pub fn is(&self, other: &Self) -> bool {
        (self.of, self.key) == (other.of, other.key)
    }
}

/// Every number of a case's solved stages, in the order of telling.
pub fn numbers(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Vec<Number> {
    let told = Answer::of(case, stages, findings).numbers;
    let used = forming_limit_used(stages);
    let answer = told.iter();
    let is_given = |key: &str| GIVEN.contains(&key) || key == HOLDER && is_held_by_a_force(case);
    let answer = answer
        .filter(|number| !is_given(number.key))
        .map(|number| Number { of: Of::Answer, ..Number::new(number.key, number.label, number.amount) });
    let judged = assess::judgements(findings).filter(|row| !OF_THE_SOLVER.contains(&row.key));
    let judged = judged.filter_map(|row| {
        let amount = row.quantity.as_ref()?.amount.to(Digits::Significant(3));
        let place = used.as_ref().filter(|_| row.key == LIMIT).map(|used| used.worst);
        Some(Number { of: Of::Verdict, place, ..Number::new(row.key, row.label, amount) })
    });
    let is_told = |part: &Number| told.iter().any(|number| number.key == part.key);
    let part = of_the_part(stages).into_iter().filter(|part| !is_told(part));
    let all = answer.chain(of_the_press(stages)).chain(part).chain(judged);
    all.filter(|number| number.amount.value.is_finite()).collect()
}

/// Whether the case gives the force of its holder, which does not feel where it stands.
fn is_held_by_a_force(case: &Case) -> bool {
    let holder = case.model().tool(Role::Holder);
    holder.is_some_and(|holder| matches!(&holder.motion, Motion::Pressed(press) if press.stiffness == 0.0))
}

/// Travel of the largest force, force at half travel, and travel of a run that ended early.
fn of_the_press(stages: &[StageSolution]) -> Vec<Number> {
    let mut numbers = Vec::new();
    if let Some((i, peak)) = largest_force(stages) {
        let stage = &stages[i];
        let place = Amount::place(peak.travel);
        numbers.push(Number::new("peak_travel", "Travel at the peak", place).by(step_at(stage, peak)));
        let half = 0.5 * stage.model.travel;
        if let Some(force) = force_at(&stage.steps, half) {
            let amount = Amount::force(force, stage.model.extent().force_unit());
            numbers.push(Number::new("half_travel_force", "Force at half travel", amount));
        }
    }
    let early = stages.last().filter(|stage| !stage.stop.is_complete() && stage.model.travel > 0.0);
    if let Some((stage, last)) = early.and_then(|stage| Some((stage, stage.steps.last()?))) {
        let place = Amount::place(last.travel);
        numbers.push(Number::new("end_travel", "Travel at its end", place).by(step_at(stage, last)));
    }
    numbers
}

/// The places where the sheet is thinnest and thickest, and the angles that it springs back to.
fn of_the_part(stages: &[StageSolution]) -> Vec<Number> {
    let mut numbers = Vec::new();
    let Some(stage) = stages.last() else { return numbers };
    if let Some(last) = stage.steps.last() {
        let place = Amount::place(last.thinnest_s0);
        numbers.push(Number::new("thinnest_place", "Thinnest at", place).by(element_at(stages, last.thinnest_s0)));
    }
    if let Some((thickness, s0)) = stage.frames.last().and_then(thickest) {
        numbers.push(Number::new("thickest", "Thickest", Amount::thickness(thickness)));
        numbers.push(Number::new("thickest_place", "Thickest at", Amount::place(s0)).by(element_at(stages, s0)));
    }
    if let Some([before, after]) = stage.released() {
        let measured = changes(&Shape::of(before), &Shape::of(after)).into_iter();
        numbers.extend(measured.filter_map(|change| {
            let amount = Amount::new(change.after?, change.quantity.unit, Digits::Decimals(1));
            Some(Number::new(change.quantity.key, change.quantity.label, amount))
        }));
    }
    numbers
}

/// Length of the step that ends with a record \[mm\].
fn step_at(stage: &StageSolution, record: &StepRecord) -> f64 {
    let before = stage.steps.iter().rev().find(|step| step.step < record.step);
    record.travel - before.map_or(0.0, |step| step.travel)
}

/// Length on the flat blank of the element at a place \[mm\].
fn element_at(stages: &[StageSolution], s0: f64) -> f64 {
    let Some(first) = stages.first() else { return 0.0 };
    let nodes = mesh::nodes(&first.model);
    let after = nodes.partition_point(|node| *node < s0).clamp(1, nodes.len() - 1);
    nodes[after] - nodes[after - 1]
}

/// Punch force \[N, or N/mm\] at a travel \[mm\], between the steps beside it.
fn force_at(steps: &[StepRecord], travel: f64) -> Option<f64> {
    let after = steps.partition_point(|step| step.travel < travel);
    let end = steps.get(after).filter(|_| travel > 0.0)?;
    let (x, force) = after.checked_sub(1).map_or((0.0, 0.0), |i| (steps[i].travel, steps[i].punch_force));
    Some(force + (end.punch_force - force) * (travel - x) / (end.travel - x))
}
