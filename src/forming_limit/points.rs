//! A measured curve.

use super::*;

/// Strains of a measured curve.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Strain {
    /// True strain.
    #[serde(alias = "true")]
    Logarithmic,
    /// Change of length over the initial length.
    Engineering,
}

impl Strain {
    /// The logarithmic strain; NaN for an engineering strain of −1 or less.
    pub fn logarithmic(self, value: f64) -> f64 {
        match self {
            Self::Logarithmic => value,
            Self::Engineering if value > -1.0 => value.ln_1p(),
            Self::Engineering => f64::NAN,
        }
    }
}

/// Points as they were measured.
#[derive(Clone, Debug, PartialEq)]
pub struct Points {
    /// Minor and major strain \[–\], from left to right.
    pub points: Vec<[f64; 2]>,
    /// How they are measured.
    pub strain: Strain,
}

impl Points {
    pub(super) fn curve(&self) -> Result<Curve, LawError> {
        let points: Vec<_> = self.points.iter().map(|point| point.map(|e| self.strain.logarithmic(e))).collect();
        // The comparisons are also false for NaN.
        let sound = |[minor, major]: &[f64; 2]| *major > 0.0 && *minor > -3.0 && minor <= major && *major < 3.0;
        if let Some(i) = points.iter().position(|point| !sound(point)) {
            let [minor, major] = self.points[i];
            let what = format!("point {} has the minor strain {minor} and the major strain {major}", i + 1);
            let help = "strains are plain numbers, 0.3 for 30 %, the minor one first and not above the major one, which is \
                        positive and below 3";
            return Err(LawError::new(what, help));
        }
        let measure = match self.strain {
            Strain::Logarithmic => "logarithmic as given",
            Strain::Engineering => "logarithmic from the engineering strains given",
        };
        Curve::new("Points", points, vec![format!("Forming limit: points of the case, {measure}.")])
    }
}
