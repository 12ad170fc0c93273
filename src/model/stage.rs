//! Operations after one another on the same sheet.

use crate::model::{Model, Role};

/// One operation: a model of its own, with its tools, loads and material mode, that begins with the sheet that the one
/// before left.
///
/// A tool stays from one stage to the next where both have a tool of its role with the same profile: then it begins where
/// it stood. Any other is new.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Short name, for folders and tables.
    pub name: String,
    /// The blank says what the sheet once was: the solver cuts it to what is left of it.
    pub model: Model,
    /// What happens to the sheet before the first step.
    pub begin: Beginning,
}

/// What happens to the sheet before a stage, and where its new tools begin.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Beginning {
    /// Equivalent strain and stress are set back to nothing: the sheet is as soft as it was at first.
    pub anneal: bool,
    /// Current distance from the axis or symmetry plane at which the sheet is cut \[mm\]; whole elements go.
    pub trim: Option<f64>,
    /// Tools that are brought up along z to where they touch the sheet, punch and holder from below, the die from above;
    /// other new tools begin where they are drawn.
    pub meets: Vec<Role>,
}
