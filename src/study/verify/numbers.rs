//! Numbers of a solution that can have an error bar, with the curves and the end of its run.

use super::Direction;
use crate::assess::{self, Answer, Finding, after_one_of_many, forming_limit_used, largest_force};
use crate::case::{Case, Solution};
use crate::measure::{Shape, changes, thickest};
use crate::model::{Motion, Role, mesh};
use crate::numerics::interpolated;
use crate::results::error_bars::{Number, Origin};
use crate::solver::solution::{StageSolution, StepRecord, Stop};
use crate::units::{Amount, Digits, Quantity};

/// Answer's numbers that are inputs, and one that is if the case gives the force.
const INPUTS: [&str; 2] = ["blank", "holder_gap"];
const HOLDER: &str = "holder_force";

/// Row of the verdict whose number is of one place of the sheet.
const LIMIT: &str = "forming_limit";

/// Row of the verdict that judges the numerics themselves.
const NUMERICAL: &str = "solution_quality";

/// Numbers, curves and end of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Refined direction; `None` for the verified run.
    pub direction: Option<Direction>,
    /// Refinement factor \[–\]; below 1 coarser.
    pub times: f64,
    /// End.
    pub end: End,
    /// Numbers, without error bars.
    pub numbers: Vec<Number>,
    /// Punch force \[N, or N/mm\] over the travel \[mm\] of the stage with the largest; empty if no punch moves.
    pub load: Vec<(f64, f64)>,
    /// Thickness \[mm\] of the part over the initial distance from the axis \[mm\].
    pub thickness: Vec<(f64, f64)>,
    /// Used share of the forming limit \[%\] over the initial distance from the axis \[mm\], of the stage that comes nearest to
    /// it; empty without a limit.
    pub used: Vec<(f64, f64)>,
    /// Shortest element over the sheet thickness \[–\].
    pub shortest: f64,
}

/// End of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// Stages that were run.
    pub stages: usize,
    /// Reason of the last stage's end, in a few words.
    pub kind: &'static str,
    /// Reason as a sentence.
    pub why: String,
    /// True if it came to the requested end.
    pub complete: bool,
    /// True if the numerics or the user ended it, which says nothing of the part.
    pub lost: bool,
}

impl End {
    /// True if another run ended in the same stage for the same reason.
    pub fn is_like(&self, other: &Self) -> bool {
        (self.stages, self.kind) == (other.stages, other.kind)
    }
}

impl Outcome {
    /// Outcome of a solution, refined in a direction by a factor.
    pub fn of(solution: &Solution, refined: Option<(Direction, f64)>) -> Self {
        Self::with_findings(solution, refined, &after_one_of_many(&solution.case, &solution.stages))
    }

    /// Outcome with known [findings](after_one_of_many).
    pub fn with_findings(solution: &Solution, refined: Option<(Direction, f64)>, findings: &[Finding]) -> Self {
        let Solution { case, stages, .. } = solution;
        let load =
            largest_force(stages).map(|(i, _)| stages[i].steps.iter().map(|s| (s.travel, s.punch_force)).collect());
        let stop = stages.last().map(|stage| &stage.stop);
        let end = End {
            stages: stages.len(),
            kind: stop.map_or("full travel", |stop| stop.kind.name()),
            why: stop.map_or_else(String::new, ToString::to_string),
            complete: stages.len() == case.stages.len() && stop.is_none_or(Stop::is_complete),
            lost: stop.is_some_and(|stop| !stop.is_complete() && !stop.is_physical()),
        };
        let elements =
            stages.last().and_then(|stage| stage.frames.last()).into_iter().flat_map(|frame| &frame.elements);
        let first = case.model();
        let shortest = mesh::nodes(first).windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
        Self {
            direction: refined.map(|(direction, _)| direction),
            times: refined.map_or(1.0, |(_, times)| times),
            end,
            numbers: numbers(case, stages, findings),
            load: load.unwrap_or_default(),
            thickness: elements.map(|element| (element.s0, element.thickness)).collect(),
            used: forming_limit_used(stages).map_or_else(Vec::new, |used| used.shares),
            shortest: shortest / first.blank.thickness,
        }
    }

    /// Value of a number, at the place that the number is of.
    pub fn value(&self, number: &Number) -> Option<f64> {
        let own = self.numbers.iter().find(|own| own.is(number))?;
        let there = number.s0.filter(|_| !self.used.is_empty()).map(|place| interpolated(&self.used, place));
        Some(there.unwrap_or(own.quantity.amount.value))
    }

    /// True if it came to another end than the verified run, for a reason of the part's.
    pub(super) fn ends_otherwise(&self, base: &Self) -> bool {
        !self.end.lost && !self.end.is_like(&base.end)
    }

