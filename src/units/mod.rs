//! Text with a unit → checked number in solver units (mm, N, s, MPa, K, rad), and result numbers as text.
//!
//! [`Length`] is a length, [`Positive<Length>`] above zero, [`Fraction`] in 0..=1; all within [`Kind::largest`].
//!
//! ```
//! use stampflow::units::{Length, Positive, Dimensioned};
//! let thickness: Positive<Length> = "0.035 in".parse().unwrap();
//! assert!((thickness.value() - 0.889).abs() < 1e-12);
//! assert!("3 kN".parse::<Length>().is_err());
//! ```

mod amount;
mod dimension;
mod number;
mod parse;
mod quantity;
mod types;
mod unit;

pub use amount::{Amount, Digits};
pub use dimension::{Dimension, ZERO_CELSIUS};
pub(crate) use number::capitalised;
pub use number::{closest, joined, rounded, rounded_up, significant, trimmed, without_zeros};
pub(crate) use number::{did_you_mean, shortened};
pub use parse::{Parsed, QuantityError, parse, thicknesses};
pub use quantity::{ErrorBar, Limits, Quantity, Sense};
pub use types::{
    Angle, As, Conductivity, Density, Dimensioned, Energy, Force, Fraction, HeatTransfer, Kind, Length, LineForce,
    NonNegative, Number, PerKelvin, Positive, Ratio, SpecificHeat, Speed, StrainRate, Stress, StressRate, Temperature,
    Time, UpToOne,
};
pub use unit::{DisplaySettings, DisplayUnit, Unit};
