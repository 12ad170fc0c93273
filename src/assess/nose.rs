//! Where a punch's nose ends in its wall.

use crate::geometry::Arc;
use crate::model::{Role, Tool};
use crate::solver::solution::StageSolution;

/// Cosine of a lean that is none: to a degree.
const UPRIGHT: f64 = 0.9998;

/// The end of the nose of a flat-bottomed punch.
#[derive(Clone, Copy, Debug)]
pub(super) struct NoseEnd {
    /// \[mm\]
    pub radius: f64,
    /// Cosine of the wall's lean to the axis \[–\].
    pub cosine: f64,
}

impl NoseEnd {
    /// `None` for a punch without a flat bottom as wide as the sheet is thick, and without a punch.
    pub fn of(stage: &StageSolution) -> Option<Self> {
        let nose = nose(stage.model.tool(Role::Punch)?)?;
        let end = [nose.at(0.0), nose.at(1.0)].into_iter().max_by(|a, b| a.x.total_cmp(&b.x))?;
        let flat = inner(&nose) > stage.model.blank.thickness;
        flat.then(|| Self { radius: end.x, cosine: (end.x - nose.center.x) / nose.radius })
    }

    /// Whether the wall above is straight.
    pub fn is_upright(self) -> bool {
        self.cosine > UPRIGHT
    }
}

/// The corner of a punch that is nearest the axis.
pub(super) fn nose(punch: &Tool) -> Option<Arc> {
    punch.profile.corners().min_by(|a, b| inner(a).total_cmp(&inner(b)))
}

/// Smallest distance of an arc's ends from the axis \[mm\].
fn inner(arc: &Arc) -> f64 {
    arc.at(0.0).x.min(arc.at(1.0).x)
}
