//! Callbacks of a run, and the view of an evaluation that they get.

use super::{corrector::Pass, step::CUT_OFF_ZONE, step::elastoplastic_law, *};
use crate::material::{PointLaw, flow::PointSnapshot};

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
    /// Returns `true` to end the run as [interrupted](crate::solver::solution::StopKind::Interrupted); before steps and iterations.
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
    /// Displacement of each tool along r and z \[mm\].
    pub tools: Vec<[f64; 2]>,
    /// Forces out of balance at the nodes along r and z, and moments; 0 at held freedoms \[N, N mm, or per mm of depth\].
    pub imbalance: Vec<[f64; 3]>,
    /// δȧ of the nodes by the last iteration \[mm/s, rad/s\]; 0 of a predictor.
    pub correction: Vec<Node>,
    /// Thickness points of each element.
    pub points: Vec<Vec<PointSnapshot>>,
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
    /// Gap between tool and face \[mm\], negative where the tool penetrates.
    pub gap: f64,
    /// Pressure \[MPa\].
    pub pressure: f64,
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
            cut_off: self.cut_off().filter(|is| *is).count(),
        }
    }

    /// Copy of sheet and forces.
    pub fn snapshot(&self) -> IterateSnapshot {
        let Self { step, trial, evaluation, .. } = self;
        let share = if self.outcome.iterations > 0 { trial.line.length / step.dt } else { 0.0 };
        IterateSnapshot {
            nodes: evaluation.nodes.clone(),
            tools: trial.tools.iter().map(|tool| (*tool).into()).collect(),
            imbalance: evaluation.system.rhs.iter().map(|force| (*force).into()).collect(),
            correction: trial.line.direction.iter().map(|d| (share * d).into()).collect(),
            points: (0..step.references.len()).map(|e| self.points(e)).collect(),
            cut_off: self.cut_off().collect(),
            contacts: self.contacts().collect(),
        }
    }

    fn contacts(&self) -> impl Iterator<Item = IterateContact> {
        let (step, penalty) = (self.step, &self.step.context.penalty);
        let pairs = self.evaluation.contacts.rows().flat_map(|row| row.iter().zip(&self.evaluation.contact_positions));
        pairs.filter(move |(contact, _)| contact.is_active(penalty)).map(move |(contact, place)| IterateContact {
            position: place.position.into(),
            force: (contact.facing * contact.normal + turned(contact.facing) * contact.tangential).into(),
            gap: contact.gap,
            pressure: contact.pressure.value,
            sticks: contact.slip.abs() < step.slip_scale,
        })
    }

    fn points(&self, e: usize) -> Vec<PointSnapshot> {
        let Self { step, trial, pass, .. } = self;
        let Step { model, dt, .. } = step;
        let material = step.context.metal(e).material;
        let snapshot = |(k, update)| match model.mode {
            Mode::Flow => {
                let law = material.flow_law(pass.matrix, step.cutoff(trial.softening), *dt);
                law.snapshot(&step.flow_points[(e, k)], &trial.iterates[(e, k)], update)
            }
            _ => {
                let (point, memory) = (&step.elastoplastic_points[(e, k)], &trial.elastoplastic[(e, k)]);
                elastoplastic_law(model, material, pass.matrix, *dt).snapshot(point, memory, update)
            }
        };
        self.evaluation.updates.row(e).iter().enumerate().map(snapshot).collect()
    }

    fn cut_off(&self) -> impl Iterator<Item = bool> {
        let is_flow = self.step.model.mode == Mode::Flow;
        let limit = if is_flow { CUT_OFF_ZONE * self.step.cutoff(self.trial.softening) } else { 0.0 };
        self.evaluation.updates.rows().map(move |points| points.iter().all(|point| point.increment < limit))
    }
}
