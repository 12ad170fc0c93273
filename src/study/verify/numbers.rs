//! Numbers of a solution that can have an error bar, with the curves and the end of its run.

use super::Direction;
use crate::assess::error_bars::{Number, Origin};
use crate::assess::{self, Answer, Finding, after, forming_limit_used, largest_force};
use crate::case::{Case, Solution};
use crate::measure::{Shape, changes, thickest};
use crate::model::{Motion, Role};
use crate::numerics::interpolated;
use crate::solver::solution::{StageSolution, Stop};
use crate::units::{Amount, Digits, Quantity};

const OF_A_NECK: [&str; 4] = ["thinnest", "thinning", "forming_limit", "hardening_range"];

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
    /// Used share of the forming limit \[%\] over the initial distance from the axis \[mm\]; empty without a limit.
    pub used: Vec<(f64, f64)>,
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
        let (direction, times) = refined.map_or((None, 1.0), |(direction, times)| (Some(direction), times));
        Self { direction, times, ..Self::with_findings(solution, &after(&solution.case, &solution.stages)) }
    }

    /// Outcome of a run with known [findings](after).
    pub fn with_findings(solution: &Solution, findings: &[Finding]) -> Self {
        let Solution { case, stages, .. } = solution;
        let stop = stages.last().map(|stage| &stage.stop);
        let (kind, why) = stop.map_or(("full travel", String::new()), |stop| (stop.kind.name(), stop.to_string()));
        let complete = stages.len() == case.stages.len() && stop.is_none_or(Stop::is_complete);
        let lost = stop.is_some_and(|stop| !stop.is_complete() && !stop.is_physical());
        let end = End { stages: stages.len(), kind, why, complete, lost };
        let load = largest_force(stages).map_or(&[][..], |(i, ..)| &stages[i].steps);
        let load = load.iter().map(|step| (step.travel, step.punch_force)).collect();
        let frame = stages.last().and_then(|stage| stage.frames.last());
        let elements = frame.into_iter().flat_map(|frame| &frame.elements);
        let thickness = elements.map(|element| (element.s0, element.thickness)).collect();
        let used = forming_limit_used(stages).map_or_else(Vec::new, |used| used.shares);
        Self { direction: None, times: 1.0, end, numbers: numbers(case, stages, findings), load, thickness, used }
    }

    /// Value of a number, at the place that the number is of.
    pub fn value(&self, number: &Number) -> Option<f64> {
        let own = self.numbers.iter().find(|own| own.is(number))?;
        let there = number.s0.filter(|_| !self.used.is_empty()).map(|place| interpolated(&self.used, place));
        Some(there.unwrap_or(own.quantity.amount.value))
    }

    pub(super) fn refinement(&self) -> String {
        self.direction.map_or_else(String::new, |direction| direction.text(self.times))
    }
}

fn numbers(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Vec<Number> {
    let answer = Answer::of(case, stages, findings).numbers;
    let motion = |role: Role| case.model().tool(role).map(|tool| &tool.motion);
    let gives_force = |role| matches!(motion(role), Some(Motion::Pressed(press)) if press.stiffness == 0.0);
    let is_input = |key: &str| match key {
        "holder_force" => gives_force(Role::Holder),
        "pad_force" => gives_force(Role::Pad),
        _ => matches!(key, "blank" | "holder_gap"),
    };
    let part = part(stages).into_iter().filter(|own| !answer.iter().any(|known| known.key == own.quantity.key));
    let used = forming_limit_used(stages);
    let judged = assess::judgements(findings).filter(|row| row.key != "solution_quality").filter_map(|row| {
        let amount = row.quantity.as_ref()?.amount.to(Digits::Significant(3));
        let s0 = used.as_ref().filter(|_| row.key == "forming_limit").map(|used| used.worst);
        let quantity = Quantity { limits: row.limits(), ..Quantity::new(row.key, row.label, amount) };
        Some(Number { s0, ..Number::new(Origin::Verdict, quantity) })
    });
    let answer = answer.iter().filter(|number| !is_input(number.key));
    let own = |n: &Quantity| Quantity { name: n.name.clone(), ..Quantity::new(n.key, n.label, n.amount) };
    let answer = answer.map(|n| Number::new(Origin::Answer, own(n)));
    let is_torn = stages.iter().any(|stage| stage.neck.is_some());
    let all = answer.chain(part).chain(judged).filter(|number| number.quantity.amount.value.is_finite());
    let is_lost = |number: &Number| is_torn && OF_A_NECK.contains(&number.quantity.key);
    all.map(|n| if is_lost(&n) { n.without_bar("in a neck it depends on the mesh") } else { n }).collect()
}

fn part(stages: &[StageSolution]) -> Vec<Number> {
    let number = |key, label, amount| Number::new(Origin::Part, Quantity::new(key, label, amount));
    let place = |key, label, place: f64| {
        number(key, label, Amount::place(place)).without_bar("a place is read off an element or a step")
    };
    let mut numbers = Vec::new();
    let Some(stage) = stages.last() else { return numbers };
    if let Some((i, peak, _)) = largest_force(stages) {
        let (steps, model) = (&stages[i].steps, &stages[i].model);
        numbers.push(place("peak_travel", "Travel at the peak", peak.travel));
        let half = 0.5 * model.travel;
        if steps.last().is_some_and(|last| 0.0 < half && half <= last.travel) {
            let curve = [(0.0, 0.0)].into_iter().chain(steps.iter().map(|step| (step.travel, step.punch_force)));
            let force = interpolated(&curve.collect::<Vec<_>>(), half);
            let amount = Amount::force(force, model.extent().force_unit());
            numbers.push(number("half_travel_force", "Force at half travel", amount));
        }
    }
    if let Some(last) = stage.steps.last() {
        if !stage.stop.is_complete() && stage.model.travel > 0.0 {
            numbers.push(place("end_travel", "Travel at its end", last.travel));
        }
        numbers.push(place("thinnest_place", "Thinnest at (blank)", last.thinnest_s0));
    }
    if let Some((thickness, s0)) = stage.frames.last().and_then(thickest) {
        numbers.push(number("thickest", "Thickest", Amount::thickness(thickness)));
        numbers.push(place("thickest_place", "Thickest at (blank)", s0));
    }
    if let Some([before, after]) = stage.released() {
        numbers.extend(changes(&Shape::of(before), &Shape::of(after)).into_iter().filter_map(|change| {
            let amount = Amount::new(change.after?, change.quantity.unit, Digits::Decimals(1));
            Some(number(change.quantity.key, change.quantity.label, amount))
        }));
    }
    numbers
}
