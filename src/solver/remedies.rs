//! Remedies of a run without equilibrium: other settings from a course behind the place, until the run is past it.

use super::{closing::Unseen, course::Course, no_equilibrium::reached, *};
use crate::units::joined;

/// Progress beyond the place after which the own settings come back \[–\], the usual largest step; twice as far each time.
const BEYOND: f64 = 0.01;
/// Tries that the remedies of one stage may take before the last of them is begun.
const MOST_TRIES: usize = 1000;
/// Share of the settings' own largest and first step \[–\].
const SHORTER: f64 = 0.1;
/// Sliding speed of full friction over the punch speed \[–\].
const SMOOTHER: f64 = 1.0;

named! {
    /// Change of one setting, in the fixed order in which they are tried, those that move the answer least first.
    pub enum Remedy;
    /// Key of the setting in a case file.
    fn key;
    MaxStep: "solver.max_step", "Largest step a tenth as long.";
    FirstStep: "solver.first_step", "First step a tenth as long.";
    SlipSpeed: "solver.slip_speed", "Friction that sets in up to the punch speed.";
    ResidualNorm: "solver.norm", "Steps accepted by the residual.";
}

impl Remedy {
    /// Settings with the change; `None` where they have it.
    pub fn applied(self, settings: &Settings) -> Option<Settings> {
        let mut changed = settings.clone();
        match self {
            Self::MaxStep => changed.max_step = (SHORTER * settings.max_step).max(settings.min_step),
            Self::FirstStep => changed.first_step = (SHORTER * settings.first_step).max(settings.min_step),
            Self::SlipSpeed => changed.slip_speed = settings.slip_speed.max(SMOOTHER),
            Self::ResidualNorm => changed.norm = Norm::Residual,
        }
        (changed != *settings).then_some(changed)
    }

    /// Changed key and value, as in a case file; `None` where the settings have it.
    pub fn setting(self, settings: &Settings) -> Option<String> {
        let changed = self.applied(settings)?;
        let number = match self {
            Self::MaxStep => changed.max_step,
            Self::FirstStep => changed.first_step,
            Self::SlipSpeed => changed.slip_speed,
            Self::ResidualNorm => return Some(format!("{} = \"residual\"", self.key())),
        };
        Some(format!("{} = {number}", self.key()))
    }
}

/// Solves a model from a given state; the first of [`Remedy::ALL`] that can takes it past a place without equilibrium.
pub fn run_from(model: &Model, state: State, observer: &mut dyn Observer) -> StageSolution {
    let (mut course, mut tries) = (Course::new(model, state), 0);
    observer.state(model, &course.now.state);
    course.go_on(model, f64::INFINITY, observer);
    while course.is_lost && tries < MOST_TRIES {
        match mended(model, &course, &mut tries, observer) {
            Some(mended) => course = mended,
            None if course.solution.stop.kind == StopKind::ToolsClosed => break,
            None => {
                let tried = Remedy::ALL.iter().filter_map(|remedy| remedy.setting(&model.settings));
                let from = reached(&course.behind[0].state);
                let text = format!("tried from {from} on without success: {}", joined(tried, ", "));
                course.solution.stop.text = joined([course.solution.stop.text, text], "; ");
                break;
            }
        }
        if !course.has_ended {
            course.go_on(model, f64::INFINITY, observer);
        }
    }
    course.finished()
}

/// Course of the first remedy, that of the last stretch before all, that takes a lost one past its end; adds up its tries.
/// The observer sees the stretch once it is known to come through: it is solved again.
fn mended(model: &Model, lost: &Course, tries: &mut usize, observer: &mut dyn Observer) -> Option<Course> {
    let before = &lost.solution.remedied;
    let past = model.progress(lost.now.state.time) + BEYOND * (1 << before.len()) as f64;
    let last = before.last().map(|(by, _)| *by);
    for by in last.into_iter().chain(Remedy::ALL.into_iter().filter(|remedy| Some(*remedy) != last)) {
        let Some(settings) = by.applied(&model.settings) else { continue };
        let (mut course, other) = (lost.back(), Model { settings, ..model.clone() });
        *tries += course.go_on(&other, past, &mut Unseen(observer));
        if course.solution.stop.kind == StopKind::Interrupted {
            let mut lost = lost.clone();
            lost.ends(course.solution.stop);
            return Some(lost);
        }
        if !course.is_lost {
            let behind = &lost.behind[0];
            observer.restart(model, &behind.state, behind.last.step);
            course = lost.back();
            course.go_on(&other, past, observer);
            course.solution.remedied.push((by, [behind.state.travel, course.now.state.travel]));
            return Some(course);
        }
    }
    None
}
