use super::monotone::{Extrapolation, Monotone};
use super::{FlowStress, HardeningLaw};
use crate::material::law::prelude::*;

/// Pairs of strain and stress, as a case has them.
pub(super) type Points = Vec<(NonNegative<Number>, Positive<Stress>)>;

/// Most points.
const MOST: usize = 1000;

/// Measured points, interpolated smoothly through each of up to 50; a longer record has scatter and is smoothed first.
///
/// Valid up to the last point; beyond it the case says what is assumed, and the run warns.
/// Source: monotone cubics of F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238–246.
#[derive(Clone, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Pairs of strain and stress, the first at strain 0.
    points: Points,
    /// Extrapolation beyond the last point: a choice that has to be made.
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
    pub fn new(strain: Vec<f64>, stress: Vec<f64>, extrapolation: Extrapolation) -> Result<Self, LawError> {
        let points: Vec<_> = strain.into_iter().zip(stress).collect();
        Ok(Self { points: Vec::new(), extrapolation, curve: Monotone::new(&points, extrapolation)? })
    }
}

impl Example for Table {
    fn example() -> Self {
        Self { points: Vec::new(), extrapolation: Extrapolation::Slope, curve: Monotone::example(1.0) }
    }
}

impl HardeningLaw for Table {
    fn prepare(&mut self, _: Option<f64>) -> Result<(), LawError> {
        self.curve = curve(&self.points, self.extrapolation)?;
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
pub(super) fn curve(points: &Points, beyond: Extrapolation) -> Result<Monotone, LawError> {
    few("points", points.len(), MOST)?;
    let pairs: Vec<_> = points.iter().map(|(strain, stress)| (strain.value(), stress.value())).collect();
    Monotone::new(&pairs, beyond)
}

/// No more entries than `most`.
pub(super) fn few(key: &str, length: usize, most: usize) -> Result<(), LawError> {
    require_or(&format!("{key}.{most}"), length <= most, "leave out what is not needed", || {
        format!("`{key}` has {length} entries, more than {most}")
    })
}
