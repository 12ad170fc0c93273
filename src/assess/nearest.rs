//! The stage that comes nearest to its forming limit.

use crate::forming_limit::{Assessment, assess};
use crate::solver::solution::StageSolution;

/// The stage that comes nearest to its curve.
pub(super) struct Nearest<'a> {
    /// The curve's.
    pub name: &'static str,
    pub stage: &'a StageSolution,
    pub assessment: Assessment,
}

impl<'a> Nearest<'a> {
    /// `None` where no stage has a limit.
    pub fn of(passes: &'a [StageSolution]) -> Option<Self> {
        let all = passes.iter().filter_map(|stage| {
            let curve = stage.model.forming_limit.as_ref()?;
            Some(Self { name: curve.name, stage, assessment: assess(curve, &stage.paths)? })
        });
        // What is not kept, or not known, goes before what is near.
        all.min_by(|a, b| {
            let margin = |it: &Self| it.assessment.worst().margin();
            a.is_kept().cmp(&b.is_kept()).then(margin(a).total_cmp(&margin(b)))
        })
    }

    /// Whether no stage has reached its limit, nor gone beyond where the curve ends.
    pub fn is_kept(&self) -> bool {
        self.assessment.is_kept()
    }
}