    /// Refinement in words.
    pub(super) fn refinement(&self) -> String {
        self.direction.map_or_else(String::new, |direction| direction.text(self.times))
    }
}

/// All numbers of a case's solved stages: answer, part, verdict.
fn numbers(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Vec<Number> {
    let answer = Answer::of(case, stages, findings).numbers;
    let known: Vec<&str> = answer.iter().map(|number| number.key).collect();
    let used = forming_limit_used(stages);
    let holder = case.model().tool(Role::Holder);
    let gives_force =
        holder.is_some_and(|holder| matches!(&holder.motion, Motion::Pressed(press) if press.stiffness == 0.0));
    let is_input = |key: &str| INPUTS.contains(&key) || key == HOLDER && gives_force;
    let judged = assess::judgements(findings).filter(|row| row.key != NUMERICAL).filter_map(|row| {
        let amount = row.quantity.as_ref()?.amount.to(Digits::Significant(3));
        let s0 = used.as_ref().filter(|_| row.key == LIMIT).map(|used| used.worst);
        Some(Number { s0, ..Number::new(Origin::Verdict, Quantity::new(row.key, row.label, amount)) })
    });
    let part = part(stages).into_iter().filter(|number| !known.contains(&number.quantity.key));
    let answer = answer.iter().filter(|number| !is_input(number.key));
    let answer = answer.map(|n| Number::new(Origin::Answer, Quantity::new(n.key, n.label, n.amount)));
    let all = answer.chain(part).chain(judged);
    all.filter(|number| number.quantity.amount.value.is_finite()).collect()
}

/// Travel of the largest force, force at half travel, travel of a run that ended early, the thinnest and thickest places, and
/// the angles that the part springs back to.
fn part(stages: &[StageSolution]) -> Vec<Number> {
    let number = |key, label, amount| Number::new(Origin::Part, Quantity::new(key, label, amount));
    let place =
        |key, label, place: f64, resolution: f64| Number { resolution, ..number(key, label, Amount::place(place)) };
    let mut numbers = Vec::new();
    let Some(stage) = stages.last() else { return numbers };
    if let Some((i, peak)) = largest_force(stages) {
        let (steps, model) = (&stages[i].steps, &stages[i].model);
        numbers.push(place("peak_travel", "Travel at the peak", peak.travel, step_length(steps, peak)));
        if let Some(force) = force_at(steps, 0.5 * model.travel) {
            let amount = Amount::force(force, model.extent().force_unit());
            numbers.push(number("half_travel_force", "Force at half travel", amount));
        }
    }
    if let Some(last) = stage.steps.last() {
        if !stage.stop.is_complete() && stage.model.travel > 0.0 {
            numbers.push(place("end_travel", "Travel at its end", last.travel, step_length(&stage.steps, last)));
        }
        let s0 = last.thinnest_s0;
        numbers.push(place("thinnest_place", "Thinnest at", s0, element_length(&stages[0], s0)));
    }
    if let Some((thickness, s0)) = stage.frames.last().and_then(thickest) {
        numbers.push(number("thickest", "Thickest", Amount::thickness(thickness)));
        numbers.push(place("thickest_place", "Thickest at", s0, element_length(&stages[0], s0)));
    }
    if let Some([before, after]) = stage.released() {
        let measured = changes(&Shape::of(before), &Shape::of(after)).into_iter();
        numbers.extend(measured.filter_map(|change| {
            let amount = Amount::new(change.after?, change.quantity.unit, Digits::Decimals(1));
            Some(number(change.quantity.key, change.quantity.label, amount))
        }));
    }
    numbers
}

/// Length of the step that ends with a record \[mm\].
fn step_length(steps: &[StepRecord], record: &StepRecord) -> f64 {
    let before = steps.iter().rev().find(|step| step.step < record.step);
    record.travel - before.map_or(0.0, |step| step.travel)
}

/// Length on the flat blank of the element at a place \[mm\].
fn element_length(first: &StageSolution, s0: f64) -> f64 {
    let nodes = mesh::nodes(&first.model);
    let after = nodes.partition_point(|node| *node < s0).clamp(1, nodes.len() - 1);
    nodes[after] - nodes[after - 1]
}

/// Punch force \[N, or N/mm\] at a travel \[mm\].
fn force_at(steps: &[StepRecord], travel: f64) -> Option<f64> {
    steps.last().filter(|last| travel > 0.0 && travel <= last.travel)?;
    let curve = [(0.0, 0.0)].into_iter().chain(steps.iter().map(|step| (step.travel, step.punch_force)));
    Some(interpolated(&curve.collect::<Vec<_>>(), travel))
}
