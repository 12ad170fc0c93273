//! How long the next step is: what is known of the last one decides.
//!
//! | known | what it does |
//! |---|---|
//! | iterations | an easy step lets the next grow, a hard one shortens it |
//! | contact changes | no growth while many nodes come into contact or leave it |
//! | strain increment | the next step aims at the limit; one beyond twice the limit is repeated |
//! | gaps and closing speeds | no step carries a free node deep into a tool |
//! | frames, closing of the tools, changes of the punch's speed | steps land on them |
//! | a step that oversteps the end of the run | it is repeated up to where the end is expected |
//!
//! Lengths of steps are measured in process time: what they would take at the punch's mean speed
//! ([`Model::process_time`]).

use super::converged::Converged;
use super::corrector::patience;
use super::end_search::EndSearch;
use super::evaluation::Evaluation;
use super::step::Step;
use crate::element::surface::STATIONS;
use crate::model::Model;
use crate::solver::solution::StepRecord;
use crate::solver::state::State;

/// A step that needed at most this many iterations was easy: the next may be longer.
const EASY: usize = 8;
/// A step that needed more than this many was hard: the next is shorter.
const HARD: usize = 15;
const GROWTH: f64 = 1.5;
const SHRINK: f64 = 0.7;
/// Changes of contact over the number of nodes above which steps do not grow \[–\].
const MANY_CHANGES: f64 = 0.2;
/// A step that strains the sheet by this many times the limit is repeated.
const OVERSTRAINED: f64 = 2.0;
/// Shortest step that the prediction of contact asks for, over the largest \[–\]: further down the corrector copes.
const LEAST_APPROACH: f64 = 0.1;
/// Predicted penetration over the thickness that a step is kept from \[–\]: what one iteration may move a node by.
const TOO_FAR: f64 = 0.5;

/// Chooses steps between the first, smallest and largest of the settings, and lands on every frame.
pub(super) struct StepControl<'a> {
    model: &'a Model,
    /// Wanted step, and the one that was given out \[s of process time\].
    wanted: f64,
    given: f64,
    largest: f64,
    smallest: f64,
    next_frame: usize,
    /// Time at which the run ends before its last frame \[s\].
    end: f64,
    search: EndSearch,
}

impl<'a> StepControl<'a> {
    /// `end` is the time at which the tools close \[s\], where they do.
    pub fn new(model: &'a Model, end: Option<f64>) -> Self {
        let settings = &model.settings;
        Self {
            model,
            wanted: settings.first_step * model.duration,
            given: 0.0,
            largest: settings.max_step * model.duration,
            smallest: settings.min_step * model.duration,
            next_frame: 0,
            end: end.unwrap_or(f64::INFINITY),
            search: EndSearch::new(settings.min_step * model.duration),
        }
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
        Some(match self.search.step(state.time) {
            Some(to_end) if to_end < dt => {
                self.given = self.model.process_time(state.time, to_end);
                to_end
            }
            _ => dt,
        })
    }

    /// Whether a step goes too far beyond the end of the run, by the excess over it, and is to be repeated shorter.
    pub fn oversteps(&mut self, step: &Step, excess: f64) -> bool {
        self.search.look(step.state.time, step.dt, excess)
    }

    /// After an accepted step; `before` is the evaluation of the one before.
    pub fn accept(&mut self, before: &Evaluation, converged: &Converged, record: &StepRecord) {
        let approach = approach(before, converged) * self.given / converged.step.dt;
        let dt = self.given;
        let iterations = record.iterations / converged.outcome.rounds;
        let patience = patience(self.model.settings.iteration);
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

    /// Whether a step in equilibrium strained the sheet too much.
    pub fn is_overstrained(&self, increment: f64) -> bool {
        increment > OVERSTRAINED * self.model.settings.strain_step
    }

    /// After a rejected step; `false` when there is none shorter to try.
    pub fn reject(&mut self) -> bool {
        self.wanted = 0.5 * self.given;
        self.wanted >= self.smallest
    }

    /// Whether the state is at a time to keep; moves on to the next one.
    pub fn at_frame(&mut self, state: &State) -> bool {
        let Some(target) = self.model.frames.get(self.next_frame) else { return false };
        let reached = state.time >= target * (1.0 - 1e-12);
        self.next_frame += usize::from(reached);
        reached
    }
}

/// Time after which, at the speed of this step, a free point would stand [`TOO_FAR`] thicknesses inside a tool \[s\].
fn approach(before: &Evaluation, converged: &Converged) -> f64 {
    let Converged { step, evaluation, .. } = converged;
    let mut soonest = f64::INFINITY;
    for (j, _) in step.process.tools.iter().enumerate().filter(|(_, tool)| !tool.is_absent()) {
        let pairs = before.contacts.row(j).iter().zip(evaluation.contacts.row(j)).enumerate();
        for (i, (before, now)) in pairs.filter(|(_, (_, now))| now.normal == 0.0) {
            let closing = (before.gap - now.gap) / step.dt;
            let thickness = evaluation.thickness_at(i);
            let room = now.gap + TOO_FAR * thickness;
            soonest = if closing > 0.0 { soonest.min(room / closing) } else { soonest };
        }
    }
    soonest
}
