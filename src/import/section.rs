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

/// What was understood of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Sections {
    /// Punch, die, holder, those that are drawn.
    pub tools: Vec<Section>,
    /// Units, direction, halves, joints, what was left out: whole sentences without a full stop.
    pub notes: Vec<String>,
}

impl Sections {
    /// The section of a tool, where it is drawn.
    pub fn tool(&self, role: Role) -> Option<&Section> {
        self.tools.iter().find(|tool| tool.role == role)
    }
}
