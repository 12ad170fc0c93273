//! Press: force and energy against its ratings.

use super::{Finding, Light, Run, at_event, formed};
use crate::model::{Motion, Role};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::{JOULES, Unit};
use crate::units::{Amount, Digits, joined};

/// Share of a rating from which on little of it is left \[–\]: a declared rule of thumb.
const NEAR: f64 = 0.8;
/// Rating over the largest load \[–\]: a declared rule of thumb.
pub(super) const RESERVE: f64 = 1.2;

/// Largest load of a press: its ram bears the punch, and with it the cushion that presses the holder.
pub(super) struct Load<'a> {
    stage: usize,
    on: &'a StageSolution,
    step: &'a StepRecord,
}

impl<'a> Load<'a> {
    /// Largest over all stages; `None` if no punch presses.
    pub fn largest(stages: &'a [StageSolution]) -> Option<Self> {
        let steps = formed(stages).flat_map(|(stage, on)| on.steps.iter().map(move |step| Self { stage, on, step }));
        steps.filter(|load| load.step.punch_force > 0.0).max_by(|a, b| a.force().total_cmp(&b.force()))
    }

    /// Force of a holder that is pressed, with what its distance blocks bear \[N, or N/mm\].
    pub fn holder(&self) -> f64 {
        match self.on.model.tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(_)) => self.step.holder_force + self.step.block_force,
            _ => 0.0,
        }
    }

    /// Force of punch and holder at the same instant \[N, or N/mm\].
    pub fn force(&self) -> f64 {
        self.step.punch_force + self.holder()
    }

    /// Least rating of a press for it, rounded up.
    pub fn rating(&self) -> Amount {
        let least = RESERVE * self.force();
        let second_digit = 10f64.powi(least.log10().floor() as i32 - 1);
        let rating = (least / second_digit - 1e-9).ceil() * second_digit;
        Amount::force(rating, self.on.model.extent().force_unit()).to(Digits::Given(3))
    }
}

pub(super) fn force(run: &Run) -> Option<Finding> {
    let load = Load::largest(run.stages)?;
    let unit = load.on.model.extent().force_unit();
    let at = format!("{{}}{} at {} of travel", per_depth(unit), Amount::place(load.step.travel));
    let at = joined([at, at_event(load.on, load.step)], " ");
    let parts = match load.holder() {
        0.0 => String::new(),
        holder => {
            format!("punch {}, holder {}", Amount::force(load.step.punch_force, unit), Amount::force(holder, unit))
        }
    };
    let text = run.of_stage(joined([at, parts], ": "), load.stage);
    Some(rated("press_force", "Press force", text, Amount::force(load.force(), unit), run.case.press.force))
}

pub(super) fn energy(run: &Run) -> Option<Finding> {
    let unit = run.stages.first()?.model.extent().energy_unit();
    let work = |step: &StepRecord| (JOULES * step.work.external, ());
    let forms = |stage: &StageSolution| stage.model.release.is_none();
    let (i, work, ()) = run.peak(|_, stage| stage.steps.last().filter(|_| forms(stage)).map(work))?;
    let text = run.of_stage(format!("{{}}{}", per_depth(unit)), i);
    let rating = run.case.press.energy.map(|energy| JOULES * energy);
    Some(rated("energy", "Energy", text, Amount::force(work, unit), rating))
}

fn per_depth(unit: Unit) -> &'static str {
    if matches!(unit, Unit::N | Unit::Joule) { "" } else { " of depth" }
}

fn rated(key: &'static str, label: &'static str, text: String, load: Amount, rating: Option<f64>) -> Finding {
    let judged = Finding::judged(key, label, text).number(load).source("the press's data sheet");
    let Some(rating) = rating else {
        let depth = if per_depth(load.unit).is_empty() { "" } else { "blank.depth, and " };
        let advice = format!("give {depth}[press] force and energy: the ratings on its data sheet");
        return judged.light(Light::Grey).limit("the press's rating, not in the case").advice(advice);
    };
    let judged = judged.at_most(format!("{}{}", load.with_value(rating), per_depth(load.unit)), NEAR * rating, rating);
    judged.advice("a stronger press; less friction or holder force, a smaller blank, a thinner sheet")
}
