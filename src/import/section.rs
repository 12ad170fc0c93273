//! What was understood of a drawing.

use crate::geometry::{Point, Profile};
use crate::model::Role;

/// A tool's section that was read.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Which tool it is.
    pub role: Role,
    /// The sheet on its left; z in the direction of the punch travel, not moved.
    pub profile: Profile,
    /// Where lines and arcs of the drawing, and whole splines, begin and end \[mm\].
    pub ends: Vec<Point>,
    /// What it was made of: `4 entities of layer "PUNCH"`.
    pub made_of: String,
}

/// The tools of one operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// As its layers name it; `None` of layers without a number.
    pub number: Option<u32>,
    /// Punch, die, holder, those that are drawn; where there are several operations, each has its punch.
    pub tools: Vec<Section>,
}

impl Operation {
    /// `OP30`.
    pub fn name(&self) -> String {
        self.number.map_or_else(|| "the first operation".to_owned(), |number| format!("OP{number}"))
    }

    /// The section of a tool of the first operation, where it is drawn.
    pub fn tool(&self, role: Role) -> Option<&Section> {
        self.tools.iter().find(|tool| tool.role == role)
    }
}

/// What was understood of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Number of the first operation, where layers name several.
    pub number: Option<u32>,
    /// Punch, die, holder of the first operation, those that are drawn.
    pub tools: Vec<Section>,
    /// The operations after it, by their numbers.
    pub later: Vec<Operation>,
    /// Units, direction, halves, joints, what was left out: whole sentences without a full stop.
    pub notes: Vec<String>,
}

impl Sections {
    /// The section of a tool of the first operation, where it is drawn.
    pub fn tool(&self, role: Role) -> Option<&Section> {
        self.tools.iter().find(|tool| tool.role == role)
    }
}
