//! What is kept of the iterations of a step.

use super::rate::Rate;
use crate::element::Node;
use crate::model::Iteration;
use crate::solver::{Iterate, Observer, Start, Touching};
use nalgebra::Vector3;

/// A step with one matrix.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// What the settings say; a start may take the secant matrix first.
    pub matrix: Iteration,
    /// Tries of the step, from start to start.
    pub attempts: Vec<Attempt>,
    /// Whether the last of them came to equilibrium.
    pub converged: bool,
}

/// A try of the step.
#[derive(Clone, Debug, PartialEq)]
pub struct Attempt {
    /// Where it began.
    pub start: Start,
    /// The corrector gone through, once or more often.
    pub passes: Vec<Pass>,
}

/// The corrector gone through once, with one matrix and one cut-off.
#[derive(Clone, Debug, PartialEq)]
pub struct Pass {
    /// The matrix.
    pub matrix: Iteration,
    /// Δε₀ \[–\]; `None` of elastoplastic metal, which has none.
    pub cutoff: Option<f64>,
    /// What it starts from, which of the first pass of a predictor is the predictor, and what each iteration comes to.
    pub iterated: Vec<Iterated>,
}

/// The sheet as an iteration leaves it, or as it is before the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Iterated {
    /// Number of the iteration; 0 before the first.
    pub iteration: usize,
    /// Relative increment of the velocities that led here \[–\]; `None` before the first.
    pub velocity_norm: Option<f64>,
    /// Share of the increment that was taken \[–\]; `None` before the first.
    pub share: Option<f64>,
    /// Largest force out of balance over the largest force at a node \[–\].
    pub residual_norm: f64,
    /// The node where it sits, from the axis outward, counted from 0.
    pub worst_node: usize,
    /// From the axis outward.
    pub nodes: Vec<Node>,
    /// −r: force on every node along r and z \[N, or N/mm\] and moment \[N mm, or N\] that are not in balance.
    pub imbalance: Vec<Vector3<f64>>,
    /// Largest strain increment of each element at a thickness point, and the yield stress there \[–, MPa\].
    pub increments: Vec<[f64; 2]>,
    /// Elements that hardly flow, by less than ten times the cut-off.
    pub cut_off: Vec<bool>,
    /// Points of the sheet that a tool presses.
    pub touching: Vec<Touching>,
}

/// What a matrix is called in case files and tables.
pub fn key(matrix: Iteration) -> &'static str {
    match matrix {
        Iteration::PrimalDual => "primal_dual",
        Iteration::Newton => "newton",
        Iteration::Secant => "secant",
    }
}

impl Attempt {
    /// What its start is called in tables.
    pub fn key(&self) -> &'static str {
        match self.start {
            Start::Predictor => "predictor",
            Start::Secant => "secant",
            Start::Softened => "softened",
            Start::SoftenedInSteps => "softened_in_steps",
        }
    }
}

impl Way {
    /// The iterations of the last pass of the last try: those that came to equilibrium, where it did.
    pub fn iterations(&self) -> &[Iterated] {
        self.attempts.last().and_then(|attempt| attempt.passes.last()).map_or(&[], |pass| &pass.iterated)
    }

    /// All iterations of all tries.
    pub fn count(&self) -> usize {
        let passes = self.attempts.iter().flat_map(|attempt| &attempt.passes);
        passes.filter_map(|pass| pass.iterated.last()).map(|last| last.iteration).sum()
    }

    /// How fast the last pass converges; `None` where it is too short to say.
    pub fn rate(&self) -> Option<Rate> {
        let whole = |i: &Iterated| i.velocity_norm.filter(|_| i.share >= Some(1.0));
        Rate::of(&self.iterations().iter().map(whole).collect::<Vec<_>>())
    }
}

impl Iterated {
    /// How many elements hardly flow.
    pub fn cut_off(&self) -> usize {
        self.cut_off.iter().filter(|cut_off| **cut_off).count()
    }

    /// How many of the contact points stick.
    pub fn sticking(&self) -> usize {
        self.touching.iter().filter(|point| point.sticks).count()
    }
}

/// Keeps all iterations of a step.
#[derive(Default)]
pub(super) struct Attempts(pub Vec<Attempt>);

impl Observer for Attempts {
    fn attempt(&mut self, start: Start) {
        self.0.push(Attempt { start, passes: Vec::new() });
    }

    fn wants_iterates(&self) -> bool {
        true
    }

    fn iterate(&mut self, iterate: &Iterate<'_>) {
        let Some(attempt) = self.0.last_mut() else { return };
        if iterate.iteration == 0 {
            attempt.passes.push(Pass { matrix: iterate.matrix, cutoff: iterate.cutoff, iterated: Vec::new() });
        }
        let Some(pass) = attempt.passes.last_mut() else { return };
        let elements = 0..iterate.thickness.len();
        let came = |value: f64| (iterate.iteration > 0).then_some(value);
        pass.iterated.push(Iterated {
            iteration: iterate.iteration,
            velocity_norm: came(iterate.velocity_norm),
            share: came(iterate.share),
            residual_norm: iterate.residual_norm,
            worst_node: iterate.worst_node,
            nodes: iterate.nodes.to_vec(),
            imbalance: iterate.imbalance.to_vec(),
            increments: elements.clone().map(|e| iterate.largest_increment(e)).collect(),
            cut_off: elements.map(|e| iterate.is_cut_off(e)).collect(),
            touching: iterate.touching().collect(),
        });
    }
}
