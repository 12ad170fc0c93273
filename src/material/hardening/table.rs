use super::monotone::{Extrapolation, Monotone, two_points};
use super::{FlowStress, HardeningLaw};
use crate::material::law::prelude::*;

/// Pairs of strain and stress, as a case has them.
pub(super) type Points = Vec<(NonNegative<Number>, Positive<Stress>)>;

const FORMS: &str = "write points = [[0, \"150 MPa\"], [0.1, \"290 MPa\"]], or both strain = [..] and stress = [..]";
/// Most points.
const MOST: usize = 1000;

/// Measured points, interpolated smoothly: `points`, or `strain` and `stress`.
///
/// Up to 50 points it goes through each of them; more are taken as a record with scatter, which is smoothed first over a third
/// of the strain, 0.1 at most.
///
/// Valid up to the last point; beyond it the case says what is assumed, and the run warns.
/// Source: monotone cubics of F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238–246.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "strain": ["stress"], "stress": ["strain"] }))]
pub struct Table {
    /// Pairs of strain and stress, the first at strain 0: `[[0, "150 MPa"], [0.1, "290 MPa"]]`.
    points: Option<Points>,
    /// Strains, when not given as `points`.
    strain: Option<Vec<NonNegative<Number>>>,
    /// Stresses, when not given as `points`.
    stress: Option<Vec<Positive<Stress>>>,
    /// Extrapolation beyond the last point: a choice that has to be made.
    #[schemars(example = &"slope")]
    extrapolation: Extrapolation,
    /// Takes the place of the points that were read.
    #[serde(skip)]
    pub(super) curve: Monotone,
}

impl Table {
    /// Points with rising strain from 0 and stress > 0 \[MPa\] that does not fall.
    ///
    /// # Errors
    /// When there are fewer than two points or they are not of that kind.
    pub fn new(strain: Vec<f64>, stress: Vec<f64>, beyond: Extrapolation) -> Result<Self, LawError> {
        two_points(strain.len(), stress.len())?;
        let points: Vec<_> = strain.into_iter().zip(stress).collect();
        Monotone::new(&points, beyond, |column, i| format!("{}.{i}", ["strain", "stress"][column])).map(Self::from)
    }
}

impl From<Monotone> for Table {
    fn from(curve: Monotone) -> Self {
        Self { points: None, strain: None, stress: None, extrapolation: curve.beyond(), curve }
    }
}

impl Example for Table {
    fn example() -> Self {
        Monotone::example(1.0).into()
    }
}

impl HardeningLaw for Table {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        self.curve = match (self.points.take(), self.strain.take(), self.stress.take()) {
            (Some(points), None, None) => curve(points, self.extrapolation)?,
            (None, Some(strain), Some(stress)) => {
                few("strain", strain.len(), MOST)?;
                few("stress", stress.len(), MOST)?;
                let strain = strain.into_iter().map(Dimensioned::value).collect();
                Self::new(strain, stress.into_iter().map(Dimensioned::value).collect(), self.extrapolation)?.curve
            }
            _ => return Err(LawError::new("needs `points`, or `strain` and `stress`", FORMS)),
        };
        Ok(())
    }

    fn formula(&self) -> String {
        self.curve.to_string()
    }

    fn at_temperature(&self, strain: f64, _: f64) -> FlowStress {
        self.curve.at(strain)
    }
}

/// Curve through pairs of strain and stress.
pub(super) fn curve(points: Points, beyond: Extrapolation) -> Result<Monotone, LawError> {
    few("points", points.len(), MOST)?;
    let pairs: Vec<_> = points.into_iter().map(|(strain, stress)| (strain.value(), stress.value())).collect();
    Monotone::new(&pairs, beyond, |column, i| format!("points.{i}.{column}"))
}

/// No more entries than `most`.
pub(super) fn few(key: &str, length: usize, most: usize) -> Result<(), LawError> {
    require_or(&format!("{key}.{most}"), length <= most, "leave out what is not needed", || {
        format!("`{key}` has {length} entries, more than {most}")
    })
}
