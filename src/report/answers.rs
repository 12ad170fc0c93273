//! The numbers that a designer asks for first: what the sheet, the press and the part come to.

use super::document::KeyNumber;
use crate::case::Solution;
use crate::measure::part_height;
use crate::message::{Amount, Form, Message, message};
use crate::model::Role;
use crate::solution::{StageSolution, StepRecord};

/// Five numbers of a solved case, in the order of telling.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Answers {
    /// Each with its label, and with where, when or of what; `None` where there is none.
    pub numbers: Vec<(&'static str, Option<Amount>, Message)>,
    /// The stage with the largest punch force, counted from 0.
    pub heaviest: Option<usize>,
}

impl Answers {
    /// Of all stages together; of a sheet that did not take a step only what was given.
    pub fn of(solution: &Solution) -> Self {
        let stages = &solution.stages;
        let thickness = solution.case.model().blank.thickness;
        let working = || stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
        let steps = || working().flat_map(|(i, stage)| stage.steps.iter().map(move |step| (i, stage, step)));
        let last = stages.iter().rev().find_map(|stage| Some((stage, stage.steps.last()?)));
        let peak = steps().max_by(|a, b| a.2.punch_force.total_cmp(&b.2.punch_force));
        let held = steps().max_by(|a, b| a.2.holder_force.total_cmp(&b.2.holder_force));
        let pressed = steps().max_by(|a, b| a.2.pressure.abs().total_cmp(&b.2.pressure.abs()));

        let mut numbers = Vec::new();
        let thinnest = last.map(|(_, step)| (Amount::thickness(step.thinnest), thin(step, thickness)));
        numbers.push(of("Thinnest place", thinnest));
        numbers.push(match peak {
            Some((_, _, step)) if step.punch_force <= 0.0 && pressed.is_some_and(|p| p.2.pressure != 0.0) => {
                of("Largest gas pressure", pressed.map(|p| (Amount::stress(p.2.pressure.abs()), Message::default())))
            }
            peak => of("Peak punch force", peak.map(|(_, stage, step)| force(stage, step.punch_force, step))),
        });
        let holder = held.filter(|(_, stage, _)| stage.model.tool(Role::Holder).is_some());
        numbers.push(of("Largest holder force", holder.map(|(_, stage, step)| force(stage, step.holder_force, step))));
        let height = last.and_then(|(stage, _)| part_height(stage.frames.last()?));
        numbers.push(of("Part height", height.map(|height| (Amount::place(height), "over all".into()))));
        numbers.push(of("Draw-in of the edge", last.map(|(_, step)| (Amount::place(step.draw_in), "inward".into()))));
        Self { numbers, heaviest: peak.map(|(i, ..)| i) }
    }
}

/// The numbers as they are told in a form.
pub(super) fn told(answers: &Answers, form: Form) -> Vec<KeyNumber> {
    let number = |(label, amount, detail): &(&'static str, Option<Amount>, Message)| KeyNumber {
        label: Message::from(*label).told(form),
        value: amount.map_or_else(|| Message::from("none").told(form), |amount| amount.told(form)),
        detail: detail.told(form),
    };
    answers.numbers.iter().map(number).collect()
}

fn of(label: &'static str, found: Option<(Amount, Message)>) -> (&'static str, Option<Amount>, Message) {
    match found {
        Some((amount, detail)) => (label, Some(amount), detail),
        None => (label, None, Message::default()),
    }
}

/// How much thinner, and where.
fn thin(step: &StepRecord, initial: f64) -> Message {
    let share = Amount::share(1.0 - step.thinnest / initial);
    message!("{share} thinner, at s0 = {place}", share = share, place = Amount::place(step.thinnest_s0))
}

/// A force of a step, and when.
fn force(stage: &StageSolution, force: f64, step: &StepRecord) -> (Amount, Message) {
    let at = if stage.model.travel > 0.0 {
        message!("at {travel} of travel", travel = Amount::place(step.travel))
    } else {
        message!("after {time}", time = Amount::time(step.time))
    };
    (Amount::force(force, stage.model.extent().force_unit()), at)
}
