//! A key of a case that is fitted: where to begin and between what.
//!
//! ```text
//! KEY=START in LOW..HIGH UNIT      tools.punch.friction=0.1 in 0.01..0.3      material.hardening.swift.k=500 in 300..800 MPa
//! ```

use crate::study::vary::{known, pointed, split};
use crate::study::{StudyError, Value, Vary};

/// A key of a case and the values that it may have.
#[derive(Clone, Debug, PartialEq)]
pub struct Range {
    /// Dotted path of keys, as an override has it; several that have the same value are joined by `&`.
    pub key: String,
    /// Unit of the values; empty for plain numbers.
    pub unit: String,
    /// Where to begin.
    pub start: f64,
    /// Least value.
    pub low: f64,
    /// Largest value.
    pub high: f64,
}

const USAGE: &str = "write KEY=START in LOW..HIGH UNIT, such as \"material.hardening.swift.k=500 in 300..800 MPa\"";

impl Range {
    /// Reads `KEY=START in LOW..HIGH UNIT`.
    ///
    /// # Errors
    /// When something is missing, the ends do not rise, the start lies outside, or units differ.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let pair = text.split_once('=').map(|(key, values)| (key.trim(), values.trim()));
        let (key, values) = pair
            .filter(|(key, values)| !key.is_empty() && !values.is_empty())
            .ok_or_else(|| StudyError::new(format!("`{}` gives no key a range", text.trim()), USAGE))?;
        Self::of(key, values)
    }

    /// Of a key and `START in LOW..HIGH UNIT`.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn of(key: &str, values: &str) -> Result<Self, StudyError> {
        let wrong = |what: &str| StudyError::new(format!("{key}: `{values}` {what}"), USAGE);
        let (start, range) =
            values.split_once(" in ").ok_or_else(|| wrong("does not say where to begin and between what"))?;
        let (low, high) = range.split_once("..").ok_or_else(|| wrong("has no range LOW..HIGH"))?;
        Self::made(key, [start, low, high].map(str::trim), &wrong)
    }

    /// Of a key and the texts of start, low and high: `["500 MPa", "300 MPa", "800 MPa"]`.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn of_three(key: &str, texts: [&str; 3]) -> Result<Self, StudyError> {
        let shown = texts.join(", ");
        Self::made(key, texts, &|what: &str| {
            StudyError::new(format!("{key}: [{shown}] {what}"), "write [START, LOW, HIGH]")
        })
    }

    fn made(key: &str, texts: [&str; 3], wrong: &dyn Fn(&str) -> StudyError) -> Result<Self, StudyError> {
        texts.iter().try_for_each(|text| pointed(key, text))?;
        let numbers = texts.map(split);
        let [Some((start, a)), Some((low, b)), Some((high, unit))] = numbers else {
            return Err(wrong("is not made of numbers"));
        };
        if [a, b].iter().any(|other| !other.is_empty() && *other != unit) {
            return Err(wrong("has two units"));
        }
        known(key, unit)?;
        if low >= high {
            return Err(wrong(&format!("does not rise from {low} to {high}")));
        }
        if !(low..=high).contains(&start) {
            return Err(wrong(&format!("begins at {start}, outside of {low} to {high}")));
        }
        Ok(Self { key: key.into(), unit: unit.into(), start, low, high })
    }

    /// The overrides that give it a value.
    pub fn settings(&self, value: f64) -> Vec<String> {
        let of = |key: &str| Vary { key: key.trim().to_owned(), unit: self.unit.clone(), values: Vec::new() };
        self.key.split('&').map(|key| of(key).setting(&Value::number(value))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: by hand.
    #[test]
    fn ranges_read_as_they_are_said() {
        let range = Range::read("a.k = 500 in 300 .. 800 MPa").expect("a range");
        assert_eq!(range.settings(512.5), ["a.k=512.5 MPa"]);
        assert_eq!((range.start, range.low, range.high), (500.0, 300.0, 800.0));
        assert_eq!(Range::of_three("a.k", ["500 MPa", "300 MPa", "800 MPa"]).expect("a range"), range);
        let both = Range::read("a.f & b.f=0.1 in 0..0.3").expect("a range");
        assert_eq!(both.settings(0.2), ["a.f=0.2", "b.f=0.2"]);
    }

    /// Trust: each is wrong in the way that its message says.
    #[test]
    fn what_is_no_range_is_told() {
        for (text, said) in [
            ("friction", "gives no key a range"),
            ("f=0.1..0.3", "where to begin"),
            ("f=0.1 in 0.3", "has no range"),
            ("f=0.1 in 0.3..0.2", "does not rise"),
            ("f=0.5 in 0.1..0.3", "outside of 0.1 to 0.3"),
            ("k=500 GPa in 300..800 MPa", "two units"),
            ("k=500 in 300..800 MPq", "MPq"),
            ("k=a in 300..800", "not made of numbers"),
        ] {
            let error = Range::read(text).expect_err(text).to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
    }
}
