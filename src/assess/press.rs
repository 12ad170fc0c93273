//! What the press must give, against its rating where the case names it.

use super::run::{Run, at_event};
use super::{Finding, Light};
use crate::model::{Motion, Role};
use crate::solver::solution::{StageSolution, StepRecord};
use crate::table::{JOULES, Unit};
use crate::units::{Amount, Digits, joined};

/// Share of a rating from which on little of it is left \[–\]: a declared rule of thumb.
const NEAR: f64 = 0.8;
/// What a press is chosen for, over its largest load \[–\]: a declared rule of thumb.
pub(super) const RESERVE: f64 = 1.2;

/// Where a press is loaded most: the ram bears the punch's force, and with it the cushion's that presses the holder.
pub(super) struct Load<'a> {
    stage: usize,
    on: &'a StageSolution,
    step: &'a StepRecord,
}

impl<'a> Load<'a> {
    /// Over all stages; `None` where no punch presses.
    pub fn largest(stages: &'a [StageSolution]) -> Option<Self> {
        let formed = stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
        let pressed = |step: &&StepRecord| step.punch_force > 0.0;
        let loads =
            formed.flat_map(|(stage, on)| on.steps.iter().filter(pressed).map(move |step| Self { stage, on, step }));
        loads.max_by(|a, b| a.force().total_cmp(&b.force()))
    }

    /// Of a holder that is pressed, what its distance blocks bear included \[N, or N/mm\]; one that stands is bolted to the
    /// die.
    pub fn holder(&self) -> f64 {
        match self.on.model.tool(Role::Holder).map(|holder| &holder.motion) {
            Some(Motion::Pressed(_)) => self.step.holder_force + self.step.block_force,
            _ => 0.0,
        }
    }

    /// Of punch and holder at the same instant \[N, or N/mm\].
    pub fn force(&self) -> f64 {
        self.step.punch_force + self.holder()
    }

    /// What a press for it should be rated at least, told rounded up.
    pub fn rating(&self) -> Amount {
        Amount::force(RESERVE * self.force(), self.on.model.extent().force_unit()).to(Digits::Upward(2))
    }
}

/// Largest force of punch and holder together and its travel, over all stages.
pub(super) fn force(run: &Run) -> Option<Finding> {
    let load = Load::largest(run.stages)?;
    let unit = load.on.model.extent().force_unit();
    Some(rated(
        "press_force",
        "Press force",
        (load.force(), unit),
        run.case.press.force,
        |force| match unit {
            Unit::N => Amount::force(force, unit).into(),
            _ => format!("{force} of depth", force = Amount::force(force, unit)),
        },
        |force| {
            let found = format!("{force} at {travel} of travel", travel = Amount::place(load.step.travel));
            let found = joined([found, at_event(load.on, load.step)], " ");
            let parts = format!(
                "punch {punch}, holder {holder}",
                punch = Amount::force(load.step.punch_force, unit),
                holder = Amount::force(load.holder(), unit)
            );
            let parts = if load.holder() > 0.0 { parts } else { String::new() };
            run.of_stage(joined([found, parts], ": "), load.stage)
        },
    ))
}

/// External work of the stroke that needs most of it.
pub(super) fn energy(run: &Run) -> Option<Finding> {
    let unit = run.stages.first()?.model.extent().energy_unit();
    let strokes = run.stages.iter().enumerate().filter(|(_, stage)| stage.model.release.is_none());
    let work = strokes.filter_map(|(i, stage)| Some((i, JOULES * stage.steps.last()?.work.external)));
    let (i, work) = work.max_by(|a, b| a.1.total_cmp(&b.1))?;
    let told = |work: f64| match unit {
        Unit::Joule => Amount::energy(work, unit).into(),
        _ => format!("{work} of depth", work = Amount::energy(work, unit)),
    };
    let rating = run.case.press.energy.map(|energy| JOULES * energy);
    Some(rated("energy", "Energy", (work, unit), rating, told, |work| run.of_stage(work, i)))
}

/// A figure of the run, as it is `told` and where it was `found`, against the press's rating.
fn rated(
    key: &'static str,
    label: &'static str,
    (value, unit): (f64, Unit),
    rating: Option<f64>,
    told: impl Fn(f64) -> String,
    found: impl Fn(String) -> String,
) -> Finding {
    let light = rating.map_or(Light::Grey, |rating| Light::of(value, [NEAR * rating, rating]));
    let advice = match rating {
        Some(_) => "a stronger press; less friction or holder force, a smaller blank, a thinner sheet",
        None if matches!(unit, Unit::NPerMm | Unit::JoulePerMm) => {
            "give blank.depth, and [press] force and energy: the ratings on its data sheet"
        }
        None => "give [press] force and energy: the ratings on its data sheet",
    };
    let judged = Finding::judged(key, label, light, found(told(value)));
    let judged = match rating {
        Some(rating) => judged.against(value, unit, told(rating)).at_most(NEAR * rating, rating),
        None => judged.against(value, unit, "the press's rating, not in the case"),
    };
    judged.source("the press's data sheet").advice(advice)
}
