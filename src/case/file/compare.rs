//! `[[compare]]`: a published curve and how well it must be met.

use crate::quantity::{Number, Positive, Ratio};
use schemars::JsonSchema;
use serde::Deserialize;

/// One comparison with a reference curve.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Compare {
    /// CSV file, looked for in `reference_data` beside the folder of the case, then beside the case.
    #[schemars(example = "woo_load_travel.csv")]
    pub reference: String,
    /// Column of the CSV along which to compare.
    #[schemars(example = &"travel_mm")]
    pub x: String,
    /// Column of the CSV that is compared.
    #[schemars(example = &"punch_force_N")]
    pub y: String,
    #[schemars(example = &"punch_force")]
    pub quantity: ComparedQuantity,
    /// Part of the curve that is compared, in units of the x column; all of it when not given.
    pub range: Option<[Number; 2]>,
    /// Accepted relative difference.
    #[schemars(example = "5 %")]
    pub tolerance: Positive<Ratio>,
    /// Why that tolerance.
    #[schemars(example = "reading error of the published graph")]
    pub reason: String,
    /// Whether the file may be missing: drop the CSV into `reference_data` to see the overlay.
    #[serde(default)]
    pub optional: bool,
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ComparedQuantity {
    /// Punch force at equal travel.
    PunchForce,
    /// Punch travel at equal force.
    Travel,
    /// Thickness over the initial distance from the axis or symmetry plane, at the end.
    ThicknessAtS0,
    /// Thickness over the present radius, at the end.
    ThicknessAtRadius,
}
