//! `[gas]`: pressure on the faces of the sheet.

use super::Given;
use crate::units::{Length, NonNegative, Number, Positive, StrainRate, Stress, StressRate, Time};
use serde::Deserialize;

/// Gas or oil pressure; alone it bulges the blank, against a punch it forms the sheet over it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
pub struct Gas {
    /// On the punch's side: pushes along the punch travel.
    pub lower: Option<GasFace>,
    /// On the die's side: pushes against the punch travel.
    pub upper: Option<GasFace>,
    /// How long the run takes when there is no punch.
    #[schemars(example = "10 s")]
    pub duration: Option<Positive<Time>>,
}

/// Pressure on one face.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[derive(schemars::JsonSchema)]
#[schemars(extend("dependentRequired" = { "norm": ["strain_rate"], "max_pressure": ["strain_rate"], "max_pressure_rate": ["strain_rate"] }))]
pub struct GasFace {
    /// The pressure, or its history over time: [["0 s", "0 MPa"], ["10 s", "5 MPa"]]. One pressure and no punch: it is
    /// raised evenly over the duration, for a flat sheet cannot bear it at once.
    #[schemars(example = "5 MPa")]
    pub pressure: Option<Given<NonNegative<Time>, NonNegative<Stress>>>,
    /// Superplastic forming, instead of a pressure: the strain rate that the pressure holds in every step.
    #[schemars(example = "0.001 /s")]
    pub strain_rate: Option<Positive<StrainRate>>,
    /// Norm of the strain rate over the sheet's volume, 1 to 50: 1 is the mean, a large one the fastest place; 10 when not
    /// given.
    #[schemars(example = 10.0)]
    pub norm: Option<Positive<Number>>,
    /// With a strain rate: the largest pressure that the press gives; where the rate would ask for more, the pressure stays
    /// here and the rate falls below its target.
    #[schemars(example = "2 MPa")]
    pub max_pressure: Option<Positive<Stress>>,
    /// With a strain rate: the fastest rise of the pressure that the press gives.
    #[schemars(example = "0.01 MPa/s")]
    pub max_pressure_rate: Option<Positive<StressRate>>,
    /// Distance of the seal from the axis or symmetry plane; when not given, the holder's inner edge (lower face) or the
    /// end of the die's shoulder (upper face), or else the whole blank.
    #[schemars(example = "50 mm")]
    pub within: Option<Positive<Length>>,
}
