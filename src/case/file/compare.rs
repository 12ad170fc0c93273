//! `[[compare]]`: a published curve and how well it must be met, or the band that published values span.

use crate::units::{Number, Positive, Ratio};
use serde::Deserialize;

/// One comparison with a reference: a curve (`x`, `y`, `tolerance`) or a band (`band`), as the quantity asks for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(extend("dependentRequired" = { "x": ["y"], "y": ["x"], "error": ["band"] }))]
pub struct Compare {
    /// CSV file, looked for in `reference_data` beside the folder of the case, then beside the case.
    #[schemars(example = "woo_load_travel.csv")]
    pub reference: String,
    /// What is compared.
    #[schemars(example = &"punch_force")]
    pub quantity: ComparedQuantity,
    /// Column of the CSV along which to compare with a curve.
    #[schemars(example = &"travel_mm")]
    pub x: Option<String>,
    /// Column of the CSV that is compared with a curve. Forces of a plane section are of both halves: per mm of depth, N_per_mm,
    /// or in all where blank.depth is given; a published curve of one half is doubled in the file, with a word on it.
    #[schemars(example = &"punch_force_N")]
    pub y: Option<String>,
    /// Part of the curve that is compared, in units of the x column; all of it when not given.
    pub range: Option<[Number; 2]>,
    /// Accepted relative difference from a curve.
    #[schemars(example = "5 %")]
    pub tolerance: Option<Positive<Ratio>>,
    /// Columns of the CSV whose values, all rows of them, span the band.
    #[schemars(example = &("diameter_x_mm", "diameter_y_mm"))]
    pub band: Option<Vec<String>>,
    /// Column of the CSV with each row's error of measurement, which widens the band.
    #[schemars(example = &"error_mm")]
    pub error: Option<String>,
    /// Why that tolerance, or where a difference comes from.
    #[schemars(example = "reading error of the published graph")]
    pub reason: String,
    /// Whether the file may be missing: drop the CSV into `reference_data` to see the overlay.
    #[serde(default)]
    pub optional: bool,
    /// Whether the difference is shown without failing a validation, because the input is not that of the reference.
    #[serde(default)]
    pub demonstration: bool,
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "snake_case")]
#[derive(schemars::JsonSchema)]
pub enum ComparedQuantity {
    /// Punch force at equal travel, a curve.
    PunchForce,
    /// Punch travel at equal force, a curve.
    Travel,
    /// Thickness over the initial distance from the axis or symmetry plane at the end, a curve.
    ThicknessAtS0,
    /// Thickness over the present radius at the end, a curve.
    ThicknessAtRadius,
    /// Minor over major true strain of the place that is thinnest at the end, on its way there, a curve; with `[forming_limit]`.
    StrainPath,
    /// Draw-in of the edge at equal travel, a curve.
    DrawInAtTravel,
    /// Diameter at the blank's edge (in plane strain the width between both edges) at the end, a band.
    EdgeDiameter,
    /// How far the edge has moved inward at the end, a band.
    DrawIn,
    /// Smallest thickness at the end, a band.
    Thinnest,
    /// Thickness of the whole section at the end, a band.
    Thickness,
    /// Largest punch force of the run, a band.
    PeakForce,
    /// Punch travel at the largest punch force, once the force has fallen from it, a band: the index of a cupping test.
    PeakTravel,
    /// By how much the ring of `[springback]` opens when it is slit, a band.
    RingOpening,
}
