//! Numbers, curves and end of a run.

use super::{Direction, Number, numbers};
use crate::assess::{Finding, after_one_of_many, forming_limit_used, largest_force};
use crate::case::{Case, Solution};
use crate::model::mesh;
use crate::numerics::interpolated;
use crate::solver::solution::{StageSolution, Stop};

/// Numbers, curves and end of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Refined direction; `None` for the verified run.
    pub direction: Option<Direction>,
    /// Refinement factor \[–\]; below 1 coarser.
    pub times: f64,
    /// End.
    pub end: End,
    /// Numbers, without error bars.
    pub numbers: Vec<Number>,
    /// Punch force \[N, or N/mm\] over the travel \[mm\] of the stage with the largest; empty if no punch moves.
    pub load: Vec<(f64, f64)>,
    /// Thickness \[mm\] of the part over the initial distance from the axis \[mm\].
    pub thickness: Vec<(f64, f64)>,
    /// Used share of the forming limit \[%\] over the initial distance from the axis \[mm\], of the stage that comes nearest to
    /// it; empty without a limit.
    pub used: Vec<(f64, f64)>,
    /// Shortest element over the sheet thickness \[–\].
    pub shortest: f64,
}

/// End of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct End {
    /// Stages that were run.
    pub stages: usize,
    /// Reason of the last stage's end, in a few words.
    pub kind: &'static str,
    /// Reason as a sentence.
    pub why: String,
    /// True if it came to the requested end.
    pub complete: bool,
    /// True if the numerics or the user ended it, which says nothing of the part.
    pub lost: bool,
}

impl End {
    fn of(case: &Case, stages: &[StageSolution]) -> Self {
        let last = stages.last().map_or(&Stop::FullTravel, |stage| &stage.stop);
        Self {
            stages: stages.len(),
            kind: last.kind(),
            why: last.to_string(),
            complete: stages.len() == case.stages.len() && last.is_complete(),
            lost: !last.is_complete() && !last.is_physical(),
        }
    }

    /// True if another run ended in the same stage for the same reason.
    pub fn is_like(&self, other: &Self) -> bool {
        (self.stages, self.kind) == (other.stages, other.kind)
    }
}

impl Outcome {
    /// Outcome of a solution, refined in a direction by a factor.
    pub fn of(solution: &Solution, refined: Option<(Direction, f64)>) -> Self {
        Self::with_findings(solution, refined, &after_one_of_many(&solution.case, &solution.stages))
    }

    /// Outcome with known [findings](after_one_of_many).
    pub fn with_findings(solution: &Solution, refined: Option<(Direction, f64)>, findings: &[Finding]) -> Self {
        let Solution { case, stages, .. } = solution;
        let load =
            largest_force(stages).map(|(i, _)| stages[i].steps.iter().map(|s| (s.travel, s.punch_force)).collect());
        let last = stages.last().and_then(|stage| stage.frames.last());
        let elements = last.into_iter().flat_map(|frame| &frame.elements);
        let first = case.model();
        let shortest = mesh::nodes(first).windows(2).map(|w| w[1] - w[0]).fold(f64::INFINITY, f64::min);
        Self {
            direction: refined.map(|(direction, _)| direction),
            times: refined.map_or(1.0, |(_, times)| times),
            end: End::of(case, stages),
            numbers: numbers(case, stages, findings),
            load: load.unwrap_or_default(),
            thickness: elements.map(|element| (element.s0, element.thickness)).collect(),
            used: forming_limit_used(stages).map_or_else(Vec::new, |used| used.shares),
            shortest: shortest / first.blank.thickness,
        }
    }

    /// Value of a number, at the place that the number is of.
    pub fn value(&self, number: &Number) -> Option<f64> {
        let own = self.numbers.iter().find(|own| own.is(number))?;
        let there = number.s0.filter(|_| !self.used.is_empty()).map(|place| interpolated(&self.used, place));
        Some(there.unwrap_or(own.quantity.value()))
    }

    /// True if it came to another end than the verified run, for a reason of the part's.
    pub(super) fn ends_otherwise(&self, base: &Self) -> bool {
        !self.end.lost && !self.end.is_like(&base.end)
    }
}
