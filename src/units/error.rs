//! Why a text is not the quantity that is wanted.

use super::kind::Kind;
use super::spelling::closest;
use super::unit::{Dimension, UNITS, find, meant, told};

/// Why a text is not a quantity. The message's first line says what is wrong, the second what to write.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QuantityError {
    /// The text does not begin with a number.
    #[error("no number in {found:?}\nwrite a number and a unit, such as \"0.9 mm\"")]
    NoNumber {
        /// The text that was read.
        found: String,
    },
    /// The number is written with a decimal comma.
    #[error("decimal comma in {found:?}\nwrite a point: \"{point}\"")]
    DecimalComma {
        /// The text that was read.
        found: String,
        /// The same with a point.
        point: String,
    },
    /// The number has no unit, and the kind needs one.
    #[error("{found} needs a unit\nwrite \"{}\"; {} may also be written {}", .kind.with_unit(.found), .kind.name, .kind.written())]
    MissingUnit {
        /// The text that was read.
        found: String,
        /// The kind of quantity that is wanted.
        kind: &'static Kind,
    },
    /// A unit that is not known.
    #[error("unknown unit `{unit}` in {found:?}\n{}", known(.closest))]
    UnknownUnit {
        /// The text that was read.
        found: String,
        /// The unit.
        unit: String,
        /// Known units that are spelled alike, nearest first.
        closest: Vec<&'static str>,
    },
    /// Sheet thicknesses, where nothing says how thick the sheet is.
    #[error("{found:?} are thicknesses of the sheet, and here no sheet is known\nwrite a length, such as \"6 mm\"")]
    Thicknesses {
        /// The text that was read.
        found: String,
    },
    /// Sheet thicknesses, where a force is wanted.
    #[error(
        "{found:?} are thicknesses of the sheet, wanted {}\n\
         t is thicknesses of the sheet here: write {tonnes} tonf (tonnes-force) or {kilonewtons:.0} kN",
        .kind.name
    )]
    Tonnes {
        /// The text that was read.
        found: String,
        /// Its number.
        tonnes: f64,
        /// So many tonnes-force \[kN\].
        kilonewtons: f64,
        /// The kind of quantity that is wanted.
        kind: &'static Kind,
    },
    /// A gauge of no named metal.
    #[error(
        "{found:?} is {steel:.3} mm of steel and {aluminium:.3} mm of aluminium\n\
         write \"{gauge} ga_steel\" (Manufacturers' Standard Gauge) or \"{gauge} ga_al\" (Brown & Sharpe)"
    )]
    GaugeOfWhat {
        /// The text that was read.
        found: String,
        /// The gauge.
        gauge: usize,
        /// Thickness in steel \[mm\].
        steel: f64,
        /// Thickness in aluminium \[mm\].
        aluminium: f64,
    },
    /// A number that is no gauge.
    #[error(
        "{found:?} is no gauge of sheet\ngauges are whole numbers from {from} to {to}; else write the thickness in mm or in"
    )]
    NoGauge {
        /// The text that was read.
        found: String,
        /// The heaviest gauge.
        from: usize,
        /// The thinnest gauge.
        to: usize,
    },
    /// The units are not joined as they may be.
    #[error(
        "{found:?} cannot be read from {at:?} on\nunits are joined by * and /, powers written ^2: \"5.4 tonf_uk/in^2\""
    )]
    Malformed {
        /// The text that was read.
        found: String,
        /// What could not be read, to the end of the text.
        at: String,
    },
    /// The unit measures something else.
    #[error("{found:?} is {}, wanted {}\nwrite for example {}", .is.describe(), .kind.name, .kind.written())]
    WrongDimension {
        /// The text that was read.
        found: String,
        /// What it measures.
        is: Dimension,
        /// The kind of quantity that is wanted.
        kind: &'static Kind,
    },
    /// The magnitude makes no sense.
    #[error("{found} is out of range for {}\nits magnitude must be at most {} {}: check the unit", .kind.name, .kind.largest, .kind.unit)]
    TooLarge {
        /// The text that was read.
        found: String,
        /// The kind of quantity that is wanted.
        kind: &'static Kind,
    },
    /// The number must be positive.
    #[error("must be positive, found {found}\nwrite for example {}", .kind.written())]
    NotPositive {
        /// The text that was read.
        found: String,
        /// The kind of quantity that is wanted.
        kind: &'static Kind,
    },
    /// The number must not be negative.
    #[error("must not be negative, found {found}\nwrite for example {}", .kind.written())]
    Negative {
        /// The text that was read.
        found: String,
        /// The kind of quantity that is wanted.
        kind: &'static Kind,
    },
    /// The number is no share of a whole.
    #[error("must lie between 0 and 1, found {found}\nit is a fraction, such as 0.1")]
    NotFraction {
        /// The text that was read.
        found: String,
    },
}

impl QuantityError {
    pub(super) fn tonnes(found: &str, tonnes: f64, kind: &'static Kind) -> Self {
        let newtons = find("tonf").map_or(f64::NAN, |unit| unit.1);
        Self::Tonnes { found: found.into(), tonnes, kilonewtons: 1e-3 * tonnes * newtons, kind }
    }

    pub(super) fn unknown_unit(found: &str, unit: &str) -> Self {
        let mut meant = meant(unit);
        if meant.is_empty() {
            meant = closest(unit, UNITS.iter().map(|known| known.0));
        }
        let closest = meant;
        Self::UnknownUnit { found: found.into(), unit: unit.into(), closest }
    }
}

fn known(closest: &[&str]) -> String {
    if closest.is_empty() {
        let all: Vec<&str> = UNITS.iter().map(|unit| unit.0).collect();
        format!("known units: {}", all.join(", "))
    } else {
        format!("did you mean {}?", closest.iter().map(|c| told(c)).collect::<Vec<_>>().join(" or "))
    }
}
