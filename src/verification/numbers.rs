//! Numbers of a solution that can have an error bar, and the bar from finer runs.

use super::{Direction, Estimate, Outcome};
use crate::assess::{self, Answer, Finding, forming_limit_used, largest_force};
use crate::case::Case;
use crate::measure::{Shape, changes, thickest};
use crate::model::{Motion, Role, mesh};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::units::{Amount, Digits, ErrorBar, Quantity, joined, rounded};
use serde::ser::{Serialize, SerializeMap, Serializer};

/// List that a number stands in; keys are unique there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// Numbers of the [`Answer`].
    Answer,
    /// Numbers of the part and the press.
    Part,
    /// Rows of the verdict.
    Verdict,
}

/// Number of a solution, of all its stages together.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// List that it stands in.
    pub origin: Origin,
    /// Value with its error bar.
    pub quantity: Quantity,
    /// Length of the element or step that a place or a travel is read off by, in the number's unit; 0 of others.
    pub resolution: f64,
    /// Place to look other runs' values up at, as initial distance from the axis \[mm\]: the worst place jumps.
    pub s0: Option<f64>,
    /// Contributions to the error bar, the largest first.
    pub contributions: Vec<Contribution>,
}

/// Contribution of one direction to an error bar.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution {
    /// Refined direction.
    pub direction: Direction,
    /// Error by it.
    pub estimate: Estimate,
    /// Share of the whole bar \[–\].
    pub share: f64,
}

/// Answer's numbers that are inputs, and one that is if the case gives the force.
const INPUTS: [&str; 2] = ["blank", "holder_gap"];
const HOLDER: &str = "holder_force";

/// Row of the verdict whose number is of one place of the sheet.
const LIMIT: &str = "forming_limit";

/// Row of the verdict that judges the numerics themselves.
const NUMERICAL: &str = "solution_quality";

/// Least error over the number, in tolerances to which every step was solved \[–\].
const SOLVED: f64 = 10.0;

/// A number jumps if the finer pair of levels differs by so many times what the coarser does \[–\], and by more than this
/// share of it; a place, if it moves by so many elements or steps.
const OUT_OF_LINE: f64 = 4.0;
const MUCH: f64 = 0.05;
const FAR: f64 = 4.0;

/// Contributions in text: the largest, each at least this share of the bar \[–\].
const MOST: usize = 3;
const SHARE: f64 = 0.05;

impl Origin {
    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Answer => "answer",
            Self::Part => "part",
            Self::Verdict => "verdict",
        }
    }
}

impl Number {
    pub(super) fn new(origin: Origin, quantity: Quantity) -> Self {
        Self { origin, quantity, resolution: 0.0, s0: None, contributions: Vec::new() }
    }

    fn part(key: &'static str, label: &'static str, amount: Amount) -> Self {
        Self::new(Origin::Part, Quantity::new(key, label, amount))
    }

    fn place(key: &'static str, label: &'static str, place: f64, resolution: f64) -> Self {
        Self { resolution, ..Self::part(key, label, Amount::place(place)) }
    }

    /// True of the same number of another run.
    pub fn is(&self, other: &Self) -> bool {
        (self.origin, self.quantity.key) == (other.origin, other.quantity.key)
    }

    /// Half its error bar, in its unit; 0 if no refinement moves it.
    pub fn half(&self) -> Option<f64> {
        if let ErrorBar::Half(half) = self.quantity.error { Some(half) } else { None }
    }

    pub(super) fn without_bar(&self, why: &str) -> Self {
        let quantity = self.quantity.clone().with_error(ErrorBar::Missing(why.to_owned()));
        Self { quantity, ..self.clone() }
    }

    /// Error bar from the runs of every direction, coarse to fine, solved to a tolerance.
    pub(super) fn with_bar(
        &self,
        directions: &[(Direction, Vec<&Outcome>)],
        tolerance: f64,
        estimate: impl Fn(Direction, &[f64]) -> Estimate,
    ) -> Self {
        let value = self.quantity.value();
        let mut contributions = Vec::new();
        for (direction, runs) in directions {
            let Some(finer) = runs.iter().map(|run| run.value(self)).collect::<Option<Vec<f64>>>() else {
                return self.without_bar(&format!("not found in every run ({})", direction.label()));
            };
            let levels = [vec![value], finer].concat();
            if let Some(i) = self.jump(&levels) {
                let [from, to] = [levels[i - 1], levels[i]].map(|level| self.quantity.amount.of(level));
                let finer = direction.text(runs[i - 1].times);
                return self.without_bar(&format!("jumps from {from} to {to} with {finer}"));
            }
            contributions.push(Contribution {
                direction: *direction,
                estimate: estimate(*direction, &levels),
                share: 0.0,
            });
        }
        let all: f64 = contributions.iter().map(|part| part.estimate.error).sum();
        if all > 0.0 {
            contributions.iter_mut().for_each(|part| part.share = part.estimate.error / all);
        }
        contributions.sort_by(|a, b| b.share.total_cmp(&a.share));
        let least = (SOLVED * tolerance * value.abs()).max(self.resolution);
        let half = if all > 0.0 { all.max(least) } else { 0.0 };
        let quantity = self.quantity.clone().with_error(ErrorBar::Half(half));
        Self { quantity, contributions, ..self.clone() }
    }

