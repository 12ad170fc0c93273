//! `[output]`.

use crate::units::{Length, Positive};
use schemars::JsonSchema;
use serde::Deserialize;

/// Which instants are kept: `frames` or `count`; the end of the travel always is.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Punch travels at which the state is kept.
    pub frames: Option<Vec<Positive<Length>>>,
    /// Number of equally spaced instants, 1 to 1000; 4 when neither is given.
    #[schemars(range(min = 1, max = 1000), example = 4)]
    pub count: Option<i64>,
}
