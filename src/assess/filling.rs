//! Filling of a hollow die by pressure: the gap that is left between sheet and die, and the radius in its corner.

use super::{tear::place, *};
use crate::geometry::{Bounds, Point, on_axis};

/// Share of the die's depth that a gap may leave empty at most \[–\]: declared.
const EMPTY: f64 = 0.1;
/// Gap over the thickness up to which the sheet lies against the die, and above which it misses the die's form: declared \[–\].
const GAPS: [f64; 2] = [0.1, 1.0];

pub(super) struct Filling {
    /// \[mm\]
    pub gap: f64,
    /// Initial distance from the axis \[mm\].
    s0: f64,
    /// Radius of an arc from flank to flank of the die's corner that leaves this gap in its middle, and that of the corner \[mm\]:
    /// ρ = r + gap/(1/cos(θ/2) − 1) in a corner that turns by θ; `None` outside a corner.
    corner: Option<[f64; 2]>,
}

impl Filling {
    /// `None` without pressure, or a hollow to fill.
    pub fn of(stage: &StageSolution) -> Option<Self> {
        let (frame, die) = (stage.frames.last()?, &stage.model.tool(Role::Die)?.profile);
        let within = stage.model.gas.iter().map(|gas| gas.within).reduce(f64::max)?;
        let gap = |(i, node): (usize, &NodeRecord)| {
            let x = Point::new(node.r, node.z);
            let closest = die.closest(x);
            let foot = x - closest.distance * closest.normal;
            // Beyond the end of its line there is no die.
            let is_end = |end: Point| !on_axis(&end) && (foot - end).norm() < 1e-6;
            let is_beside = node.r < within && !is_end(die.first()) && !is_end(die.last());
            is_beside.then_some((closest.distance - 0.5 * node.thickness, i, closest.piece))
        };
        let is_hollow = on_axis(&die.last()) || die.pieces().iter().any(|piece| piece.hollow().is_some());
        let gaps = frame.nodes.iter().enumerate().filter_map(gap).filter(|_| is_hollow);
        let (gap, i, piece) = gaps.max_by(|a, b| a.0.total_cmp(&b.0))?;
        let (gap, element) = (gap.max(0.0), &frame.elements[i.min(frame.elements.len() - 1)]);
        let corner = die.pieces()[piece].hollow().filter(|arc| !on_axis(&arc.at(1.0)));
        let corner = corner.map(|arc| [arc.radius + gap / (1.0 / (0.5 * arc.sweep).cos() - 1.0), arc.radius]);
        Some(Self { gap, s0: element.s0, corner })
    }

    /// Place of the gap, and the radius that it leaves in the corner.
    pub fn about(&self, stages: &[StageSolution]) -> String {
        let radii = self.corner.map(|corner| corner.map(Amount::place));
        let radii = radii.map_or_else(String::new, |[own, of_die]| format!("corner radius {own}, the die's {of_die}"));
        joined([place(stages, self.s0), radii], "; ")
    }
}

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let whole = |stage: &&StageSolution| stage.stop.is_complete();
    let stage = run.stages.first().filter(whole).filter(|_| run.fold.is_none())?;
    let (filling, pressure) = (Filling::of(stage)?, stage.steps.last()?.pressure.abs());
    let at = format!("{{}} between sheet and die at {}, {}", Amount::stress(pressure), filling.about(run.stages));
    let judged = Finding::judged("filling", "Filling", run.of_stage(at, 0)).number(Amount::thickness(filling.gap));
    let around = Bounds::around(stage.model.tool(Role::Die)?.profile.pieces().iter().copied())?;
    let most = EMPTY * (around.high - around.low).y;
    let [lies, missed] = GAPS.map(|times| (times * stage.model.blank.thickness).min(most));
    Some(judged.at_most(lies, missed).advice("more pressure, or a larger corner radius of the die"))
}
