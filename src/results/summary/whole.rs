//! The summaries of all stages of a case together.

use super::Summary;
use crate::case::Solution;
use crate::results::{Results, StageView, stages};
use serde::ser::{Serialize, SerializeMap, Serializer};
use std::fmt;

/// What a solved case comes to: displays as aligned text; serialises as its one stage, or with a list of them.
#[derive(Clone, Debug)]
pub struct CaseSummary {
    /// Name of the case.
    pub case: String,
    /// Whether every stage came to its end.
    pub complete: bool,
    /// Of every stage that was run.
    pub stages: Vec<Summary>,
    /// A line for every stage; empty in a case of one stage.
    pub lines: String,
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

impl CaseSummary {
    fn text(&self) -> String {
        let stages: Vec<String> = self.stages.iter().map(|stage| stage.to_string()).collect();
        let stages = stages.join("\n");
        if self.lines.is_empty() {
            return stages;
        }
        format!("{stages}\n{}\n{}\n", String::from("Stages").to_string(), self.lines.to_string())
    }
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

impl Serialize for CaseSummary {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match &self.stages[..] {
            [one] if self.lines.is_empty() => return one.serialize(serializer),
            _ => {}
        }
        let mut map = serializer.serialize_map(Some(3))?;
        map.serialize_entry("case", &self.case)?;
        map.serialize_entry("complete", &self.complete)?;
        map.serialize_entry("stages", &self.stages)?;
        map.end()
    }
}

impl fmt::Display for CaseSummary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())
    }
}
