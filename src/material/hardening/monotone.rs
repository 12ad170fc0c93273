//! Interpolation of measured stress-strain points without overshoot.
//!
//! # References
//! F. N. Fritsch, R. E. Carlson, Monotone piecewise cubic interpolation, SIAM J. Numer. Anal. 17 (1980) 238–246;
//! slopes by the harmonic mean of F. N. Fritsch, J. Butland, SIAM J. Sci. Stat. Comput. 5 (1984) 300–304.

use super::flow_stress::FlowStress;
use crate::law::prelude::*;
use crate::units::rounded;
use std::fmt;

/// Beyond the last point of a table: a declared choice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "case", derive(serde::Deserialize), serde(rename_all = "snake_case"))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
    /// Points with rising strain from 0 and stress > 0 that does not fall.
    pub fn new(strain: Vec<f64>, stress: Vec<f64>, beyond: Extrapolation) -> Result<Self, LawError> {
        require("", strain.len() == stress.len() && strain.len() >= 2, || {
            format!(
                "needs at least two points, each with a strain and a stress; found {} strains and {} stresses",
                strain.len(),
                stress.len()
            )
        })?;
        require("strain.0", strain[0] == 0.0, || format!("the first strain must be 0, found {}", strain[0]))?;
        for i in 0..strain.len() {
            let (strain_key, stress_key) = (format!("strain.{i}"), format!("stress.{i}"));
            require(&stress_key, stress[i] > 0.0 && stress[i].is_finite(), || {
                format!("point {}: the stress must be positive, found {} MPa", i + 1, stress[i])
            })?;
            require(&strain_key, i == 0 || strain[i] > strain[i - 1], || {
                format!("point {}: the strain {} does not rise above {}", i + 1, strain[i], strain[i - 1])
            })?;
            require(&stress_key, i == 0 || stress[i] >= stress[i - 1], || {
                let [from, to] = [stress[i - 1], stress[i]].map(rounded);
                format!("point {}: the stress falls from {from} to {to} MPa", i + 1)
            })?;
        }
        let n = strain.len();
        let chord: Vec<f64> = (0..n - 1).map(|i| (stress[i + 1] - stress[i]) / (strain[i + 1] - strain[i])).collect();
        let slope = (0..n)
            .map(|i| match i {
                0 => chord[0],
                i if i == n - 1 => match beyond {
                    Extrapolation::Hold => 0.0,
                    Extrapolation::Slope => chord[n - 2],
                },
                i if chord[i - 1] * chord[i] <= 0.0 => 0.0,
                i => 2.0 * chord[i - 1] * chord[i] / (chord[i - 1] + chord[i]),
            })
            .collect();
        Ok(Self { strain, stress, slope, beyond })
    }

    /// The same of pairs of strain and stress, as a case writes them; errors are at `points`.
    pub fn of_pairs(pairs: impl Iterator<Item = (f64, f64)>, beyond: Extrapolation) -> Result<Self, LawError> {
        let (strain, stress) = pairs.unzip();
        Self::new(strain, stress, beyond).map_err(|error| {
            let key = match error.key.split_once('.') {
                Some(("strain", i)) => format!("points.{i}.0"),
                Some((_, i)) => format!("points.{i}.1"),
                None => error.key,
            };
            LawError { key, ..error }
        })
    }

    /// Five points of a steel, its stresses times `factor`.
    pub fn example(factor: f64) -> Self {
        let stress = [150.0, 210.0, 290.0, 360.0, 420.0].map(|stress| factor * stress);
        Self::new(vec![0.0, 0.02, 0.1, 0.3, 0.8], stress.to_vec(), Extrapolation::Slope).expect("valid")
    }

    pub fn beyond(&self) -> Extrapolation {
        self.beyond
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
        FlowStress {
            stress: self.stress[a] + x * (sa + x * (c + x * d)),
            slope: (sa + x * (2.0 * c + 3.0 * d * x)) / h,
        }
    }
}

impl fmt::Display for Monotone {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let n = self.strain.len();
        let beyond = match self.beyond {
            Extrapolation::Hold => "the last stress held",
            Extrapolation::Slope => "the last slope kept",
        };
        let (first, last, end) = (self.stress[0], self.stress[n - 1], self.last_strain());
        write!(f, "table of {n} points, {first:.1} MPa at ε = 0 to {last:.1} MPa at ε = {end}, beyond it {beyond}")
    }
}
