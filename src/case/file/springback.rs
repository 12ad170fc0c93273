//! How far the part may be from what is wanted once its tools are taken away, and the ring that is cut from it.

use crate::units::{Angle, Length, NonNegative, Positive};
use serde::Deserialize;

/// The part's tolerances, for the verdict on a case whose last stage takes the tools away, and the split-ring test; the run does
/// not depend on them.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Springback {
    /// Wanted angle between the two legs or walls of the whole section, 0 deg where they are upright. When not given, that of
    /// the punch's straight wall where the sheet lies against it, else the one under the tools.
    #[schemars(example = "90 deg")]
    pub angle: Option<NonNegative<Angle>>,
    /// By how much that angle, of both walls together, may miss; instead of `wall_tolerance`.
    #[schemars(example = "1 deg")]
    pub tolerance: Option<Positive<Angle>>,
    /// By how much the angle of each wall may miss: half of what the angle between both may.
    #[schemars(example = "0.5 deg")]
    pub wall_tolerance: Option<Positive<Angle>>,
    /// By how much each flange may turn from where it is under the tools.
    #[schemars(example = "1 deg")]
    pub flange_tolerance: Option<Positive<Angle>>,
    /// By how much each edge may move inward or outward from where it is under the tools.
    #[schemars(example = "0.5 mm")]
    pub edge_tolerance: Option<Positive<Length>>,
    /// A ring that is cut from the wall of a drawn cup and slit: its opening is told.
    pub ring: Option<Ring>,
}

/// A ring of the wall of a cup that stands on its bottom.
#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Ring {
    /// Height of its lower edge over the outside of the bottom.
    #[schemars(example = "20 mm")]
    pub from: NonNegative<Length>,
    /// Its height, from edge to edge.
    #[schemars(example = "5 mm")]
    pub height: Positive<Length>,
}
