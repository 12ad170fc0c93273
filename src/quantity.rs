//! Text with a unit → checked number in solver units (mm, N, s, MPa, K, rad).
//!
//! A case file writes `"0.035 in"` or `"5.4 tonf_uk/in^2"`; the solver sees mm and MPa. The types here cannot hold a
//! wrong value: [`Length`] is a length, [`Positive<Length>`] is above zero, [`Fraction`] lies in 0..=1, and all are
//! finite and within [`Kind::largest`].
//!
//! ```
//! use stampflow::quantity::{Length, Positive, Quantity};
//! let thickness: Positive<Length> = "0.035 in".parse().unwrap();
//! assert!((thickness.value() - 0.889).abs() < 1e-12);
//! assert!("3 kN".parse::<Length>().is_err());
//! ```

mod bounds;
mod error;
mod parse;
mod text;
mod unit;

pub use bounds::{Fraction, NonNegative, Positive};
pub use error::QuantityError;
pub(crate) use error::closest;
pub use parse::{Parsed, parse};
pub use unit::Dimension;

use unit::{ANGLE, FORCE, LENGTH, NONE, STRESS, TIME};

/// What a type of quantity is called, measured in and limited to.
#[derive(Debug, PartialEq)]
pub struct Kind {
    /// With its article, as in "a length".
    pub name: &'static str,
    pub dimension: Dimension,
    /// The solver's unit; empty for a plain number.
    pub unit: &'static str,
    /// How it may be written.
    pub examples: &'static [&'static str],
    /// Largest magnitude that makes sense, in `unit`; beyond it a unit is wrong.
    pub largest: f64,
}

/// A number whose dimension and range have been checked.
pub trait Quantity: Copy {
    const KIND: &'static Kind;

    /// Checks a number given in solver units.
    ///
    /// # Errors
    /// When it is not finite or out of range; `found` is quoted in the message.
    fn checked(value: f64, found: &str) -> Result<Self, QuantityError>;

    /// The number in the solver's unit ([`Kind::unit`]).
    fn value(self) -> f64;

    /// Further condition of the type, for schemas: a JSON-schema keyword and its bound.
    const BOUND: &'static [(&'static str, f64)] = &[];
}

macro_rules! quantities {
    ($($(#[$doc:meta])* $type:ident = $kind:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $type(f64);

        impl Quantity for $type {
            const KIND: &'static Kind = &$kind;

            fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
                let kind = Self::KIND;
                if value.is_finite() && value.abs() <= kind.largest {
                    Ok(Self(value))
                } else {
                    Err(QuantityError::TooLarge { found: found.into(), kind })
                }
            }

            fn value(self) -> f64 {
                self.0
            }
        }
        text::implement!([] $type);
    )*};
}

quantities! {
    /// Signed length \[mm\].
    Length = Kind { name: "a length", dimension: LENGTH, unit: "mm", examples: &["0.9 mm", "0.035 in"], largest: 1e5 };
    /// Stress \[MPa\].
    Stress = Kind {
        name: "a stress", dimension: STRESS, unit: "MPa", examples: &["210 GPa", "5.4 tonf_uk/in^2"], largest: 1e7,
    };
    /// Force \[N\].
    Force = Kind { name: "a force", dimension: FORCE, unit: "N", examples: &["80 kN", "5000 N"], largest: 1e9 };
    /// Force per length of depth \[N/mm\].
    LineForce = Kind {
        name: "a force per length", dimension: FORCE.over(LENGTH), unit: "N/mm",
        examples: &["1300 N/mm", "1300 kN/m"], largest: 1e7,
    };
    /// Angle \[rad\].
    Angle = Kind { name: "an angle", dimension: ANGLE, unit: "rad", examples: &["90 deg", "1.57 rad"], largest: 100.0 };
    /// Time \[s\].
    Time = Kind { name: "a time", dimension: TIME, unit: "s", examples: &["2 s", "30 ms"], largest: 1e9 };
    /// Speed \[mm/s\].
    Speed = Kind {
        name: "a speed", dimension: LENGTH.over(TIME), unit: "mm/s", examples: &["1 mm/s", "0.2 m/s"], largest: 1e6,
    };
    /// Strain rate \[1/s\].
    StrainRate = Kind {
        name: "a strain rate", dimension: NONE.over(TIME), unit: "/s", examples: &["0.001 /s", "40 /s"], largest: 1e9,
    };
    /// Rise of a pressure with time \[MPa/s\].
    StressRate = Kind {
        name: "a pressure per time", dimension: STRESS.over(TIME), unit: "MPa/s", examples: &["0.01 MPa/s", "0.5 MPa/min"],
        largest: 1e9,
    };
    /// Relative number, written in percent \[–\].
    Ratio = Kind { name: "a percentage", dimension: NONE, unit: "%", examples: &["5 %", "2.5 %"], largest: 1e3 };
    /// Plain number \[–\], written without quotes.
    Number = Kind { name: "a plain number", dimension: NONE, unit: "", examples: &["0.1"], largest: 1e12 };
}

/// Nine significant digits: more than anyone measures, and no binary noise at the end (31.4 mm, not
/// 31.400000000000002 mm).
pub fn rounded(value: f64) -> f64 {
    format!("{value:.8e}").parse::<f64>().map_or(value, |v| v + 0.0) // −0 becomes 0
}

#[cfg(test)]
mod tests;
