//! How long the next step is: what is known of the last one decides.
//!
//! | known | what it does |
//! |---|---|
//! | iterations | an easy step lets the next grow, a hard one shortens it |
//! | contact changes | no growth while many nodes come into contact or leave it |
//! | strain increment | the next step aims at the limit; one beyond twice the limit is repeated |
//! | gaps and closing speeds | no step carries a free node deep into a tool |
//! | frames, closing of the tools, changes of the punch's speed | steps land on them |
//!
//! Lengths of steps are nominal: what they would be at the punch's mean speed ([`Model::nominal`]).

use super::corrector::patience;
use crate::model::Model;
use crate::solution::StepRecord;
use crate::state::State;

/// A step that needed at most this many iterations was easy: the next may be longer.
const EASY: usize = 8;
/// A step that needed more than this many was hard: the next is shorter.
const HARD: usize = 15;
const GROWTH: f64 = 1.5;
const SHRINK: f64 = 0.7;
/// Changes of contact over the number of nodes above which steps do not grow \[–\].
const MANY_FLIPS: f64 = 0.2;
/// A step that strains the sheet by this many times the limit is repeated.
const OVERSTRAINED: f64 = 2.0;
/// Shortest step that the prediction of contact asks for, over the largest \[–\]: further down the corrector copes.
const LEAST_APPROACH: f64 = 0.1;

/// Chooses steps between the first, smallest and largest of the settings, and lands on every frame.
pub(super) struct StepControl<'a> {
    model: &'a Model,
    /// Wanted step, and the one that was given out \[s, nominal\].
    wanted: f64,
    given: f64,
    largest: f64,
    smallest: f64,
    next_frame: usize,
    /// Time at which the run ends before its last frame \[s\].
    end: f64,
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
        }
    }

    /// Length of the next step \[s\]; `None` at the end of the run.
    pub fn next(&mut self, state: &State) -> Option<f64> {
        let target = self.model.frames.get(self.next_frame)?;
        let real = target.min(self.end).min(self.model.next_change(state.time)) - state.time;
        // Equal steps up to the frame, so that none is tiny.
        let rest = self.model.nominal(state.time, real);
        let steps = (rest / self.wanted - 1e-9).ceil().max(1.0);
        self.given = rest / steps;
        Some(if steps > 1.0 { self.model.real(state.time, self.given) } else { real })
    }

    /// After an accepted step; `approach` is the time in which a free node would go too deep into a tool \[s\].
    pub fn accept(&mut self, dt: f64, iterations: usize, record: &StepRecord, approach: f64) {
        let approach = approach * self.given / dt;
        let dt = self.given;
        let patience = patience(self.model.settings.iteration);
        let many_flips = record.flips as f64 > MANY_FLIPS * self.model.blank.elements as f64;
        if iterations > HARD * patience {
            self.wanted = (dt * SHRINK).max(self.smallest);
        } else if iterations <= EASY * patience && !many_flips {
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
