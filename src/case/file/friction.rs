//! `friction` of a tool or a side of the sheet.

use crate::contact::friction;
use crate::material::law::Named;
use serde::Deserialize;

/// Coulomb's coefficient, or another law with its parameters.
pub type Friction = Named<friction::Friction>;

/// Friction by the face of the sheet, for tools that do not name their own, and where all of the case's friction comes from.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Sides {
    /// Of the face that punch and holder touch: a coefficient, 0 to 1, or a law.
    #[schemars(example = 0.08)]
    pub punch_side: Option<Friction>,
    /// Of the face that the die touches: a coefficient, 0 to 1, or a law.
    #[schemars(example = 0.08)]
    pub die_side: Option<Friction>,
    /// Where the coefficients of all tools come from: how they were measured, or author and year; left out where they are
    /// assumed.
    #[schemars(example = &"strip drawing with this oil")]
    pub source: Option<String>,
}
