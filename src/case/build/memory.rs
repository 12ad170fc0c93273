//! Memory of a run, estimated from the model.

use crate::forming_limit::Paths;
use crate::model::Model;
use crate::solver::solution::{ElementRecord, NodeRecord, PointRecord, StepRecord};
use crate::solver::state::MaterialPoint;

/// Fewest steps that a run takes: every frame is landed on, and no step is longer than the longest.
pub(super) fn least_steps(model: &Model) -> usize {
    model.frames.len().max((1.0 / model.settings.max_step).round() as usize)
}

/// Elements whose strains are kept for the forming limit.
pub(super) fn with_path(model: &Model) -> usize {
    if model.forming_limit.is_some() { model.blank.elements } else { 0 }
}

/// Memory that a stage holds until the run has ended \[bytes\].
pub(super) struct Memory {
    pub frames: usize,
    /// Points through the thickness, of the first frame, the last one and the last state alone.
    pub points: usize,
    /// The [`least_steps`], with the strains of every element where there is a forming limit.
    pub steps: usize,
}

impl Memory {
    pub fn of(model: &Model) -> Self {
        let (elements, points, steps) = (model.blank.elements, model.blank.layers, least_steps(model));
        let instants = steps.min(Paths::MOST);
        Self {
            frames: model.frames.len() * elements * (size_of::<ElementRecord>() + size_of::<NodeRecord>()),
            points: elements * points * (2 * size_of::<PointRecord>() + size_of::<MaterialPoint>()),
            steps: steps * size_of::<StepRecord>() + instants * with_path(model) * size_of::<[f64; 2]>(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quickstart(overrides: &[&str]) -> crate::Case {
        let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
        crate::case::load("cases/quickstart.toml", &overrides).expect("valid")
    }

    /// Trust: what a solved case holds, counted in what came out of it.
    #[test]
    fn what_is_counted_is_what_a_run_keeps() {
        let case = quickstart(&["tools.punch.travel=3 mm", "output.count=20", "blank.layers=15"]);
        let solution = case.clone().solve(&mut ());
        let Memory { frames, points, steps } = Memory::of(case.model());
        let stage = &solution.stages[0];
        let of_frame = |f: &crate::Frame| size_of_val(&f.elements[..]) + size_of_val(&f.nodes[..]);
        // A sheet has a node more than elements.
        let ends = stage.frames.len() * size_of::<NodeRecord>();
        assert_eq!(frames, stage.frames.iter().map(of_frame).sum::<usize>() - ends);
        let through = stage.start.iter().chain(&stage.frames).map(|f| size_of_val(&f.through.points[..]));
        let end = stage.end.points.iter().map(size_of_val);
        assert_eq!(points, through.chain(end).sum::<usize>());
        assert!(steps <= size_of_val(&stage.steps[..]), "{steps}");
    }
}
