//! Common ground of all laws: hardening, rate, thermal softening, friction.
//!
//! A law is one file: a struct of its `parameters!`, whose documentation says equation, range of validity and source, read
//! with units and described in the JSON schema. It joins its `family!` by two lines: `mod swift;` and `swift: Swift`.
//! Whatever must hold for all of them is tested over the family's `examples()`.

mod macros;

pub(crate) use macros::{family, parameters};

/// Why a set of parameters is not a law.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct LawError {
    /// Cause.
    pub message: String,
    /// The key that is wrong, as a path inside the law's table, entries by index from 0; empty for the whole law.
    pub key: String,
    /// Remedy.
    pub help: &'static str,
}

impl LawError {
    /// Error of the whole law.
    pub fn new(message: impl Into<String>, help: &'static str) -> Self {
        Self { message: message.into(), key: String::new(), help }
    }
}

/// Law with numbers in common use, those of the schema's examples.
pub(crate) trait Example {
    fn example() -> Self;
}

pub(crate) mod prelude {
    pub use super::LawError;
    pub(crate) use super::{Example, family, parameters, require, require_or, require_range};
    pub use crate::numerics::ValueAndSlope;
    pub use crate::units::{As, Energy, Fraction, Length, PerKelvin, Speed, StrainRate, Temperature};
    pub use crate::units::{Dimensioned, NonNegative, Number, Positive, Stress, ZERO_CELSIUS, rounded};

    /// The default of a factor or an exponent.
    pub fn one() -> f64 {
        1.0
    }
}

pub(crate) fn require(key: &str, ok: bool, message: impl FnOnce() -> String) -> Checked {
    require_or(key, ok, "check the constants and their units", message)
}

type Checked = Result<(), LawError>;

pub(crate) fn require_or(key: &str, ok: bool, help: &'static str, message: impl FnOnce() -> String) -> Checked {
    if ok { Ok(()) } else { Err(LawError { message: message(), key: key.to_owned(), help }) }
}

/// Checks that a parameter lies in a range; it is named by its key in the law's table and by its key in messages.
pub(crate) fn require_range([key, name]: [&str; 2], value: f64, [low, high]: [f64; 2], help: &'static str) -> Checked {
    let what = || format!("`{name}` must lie between {low} and {high}, found {value}");
    require_or(key, (low..=high).contains(&value), help, what)
}

/// Laws of one kind, of which a case names one. Made by `family!`.
pub trait Family: Sized {
    /// Table of a case that names a law with its parameters.
    type Table;
    /// The laws that a case can name, in the order of the family.
    const NAMES: &'static [&'static str];

    /// Key of the law in case files.
    fn name(&self) -> &'static str;

    /// The laws that a table names.
    fn named(table: Self::Table) -> Vec<Self>;

    /// Law made ready for use after it was read; `young` is Young's modulus of the sheet where it is known \[MPa\].
    /// Fails when its parameters do not go together; the range of each was checked when it was read.
    fn prepared(self, young: Option<f64>) -> Result<Self, LawError>;
}

pub(crate) fn one_of(table: &mut schemars::Schema) {
    let laws = table.get_mut("properties").and_then(|laws| laws.as_object_mut());
    laws.into_iter().flat_map(|laws| laws.values_mut()).for_each(|law| *law = law["anyOf"][0].take());
    for key in ["minProperties", "maxProperties"] {
        table.insert(key.to_owned(), 1.into());
    }
}
