//! Summaries of all stages of a case.

use super::Summary;
use crate::case::Solution;
use crate::plot::StageView;
use crate::results::{Results, stages};
use serde::{Serialize, Serializer};
use serde_json::json;
use std::fmt;

/// Summary of a case: displays as aligned text; serialises as its one stage, or with a list of them.
#[derive(Clone, Debug)]
pub struct CaseSummary {
    /// Name of the case.
    pub case: String,
    /// True if every stage came to its end.
    pub complete: bool,
    /// Summaries of the stages that were run.
    pub stages: Vec<Summary>,
    /// A line for every stage; empty in a case of one stage.
    pub lines: String,
}

impl Solution {
    /// Sums up every stage.
    pub fn summary(&self) -> CaseSummary {
        CaseSummary::of(self, &self.views())
    }
}

impl Results<'_> {
    /// Sums up every stage.
    pub fn summary(&self) -> CaseSummary {
        CaseSummary::of(self.solution, &self.views)
    }
}

impl CaseSummary {
    fn of(solution: &Solution, views: &[StageView]) -> Self {
        Self {
            case: solution.case.name.clone(),
            complete: solution.is_complete(),
            stages: views.iter().map(Summary::of).collect(),
            lines: stages::printed(solution),
        }
    }
}

impl Serialize for CaseSummary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.stages.as_slice() {
            [stage] if self.lines.is_empty() => stage.serialize(serializer),
            stages => json!({"case": self.case, "complete": self.complete, "stages": stages}).serialize(serializer),
        }
    }
}

impl fmt::Display for CaseSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let stages: Vec<String> = self.stages.iter().map(Summary::to_string).collect();
        f.write_str(&stages.join("\n"))?;
        if self.lines.is_empty() { Ok(()) } else { write!(f, "\nStages\n{}\n", self.lines) }
    }
}
