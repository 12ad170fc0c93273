//! Time step control, and the limit on the tries of a run.
//!
//! Iterations, contact changes, strain increment and closing gaps of a step decide the length of the next, in process time.

use super::{corrector::patience, end_search::EndSearch, *};

/// Iterations up to which the next step may grow, and above which it shrinks.
const EASY: usize = 8;
const HARD: usize = 15;
/// Factor on both for steps from rest: room for the fifteen iterations of the secant matrix.
const REST: usize = 3;
const GROWTH: f64 = 1.5;
const SHRINK: f64 = 0.7;
/// Changes of contact over the number of points above which steps do not grow \[–\].
const MANY_CHANGES: f64 = 0.2;
/// Strain increment over its limit above which a step is repeated \[–\].
pub const OVERSTRAINED: f64 = 2.0;
/// Shortest step that approaching contact asks for, over the largest \[–\].
const LEAST_APPROACH: f64 = 0.1;
/// Predicted penetration over the thickness that limits a step \[–\]: the largest move of one iteration.
const TOO_FAR: f64 = 0.5;

pub(super) struct StepControl<'a> {
    model: &'a Model,
    /// Wanted and given step \[s of process time\].
    wanted: f64,
    given: f64,
    largest: f64,
    smallest: f64,
    next_frame: usize,
    /// Time at which the tools close \[s\]; infinite if never.
    end: f64,
    pub search: EndSearch,
}

impl<'a> StepControl<'a> {
    pub fn new(model: &'a Model, state: &State, end: Option<f64>) -> Self {
        let settings = &model.settings;
        let steps = [settings.first_step, settings.max_step, settings.min_step];
        let [wanted, largest, smallest] = steps.map(|share| share * model.duration);
        let is_past = |frame: &f64| state.time > 0.0 && state.time >= frame * (1.0 - 1e-12);
        let (next_frame, end) = (model.frames.partition_point(is_past), end.unwrap_or(f64::INFINITY));
        Self { model, wanted, given: 0.0, largest, smallest, next_frame, end, search: EndSearch::new(smallest) }
    }

    /// Length of the next step \[s\]; `None` at the end of the run.
    pub fn next(&mut self, state: &State) -> Option<f64> {
        let target = self.model.frames.get(self.next_frame)?;
        let clock = target.min(self.end).min(self.model.next_change(state.time)) - state.time;
        // Equal steps up to the frame, so that none is tiny.
        let rest = self.model.process_time(state.time, clock);
        let steps = (rest / self.wanted - 1e-9).ceil().max(1.0);
        self.given = rest / steps;
        let dt = if steps > 1.0 { self.model.clock_time(state.time, self.given) } else { clock };
        let Some(to_end) = self.search.step(state.time).filter(|to_end| *to_end < dt) else { return Some(dt) };
        self.given = self.model.process_time(state.time, to_end);
        Some(to_end)
    }

    /// Chooses the next step after an accepted one; `before` is the evaluation of the step before.
    pub fn accept(&mut self, before: &Evaluation, converged: &Converged, record: &StepRecord) {
        let dt = self.given;
        let approach = approach(before, converged) * dt / converged.step.dt;
        let iterations = record.iterations / converged.outcome.rounds;
        let settings = &self.model.settings;
        let patience = patience(settings.iteration).max(if settings.predictor { 1 } else { REST });
        let many_changes = record.contact_changes as f64 > MANY_CHANGES * (STATIONS * self.model.blank.elements) as f64;
        if iterations > HARD * patience {
            self.wanted = (dt * SHRINK).max(self.smallest);
        } else if iterations <= EASY * patience && !many_changes {
            self.wanted = (self.wanted * GROWTH).min(self.largest);
        }
        if record.strain_increment > 0.0 {
            let aimed = dt * self.model.settings.strain_step / record.strain_increment;
            self.wanted = self.wanted.min(aimed.max(self.smallest));
        }
        self.wanted = self.wanted.min(approach.max(LEAST_APPROACH * self.largest));
    }

    pub fn reject(&mut self) -> bool {
        self.wanted = 0.5 * self.given;
        self.wanted >= self.smallest
    }

    pub fn at_frame(&mut self, state: &State) -> bool {
        let Some(target) = self.model.frames.get(self.next_frame) else { return false };
        let reached = state.time >= target * (1.0 - 1e-12);
        self.next_frame += usize::from(reached);
        reached
    }
}

/// Time until a free point, at the speed of this step, would penetrate a tool by [`TOO_FAR`] thicknesses \[s\].
fn approach(before: &Evaluation, converged: &Converged) -> f64 {
    let Converged { step, evaluation, .. } = converged;
    let mut soonest = f64::INFINITY;
    for (j, _) in step.context.acting_tools() {
        let pairs = before.contacts.row(j).iter().zip(evaluation.contacts.row(j)).enumerate();
        for (i, (before, now)) in pairs.filter(|(_, (_, now))| now.normal == 0.0) {
            let closing = (before.gap - now.gap) / step.dt;
            let room = now.gap + TOO_FAR * evaluation.thickness[i / STATIONS];
            soonest = if closing > 0.0 { soonest.min(room / closing) } else { soonest };
        }
    }
    soonest
}

/// Tries in which a run must come on by a hundredth, or its longest step: shipped cases take 7, one of 2600 random ones 41.
const IN_A_STRETCH: usize = 500;
/// Tries in all: so many times the steps that the settings ask for, and so many more.
const PLANNED: usize = 5;
const SPARE: usize = 5000;

pub(super) struct Budget {
    pub tries: usize,
    /// Progress at the start of the last stretch \[–\], and the tries before it.
    begun: (f64, usize),
    stretch: f64,
    in_a_stretch: usize,
    in_all: usize,
}

impl Budget {
    /// Budget by the longest step, the strain step, the frames and the changes of speed.
    pub fn new(model: &Model) -> Self {
        let settings = &model.settings;
        let finer = (Settings::default().strain_step / settings.strain_step).max(1.0);
        let landings = model.frames.len() + model.schedule.as_ref().map_or(0, |schedule| schedule.points().len());
        let in_a_stretch = (IN_A_STRETCH as f64 * finer) as usize + landings;
        let in_all = PLANNED * ((finer / settings.max_step) as usize + landings) + SPARE;
        Self { tries: 0, begun: (0.0, 0), stretch: settings.max_step.min(Settings::CUTOFF_STEP), in_a_stretch, in_all }
    }

    /// Counts a try at this progress \[–\]; `false` when the budget is spent.
    pub fn spend(&mut self, done: f64) -> bool {
        if done >= self.begun.0 + self.stretch {
            self.begun = (done, self.tries);
        }
        self.tries += 1;
        self.tries - self.begun.1 <= self.in_a_stretch && self.tries <= self.in_all
    }
}
