//! Ranges as types: a wrong value cannot be built.

use super::dimensioned::Dimensioned;
use super::error::QuantityError;
use super::kind::Kind;
use super::text;
use super::types::Number;

macro_rules! bounds {
    ($($(#[$doc:meta])* $type:ident: $ok:expr, $error:literal, $keyword:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
        pub struct $type<Q>(Q);

        impl<Q: Dimensioned> Dimensioned for $type<Q> {
            const KIND: &'static Kind = Q::KIND;
            const BOUND: &'static [(&'static str, f64)] = &[($keyword, 0.0)];

            fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
                let inner = Q::checked(value, found)?;
                let ok: fn(f64) -> bool = $ok;
                if ok(value) {
                    Ok(Self(inner))
                } else {
                    Err(QuantityError::wrong_sign($error, found, Q::KIND))
                }
            }

            fn value(self) -> f64 {
                self.0.value()
            }
        }
        text::implement!([Q: Dimensioned] $type<Q>);
    )*};
}

bounds! {
    /// A quantity above zero.
    Positive: |value| value > 0.0, "be positive", "exclusiveMinimum";
    /// A quantity of zero or above.
    NonNegative: |value| value >= 0.0, "not be negative", "minimum";
}

/// A plain number in 0..=1.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Fraction(f64);

impl Dimensioned for Fraction {
    const KIND: &'static Kind = Number::KIND;
    const BOUND: &'static [(&'static str, f64)] = &[("minimum", 0.0), ("maximum", 1.0)];

    fn checked(value: f64, found: &str) -> Result<Self, QuantityError> {
        if (0.0..=1.0).contains(&value) {
            Ok(Self(value))
        } else {
            Err(QuantityError::new(format!("must lie between 0 and 1, found {found}"), "it is a fraction, such as 0.1"))
        }
    }

    fn value(self) -> f64 {
        self.0
    }
}
text::implement!([] Fraction);
