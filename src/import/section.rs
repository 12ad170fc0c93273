//! Sections read from a drawing.

use crate::geometry::{Point, Profile};
use crate::model::Role;

/// Section of a tool.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// The tool.
    pub role: Role,
    /// Profile with the sheet on its left, z along the punch travel, not moved.
    pub profile: Profile,
    /// Ends of drawn lines, arcs and splines \[mm\].
    pub ends: Vec<Point>,
    /// Source, `4 entities of layer "PUNCH"`.
    pub made_of: String,
}

/// Tools of one operation.
#[derive(Clone, Debug, PartialEq)]
pub struct Operation {
    /// Number in the layers' names, if any.
    pub number: Option<u32>,
    /// Punch, die, holder as far as they are drawn.
    pub tools: Vec<Section>,
}

impl Operation {
    /// `OP30`.
    pub fn name(&self) -> String {
        self.number.map_or_else(|| "the first operation".to_owned(), |number| format!("OP{number}"))
    }

    /// Section of a tool, if drawn.
    pub fn tool(&self, role: Role) -> Option<&Section> {
        self.tools.iter().find(|tool| tool.role == role)
    }
}

/// Tools read from a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Number of the first operation, if there are several.
    pub number: Option<u32>,
    /// Tools of the first operation.
    pub tools: Vec<Section>,
    /// Later operations, by their numbers.
    pub later: Vec<Operation>,
    /// How the drawing was understood: unit, direction, halves, joints, omissions.
    pub notes: Vec<String>,
}

impl Sections {
    /// Section of a tool of the first operation, if drawn.
    pub fn tool(&self, role: Role) -> Option<&Section> {
        self.tools.iter().find(|tool| tool.role == role)
    }
}
