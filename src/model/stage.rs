//! Sequences of operations on the same sheet.

use crate::model::{Model, Role};

/// Operation on the sheet of the one before. A tool with the role and profile of one before begins there; others are new.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Short name, for folders and tables.
    pub name: String,
    /// Model with the initial blank, which the solver cuts to what is left of it.
    pub model: Model,
    /// Preparation of the sheet and the tools.
    pub begin: Beginning,
}

/// Preparation of the sheet and the tools before a stage.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Beginning {
    /// Turns the sheet over, z → −z, as for a reverse redraw; every tool begins anew.
    pub turn_over: bool,
    /// Resets equivalent strain and stress to 0.
    pub anneal: bool,
    /// Distance from the axis or symmetry plane at which the sheet is cut, by whole elements \[mm\].
    pub trim: Option<f64>,
    /// Tools that are brought up along z to touch the sheet; other new tools begin where they are drawn.
    pub meets: Vec<Role>,
}
