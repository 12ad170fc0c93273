//! Measured stress-strain points, interpolated without overshoot; a long record is first smoothed by local parabolas.
//!
//! # References
//! W. S. Cleveland, Robust locally weighted regression and smoothing scatterplots, J. Am. Stat. Assoc. 74 (1979) 829–836
//! (not read).
//! F. N. Fritsch, R. E. Carlson, Monotone piecewise cubic interpolation, SIAM J. Numer. Anal. 17 (1980) 238–246;
//! slopes by the harmonic mean of F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300–304.

use super::*;
use nalgebra::{Matrix3, Vector3};
use std::fmt;

/// Tables of no more points go through each of them.
const FEW: usize = 50;
/// Half-width of smoothing in strain, over the strain itself and at most \[–\]: it moves Swift's law by less than 1e-4.
const REACH: [f64; 2] = [1.0 / 3.0, 0.1];
/// Fewest points among which a parabola can smooth.
const FIT: usize = 8;

pub(super) type Points = Vec<(NonNegative<Number>, Positive<Stress>)>;

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
    /// Points with rising strain from 0 and stress > 0 \[MPa\] that does not fall. Fails without two points of that kind.
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

pub(super) fn curve(points: &Points, beyond: Extrapolation) -> Result<Monotone, LawError> {
    few("points", points.len(), MOST)?;
    Monotone::new(&points.iter().map(|(strain, stress)| (strain.value(), stress.value())).collect::<Vec<_>>(), beyond)
}

pub(super) fn few(key: &str, length: usize, most: usize) -> Result<(), LawError> {
    require_or(&format!("{key}.{most}"), length <= most, "leave out what is not needed", || {
        format!("`{key}` has {length} entries, more than {most}")
    })
}

/// Beyond the last point of a table: a declared choice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Extrapolation {
    /// Keeps the last stress.
    #[default]
    Hold,
    /// Goes on along the last two points.
    Slope,
}

/// Monotone cubic interpolation of (ε̄, σ_y) points; it never rises or falls where the points do not.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Monotone {
    strain: Vec<f64>,
    stress: Vec<f64>,
    slope: Vec<f64>,
    beyond: Extrapolation,
}

impl Monotone {
    pub fn new(points: &[(f64, f64)], beyond: Extrapolation) -> Result<Self, LawError> {
        let n = points.len();
        require("", n >= 2, || format!("needs at least two points, each with a strain and a stress; found {n}"))?;
        let key = |column: usize, i: usize| format!("points.{i}.{column}");
        let (strain, stress): (Vec<f64>, Vec<f64>) = points.iter().copied().unzip();
        require(&key(0, 0), strain[0] == 0.0, || format!("the first strain must be 0, found {}", strain[0]))?;
        for i in 0..n {
            let last = i.max(1) - 1;
            require(&key(0, i), i == 0 || strain[i] > strain[last], || {
                format!("point {}: the strain {} does not rise above {}", i + 1, strain[i], strain[last])
            })?;
            require(&key(1, i), stress[i] >= stress[last], || {
                let [from, to] = [stress[last], stress[i]].map(rounded);
                format!("point {}: the stress falls from {from} to {to} MPa", i + 1)
            })?;
        }
        let stress = if n > FEW { smoothed(&strain, &stress) } else { stress };
        let chord: Vec<f64> = (0..n - 1).map(|i| (stress[i + 1] - stress[i]) / (strain[i + 1] - strain[i])).collect();
        let slope = |i: usize| match (i, beyond) {
            (0, _) => chord[0],
            (i, Extrapolation::Hold) if i == n - 1 => 0.0,
            (i, Extrapolation::Slope) if i == n - 1 => chord[n - 2],
            _ if chord[i - 1] * chord[i] <= 0.0 => 0.0,
            _ => 2.0 * chord[i - 1] * chord[i] / (chord[i - 1] + chord[i]),
        };
        Ok(Self { slope: (0..n).map(slope).collect(), strain, stress, beyond })
    }

    pub fn example(factor: f64) -> Self {
        let points = [(0.0, 150.0), (0.02, 210.0), (0.1, 290.0), (0.3, 360.0), (0.8, 420.0)];
        Self::new(&points.map(|(strain, stress)| (strain, factor * stress)), Extrapolation::Slope).expect("valid")
    }

    pub fn last_strain(&self) -> f64 {
        self.strain[self.strain.len() - 1]
    }

    pub fn at(&self, strain: f64) -> FlowStress {
        let n = self.strain.len();
        let i = self.strain.partition_point(|&s| s <= strain);
        if i == n {
            let slope = self.slope[n - 1];
            return FlowStress { stress: self.stress[n - 1] + slope * (strain - self.strain[n - 1]), slope };
        }
        let (a, b) = (i.max(1) - 1, i.max(1));
        let h = self.strain[b] - self.strain[a];
        let x = (strain - self.strain[a]) / h;
        let rise = self.stress[b] - self.stress[a];
        let (sa, sb) = (h * self.slope[a], h * self.slope[b]);
        // Hermite cubic y = y_a + s_a x + c x² + d x³ on the unit interval.
        let (c, d) = (3.0 * rise - 2.0 * sa - sb, sa + sb - 2.0 * rise);
        let stress = self.stress[a] + x * (sa + x * (c + x * d));
        FlowStress { stress, slope: (sa + x * (2.0 * c + 3.0 * d * x)) / h }
    }
}

/// The stresses of points with scatter, put on the parabolas of their surroundings; they do not fall.
fn smoothed(strain: &[f64], stress: &[f64]) -> Vec<f64> {
    let mut last = 0.0;
    let at = |i: usize| {
        let reach = (REACH[0] * strain[i]).min(REACH[1]);
        let [from, to] = [strain[i] - reach, strain[i] + reach];
        let near = strain.partition_point(|s| *s < from)..strain.partition_point(|s| *s <= to);
        if near.len() < FIT {
            return stress[i];
        }
        let (mut normal, mut right) = (Matrix3::zeros(), Vector3::zeros());
        for k in near {
            let x = (strain[k] - strain[i]) / reach;
            let weight = (1.0 - x.abs().powi(3)).max(0.0).powi(3);
            let row = Vector3::new(1.0, x, x * x);
            normal += weight * row * row.transpose();
            right += weight * stress[k] * row;
        }
        normal.cholesky().map_or(stress[i], |normal| normal.solve(&right).x)
    };
    let rising = (0..strain.len()).map(|i| {
        last = at(i).max(last);
        last
    });
    rising.collect()
}

impl fmt::Display for Monotone {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let n = self.strain.len();
        let kept = if self.beyond == Extrapolation::Hold { "stress held" } else { "slope kept" };
        let (first, last, end) = (self.stress[0], self.stress[n - 1], self.last_strain());
        write!(
            f,
            "table of {n} points, {first:.1} MPa at ε = 0 to {last:.1} MPa at ε = {end}, beyond it the last {kept}"
        )
    }
}

/// Trust: the definition.
#[cfg(test)]
#[test]
fn the_curve_goes_through_its_points() {
    let curve = Monotone::example(1.0);
    for (strain, stress) in curve.strain.iter().zip(&curve.stress) {
        assert!((curve.at(*strain).stress - stress).abs() < 1e-9);
    }
}
