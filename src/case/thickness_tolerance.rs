//! Thickness tolerances of sheet by standards.

/// Standard of thickness tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Deserialize)]
pub enum Standard {
    /// Cold-rolled steel with less than 260 MPa of specified yield stress, normal tolerances, up to 1200 mm wide.
    #[serde(rename = "EN 10131")]
    En10131,
    /// Cold-rolled aluminium of alloy group II, up to 1000 mm wide.
    #[serde(rename = "EN 485-4")]
    En485,
}

/// Thicknesses up to which a row of a standard goes, and its tolerances to either side \[mm\].
type Rows = [&'static [f64]; 2];
const EN_10131: Rows =
    [&[0.4, 0.6, 0.8, 1.0, 1.2, 1.6, 2.0, 2.5, 3.0], &[0.03, 0.03, 0.04, 0.05, 0.06, 0.08, 0.10, 0.12, 0.15]];
const EN_485: Rows = [
    &[0.4, 0.5, 0.8, 1.2, 1.5, 1.8, 2.0, 2.5, 3.0, 3.5],
    &[0.03, 0.03, 0.04, 0.05, 0.07, 0.08, 0.09, 0.10, 0.11, 0.12],
];

impl Standard {
    /// Name of the standard.
    pub fn name(self) -> &'static str {
        match self {
            Self::En10131 => "EN 10131",
            Self::En485 => "EN 485-4",
        }
    }

    /// Source of its numbers.
    pub fn source(self) -> &'static str {
        match self {
            Self::En10131 => {
                "EN 10131:2006, table 1, normal tolerances, up to 1200 mm wide, as a mill's data sheet prints them \
                 (tatasteeleurope.com; the standard itself not read)"
            }
            Self::En485 => {
                "EN 485-4:1993, table 1, alloy group II, up to 1000 mm wide, as an excerpt of it prints them (pdfcoffee.com; the \
                 standard itself not read)"
            }
        }
    }

    /// Tolerance of a thickness to either side \[mm\]; `None` if the standard does not have it.
    pub fn tolerance(self, thickness: f64) -> Option<f64> {
        let ([up_to, tolerances], least) = match self {
            Self::En10131 => (EN_10131, 0.35),
            Self::En485 => (EN_485, 0.2),
        };
        let row = up_to.iter().position(|most| thickness <= *most)?;
        (thickness >= least).then_some(tolerances[row])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: rows of the tables.
    #[test]
    fn a_thickness_has_the_tolerance_of_its_row() {
        let tolerance = |standard: Standard, places: [f64; 4]| places.map(|t| standard.tolerance(t));
        assert_eq!(tolerance(Standard::En10131, [0.8, 0.81, 0.3, 3.5]), [Some(0.04), Some(0.05), None, None]);
        assert_eq!(tolerance(Standard::En485, [1.0, 1.3, 0.6, 0.55]), [Some(0.05), Some(0.07), Some(0.04), Some(0.04)]);
    }
}
