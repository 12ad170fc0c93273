//! Text with a unit → checked number in solver units (mm, N, s, MPa, K, rad), and result numbers as text.
//!
//! A case file writes `"0.035 in"` or `"5.4 tonf_uk/in^2"`; the solver sees mm and MPa. The types here cannot hold a
//! wrong value: [`Length`] is a length, [`Positive<Length>`] is above zero, [`Fraction`] lies in 0..=1, and all are
//! finite and within [`Kind::largest`].
//!
//! ```
//! use stampflow::units::{Length, Positive, Dimensioned};
//! let thickness: Positive<Length> = "0.035 in".parse().unwrap();
//! assert!((thickness.value() - 0.889).abs() < 1e-12);
//! assert!("3 kN".parse::<Length>().is_err());
//! ```

mod amount;
mod dimension;
mod display;
mod gauge;
mod number;
mod parse;
mod quantity;
mod spelling;
mod types;
mod unit;

pub use amount::{Amount, Digits};
pub use dimension::{Dimension, ZERO_CELSIUS};
pub use display::{DisplaySettings, DisplayUnit};
pub use number::{joined, mm, rounded, significant, trimmed, without_zeros};
pub use parse::{Parsed, QuantityError, parse, thicknesses};
pub use quantity::{ErrorBar, Limits, Quantity, Sense};

pub use spelling::closest;
pub(crate) use spelling::did_you_mean;
pub use types::{
    Angle, As, Conductivity, Density, Dimensioned, Energy, Force, Fraction, HeatTransfer, Kind, Length, LineForce,
    NonNegative, Number, PerKelvin, Positive, Ratio, SpecificHeat, Speed, StrainRate, Stress, StressRate, Temperature,
    Time, UpToOne,
};
pub use unit::Unit;
