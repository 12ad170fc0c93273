//! Callbacks of a run, and the view of an evaluation that they get.

use super::corrector::{Outcome, Pass};
use super::evaluation::Evaluation;
use super::step::{CUT_OFF_ZONE, Step};
use super::trial::Trial;
use crate::element::Node;
use crate::geometry::turned;
use crate::model::{Mode, Model, Stage};
use crate::solver::solution::{IterationRecord, StepRecord};
use crate::solver::state::State;

/// Receives the progress of a run and may end it; the solver itself never prints.
pub trait Observer {
    /// Called after every accepted step.
    fn step(&mut self, _record: &StepRecord) {}
    /// Called at the start and after every accepted step.
    fn state(&mut self, _model: &Model, _state: &State) {}
    /// Called after every evaluation of the corrector.
    fn iteration(&mut self, _iterate: &Iterate<'_>) {}
    /// Called when the run goes back to an earlier state to take other settings: all after its `step` steps is void.
    fn restart(&mut self, _model: &Model, _state: &State, _step: usize) {}
    /// Called from time to time with the latest state before which the run can no longer go back.
    fn settled(&mut self, _state: &State) {}
    /// Called before each stage of a sequence.
    fn stage(&mut self, _stage: &Stage) {}
    /// Returns `true` to end the run with [`StopKind::Interrupted`](crate::solver::solution::StopKind::Interrupted) and all results so far; asked before
    /// every step and every iteration.
    fn wants_to_stop(&mut self) -> bool {
        false
    }
}

/// No-op observer.
impl Observer for () {}

/// Sheet and forces of one evaluation of the corrector.
pub struct Iterate<'a> {
    pub(super) step: &'a Step<'a>,
    pub(super) pass: Pass,
    pub(super) trial: &'a Trial,
    pub(super) evaluation: &'a Evaluation,
    pub(super) outcome: &'a Outcome,
}

/// Owned copy of an [`Iterate`].
#[derive(Clone, Debug, Default, PartialEq, serde::Serialize)]
pub struct IterateSnapshot {
    /// Nodes from the axis outward \[mm, rad\].
    pub nodes: Vec<Node>,
    /// Forces out of balance at the nodes along r and z, and moments; 0 at held freedoms \[N, N mm, or per mm of depth\].
    pub imbalance: Vec<[f64; 3]>,
    /// Largest strain increment of each element \[–\] and the yield stress there \[MPa\].
    pub increments: Vec<[f64; 2]>,
    /// Flags of the elements that strain by less than ten cut-offs, where the stress is not the metal's.
    pub cut_off: Vec<bool>,
    /// Contact points under pressure, tool by tool.
    pub contacts: Vec<IterateContact>,
}

/// Contact point under the pressure of a tool.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct IterateContact {
    /// Position on the mid-surface, r and z \[mm\].
    pub position: [f64; 2],
    /// Force of the tool on the sheet with friction, along r and z \[N, or N/mm\].
    pub force: [f64; 2],
    /// True below the regularisation speed of friction.
    pub sticks: bool,
}

impl Iterate<'_> {
    /// Norms and counts of the evaluation.
    pub fn record(&self) -> IterationRecord {
        let Self { step, pass, trial, evaluation, outcome } = self;
        IterationRecord {
            step: step.number,
            travel: step.travel(),
            start: pass.start,
            matrix: pass.matrix,
            iteration: outcome.iterations,
            velocity_norm: outcome.increment,
            residual_norm: outcome.residual_norm,
            share: if outcome.iterations > 0 { trial.line.length } else { 0.0 },
            worst_r: evaluation.nodes[evaluation.worst_node][0],
            active_contacts: evaluation.active_contacts,
            touching: self.contacts().count(),
            sticking: self.contacts().filter(|contact| contact.sticks).count(),
            cut_off: self.increments().filter(|(_, is_cut_off)| *is_cut_off).count(),
        }
    }

    /// Copy of sheet and forces.
    pub fn snapshot(&self) -> IterateSnapshot {
        let (increments, cut_off) = self.increments().unzip();
        IterateSnapshot {
            nodes: self.evaluation.nodes.clone(),
            imbalance: self.evaluation.system.rhs.iter().map(|force| (*force).into()).collect(),
            increments,
            cut_off,
            contacts: self.contacts().collect(),
        }
    }

    fn contacts(&self) -> impl Iterator<Item = IterateContact> {
        let (step, penalty) = (self.step, &self.step.context.penalty);
        let pairs = self.evaluation.contacts.rows().flat_map(|row| row.iter().zip(&self.evaluation.contact_positions));
        pairs.filter(move |(contact, _)| contact.is_active(penalty)).map(move |(contact, place)| IterateContact {
            position: place.position.into(),
            force: (contact.facing * contact.normal + turned(contact.facing) * contact.tangential).into(),
            sticks: contact.slip.abs() < step.slip_scale,
        })
    }

    /// Largest strain increment of each element and the yield stress there, and whether it is cut off.
    fn increments(&self) -> impl Iterator<Item = ([f64; 2], bool)> {
        let is_flow = self.step.model.mode == Mode::Flow;
        let limit = if is_flow { CUT_OFF_ZONE * self.step.cutoff(self.trial.softening) } else { 0.0 };
        self.evaluation.updates.rows().zip(&self.step.bends).map(move |(updates, bends)| {
            let points = if *bends { updates } else { &updates[..1] };
            let larger = |most: [f64; 2], increment: f64, stress: f64| {
                if increment > most[0] { [increment, stress] } else { most }
            };
            let most = points.iter().fold([0.0; 2], |most, point| larger(most, point.increment, point.yield_stress));
            (most, most[0] < limit)
        })
    }
}