    /// Finer of the two levels between which the number jumps.
    fn jump(&self, levels: &[f64]) -> Option<usize> {
        let step = |i: usize| (levels[i] - levels[i - 1]).abs();
        if self.resolution > 0.0 {
            return (1..levels.len()).find(|&i| step(i) > FAR * self.resolution);
        }
        (2..levels.len()).find(|&i| step(i) > OUT_OF_LINE * step(i - 1) && step(i) > MUCH * levels[0].abs())
    }

    /// Contributions, such as `elements 62 % (2.1), steps 30 %` with an observed order if extrapolated; or why there is no bar.
    pub fn made_of(&self) -> String {
        match &self.quantity.error {
            ErrorBar::Missing(why) => return format!("no bar: {why}"),
            ErrorBar::Half(half) if *half > 0.0 => {}
            _ => return ErrorBar::UNMOVED.to_owned(),
        }
        let parts = self.contributions.iter().filter(|part| part.share >= SHARE).take(MOST).map(|part| {
            let (direction, share) = (part.direction.label(), Amount::share(part.share));
            match part.estimate.order.filter(|_| part.estimate.extrapolated) {
                Some(order) => format!("{direction} {share} ({})", Amount::norm(order)),
                None => format!("{direction} {share}"),
            }
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

/// All numbers of a case's solved stages: answer, press, part, verdict.
pub fn numbers(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Vec<Number> {
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
    let answer =
        answer.map(|number| Number::new(Origin::Answer, Quantity::new(number.key, number.label, number.amount)));
    let all = answer.chain(press(stages)).chain(part).chain(judged);
    all.filter(|number| number.quantity.value().is_finite()).collect()
}

/// Travel of the largest force, force at half travel, and travel of a run that ended early.
fn press(stages: &[StageSolution]) -> Vec<Number> {
    let mut numbers = Vec::new();
    if let Some((i, peak)) = largest_force(stages) {
        let stage = &stages[i];
        numbers.push(Number::place("peak_travel", "Travel at the peak", peak.travel, step_length(stage, peak)));
        if let Some(force) = force_at(&stage.steps, 0.5 * stage.model.travel) {
            let amount = Amount::force(force, stage.model.extent().force_unit());
            numbers.push(Number::part("half_travel_force", "Force at half travel", amount));
        }
    }
    let early = stages.last().filter(|stage| !stage.stop.is_complete() && stage.model.travel > 0.0);
    if let Some((stage, last)) = early.and_then(|stage| Some((stage, stage.steps.last()?))) {
        numbers.push(Number::place("end_travel", "Travel at its end", last.travel, step_length(stage, last)));
    }
    numbers
}

/// Thinnest and thickest places, and the angles that the part springs back to.
fn part(stages: &[StageSolution]) -> Vec<Number> {
    let mut numbers = Vec::new();
    let Some(stage) = stages.last() else { return numbers };
    if let Some(StepRecord { thinnest_s0: s0, .. }) = stage.steps.last() {
        numbers.push(Number::place("thinnest_place", "Thinnest at", *s0, element_length(stages, *s0)));
    }
    if let Some((thickness, s0)) = stage.frames.last().and_then(thickest) {
        numbers.push(Number::part("thickest", "Thickest", Amount::thickness(thickness)));
        numbers.push(Number::place("thickest_place", "Thickest at", s0, element_length(stages, s0)));
    }
    if let Some([before, after]) = stage.released() {
        let measured = changes(&Shape::of(before), &Shape::of(after)).into_iter();
        numbers.extend(measured.filter_map(|change| {
            let amount = Amount::new(change.after?, change.quantity.unit, Digits::Decimals(1));
            Some(Number::part(change.quantity.key, change.quantity.label, amount))
        }));
    }
    numbers
}

/// Length of the step that ends with a record \[mm\].
fn step_length(stage: &StageSolution, record: &StepRecord) -> f64 {
    let before = stage.steps.iter().rev().find(|step| step.step < record.step);
    record.travel - before.map_or(0.0, |step| step.travel)
}

/// Length on the flat blank of the element at a place \[mm\].
fn element_length(stages: &[StageSolution], s0: f64) -> f64 {
    let Some(first) = stages.first() else { return 0.0 };
    let nodes = mesh::nodes(&first.model);
    let after = nodes.partition_point(|node| *node < s0).clamp(1, nodes.len() - 1);
    nodes[after] - nodes[after - 1]
}

/// Punch force \[N, or N/mm\] at a travel \[mm\], between the steps around it.
fn force_at(steps: &[StepRecord], travel: f64) -> Option<f64> {
    let after = steps.partition_point(|step| step.travel < travel);
    let end = steps.get(after).filter(|_| travel > 0.0)?;
    let (x, force) = after.checked_sub(1).map_or((0.0, 0.0), |i| (steps[i].travel, steps[i].punch_force));
    Some(force + (end.punch_force - force) * (travel - x) / (end.travel - x))
}
