//! The press's rating.

use super::HolderForce;
use crate::units::{Energy, Positive};
use serde::Deserialize;

/// What the press can give, as its data sheet says.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Press {
    /// Largest force; in plane strain per mm of depth of the whole section, or in all where blank.depth is given.
    #[schemars(example = "1000 kN")]
    pub force: Option<HolderForce>,
    /// Work of one stroke; in plane strain only where blank.depth is given.
    #[schemars(example = "20 kJ")]
    pub energy: Option<Positive<Energy>>,
}
