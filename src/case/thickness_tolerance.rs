//! Thickness tolerances of sheet by standards.

/// A standard of tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standard {
    /// Cold-rolled steel with less than 260 MPa of specified yield stress, normal tolerances, up to 1200 mm wide.
    En10131,
    /// Cold-rolled aluminium of alloy group II, up to 1000 mm wide.
    En485,
}

/// Thickness up to which \[mm\], and its tolerance to either side \[mm\].
///
/// # References
/// EN 10131:2006, table 1, as a mill's data sheet prints it (Tata Steel, tatasteeleurope.com/ts/node/4606; the standard itself
/// not read).
const EN_10131: [(f64, f64); 9] = [
    (0.40, 0.03),
    (0.60, 0.03),
    (0.80, 0.04),
    (1.00, 0.05),
    (1.20, 0.06),
    (1.60, 0.08),
    (2.00, 0.10),
    (2.50, 0.12),
    (3.00, 0.15),
];

/// The least thickness of that table \[mm\].
const EN_10131_FROM: f64 = 0.35;

/// Likewise.
///
/// # References
/// EN 485-4:1993, table 1, as an excerpt of BS EN 485-4:1994 prints it (pdfcoffee.com; the standard itself not read).
const EN_485: [(f64, f64); 12] = [
    (0.4, 0.03),
    (0.5, 0.03),
    (0.6, 0.04),
    (0.8, 0.04),
    (1.0, 0.05),
    (1.2, 0.05),
    (1.5, 0.07),
    (1.8, 0.08),
    (2.0, 0.09),
    (2.5, 0.10),
    (3.0, 0.11),
    (3.5, 0.12),
];

/// The least thickness of that table \[mm\].
const EN_485_FROM: f64 = 0.2;

impl Standard {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::En10131, Self::En485];

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
                "EN 10131:2006, normal tolerances, up to 1200 mm wide, as a mill's data sheet prints them (tatasteeleurope.com; \
                 the standard itself not read)"
            }
            Self::En485 => {
                "EN 485-4:1993, alloy group II, up to 1000 mm wide, as an excerpt of it prints them (pdfcoffee.com; the standard \
                 itself not read)"
            }
        }
    }

    /// The tolerance of a thickness to either side \[mm\]; `None` of one that the standard does not have.
    pub fn tolerance(self, thickness: f64) -> Option<f64> {
        let (table, from): (&[(f64, f64)], f64) = match self {
            Self::En10131 => (&EN_10131, EN_10131_FROM),
            Self::En485 => (&EN_485, EN_485_FROM),
        };
        let row = table.iter().find(|(up_to, _)| thickness <= *up_to)?;
        (thickness >= from).then_some(row.1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: rows of the tables.
    #[test]
    fn a_thickness_has_the_tolerance_of_its_row() {
        for (standard, thickness, tolerance) in [
            (Standard::En10131, 0.8, Some(0.04)),
            (Standard::En10131, 0.81, Some(0.05)),
            (Standard::En10131, 1.0, Some(0.05)),
            (Standard::En10131, 0.3, None),
            (Standard::En10131, 3.5, None),
            (Standard::En485, 1.0, Some(0.05)),
            (Standard::En485, 1.3, Some(0.07)),
        ] {
            assert_eq!(standard.tolerance(thickness), tolerance, "{} {thickness}", standard.name());
        }
    }
}
