//! `[output]`.

use crate::units::{Length, Positive};
use serde::Deserialize;

/// Which instants are kept: `frames` or `count`; the end of the travel always is.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Output {
    /// Punch travels at which the state is kept.
    pub frames: Option<Vec<Positive<Length>>>,
    /// Number of equally spaced instants, 1 to 1000; 4 when neither is given.
    #[schemars(range(min = 1, max = 1000), example = 4)]
    pub count: Option<i64>,
}
