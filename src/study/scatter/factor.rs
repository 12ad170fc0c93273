//! One thing that scatters: a key of the case, or the strength of its sheet.

use super::StudyError;
use super::distribution::{Distribution, Written};
use crate::case::Case;
use crate::material::chaboche;
use crate::study::vary::split;
use crate::study::{Value, Vary};
use crate::units::{self, Dimensioned, Stress, significant};
use toml_edit::{InlineTable, Value as Toml};

/// What the factor on all stresses of the hardening law is called.
pub const STRENGTH: &str = "strength";

/// Where a law of hardening stands.
const HARDENING: &str = "material.hardening";

/// A key that scatters.
#[derive(Clone, Debug)]
pub struct Factor {
    /// Dotted path of keys, or [`STRENGTH`].
    pub key: String,
    /// In its unit.
    pub distribution: Distribution,
    vary: Vary,
    /// The law that the strength is of.
    hardening: Option<Toml>,
}

impl Factor {
    /// Reads `KEY=DISTRIBUTION` into the key and the distribution.
    ///
    /// # Errors
    /// When either is missing.
    pub fn split(text: &str) -> Result<(&str, &str), StudyError> {
        let sides = text.split_once('=').map(|(key, scatter)| (key.trim(), scatter.trim()));
        sides.filter(|(key, scatter)| !key.is_empty() && !scatter.is_empty()).ok_or_else(|| {
            let help = "write KEY=DISTRIBUTION, such as \"friction=uniform 0.05..0.12\"";
            StudyError::new(format!("`{text}` says of no key how it scatters"), help)
        })
    }

    /// Of a case, its key and how that scatters.
    ///
    /// # Errors
    /// When that is no distribution, or asks for a value that the case does not write.
    pub fn new(case: &Case, key: &str, scatter: &str) -> Result<Self, StudyError> {
        let written = Written::read(key, scatter)?;
        let hardening = if key == STRENGTH { Some(hardening(case)?) } else { law_of_library(case, key) };
        let own = || if key == STRENGTH { Ok((1.0, String::new())) } else { own(case, key) };
        let (distribution, unit) = written.of(key, own)?;
        let vary = Vary { key: key.to_owned(), unit, values: Vec::new() };
        Ok(Self { key: key.to_owned(), distribution, vary, hardening })
    }

    /// The column of its values.
    pub fn header(&self) -> String {
        self.vary.header()
    }

    /// Its value at a coordinate between 0 and 1.
    pub fn value(&self, coordinate: f64) -> Value {
        Value::number(self.distribution.quantile(coordinate))
    }

    /// The overrides that set a value.
    pub fn settings(&self, value: &Value) -> Vec<String> {
        match &self.hardening {
            Some(law) if self.key == STRENGTH => {
                let mut scaled = law.clone();
                scale(&mut scaled, value.number.unwrap_or(1.0));
                vec![format!("{HARDENING}={scaled}")]
            }
            law => law.iter().map(|law| format!("{HARDENING}={law}")).chain([self.vary.setting(value)]).collect(),
        }
    }

    /// Whether it cannot scatter beside another one, for both set the same.
    pub fn is_at_odds_with(&self, other: &Self) -> bool {
        self.key == other.key || self.key == STRENGTH && other.key.starts_with(HARDENING)
    }
}

/// The value that the case writes at a key, with its unit.
fn own(case: &Case, key: &str) -> Result<(f64, String), StudyError> {
    let found = case.written(key);
    let wrong = |what: String| StudyError::new(what, "write the middle too: \"normal 1 ± 0.02 mm\"");
    let (path, text) = found.first().ok_or_else(|| wrong(format!("the case writes no {key} to scatter about")))?;
    if let Some((other, differs)) = found.iter().find(|(_, other)| other != text) {
        return Err(wrong(format!("the case has {text} at {path} and {differs} at {other}")));
    }
    let (number, unit) = split(text).ok_or_else(|| wrong(format!("{path} is no number in the case: {text}")))?;
    Ok((number, unit.to_owned()))
}

/// The law of a sheet of the library, which stands in the case before one of its numbers can be changed.
fn law_of_library(case: &Case, key: &str) -> Option<Toml> {
    let is_own = case
        .text
        .parse::<toml_edit::DocumentMut>()
        .is_ok_and(|text| text.get("material").and_then(|material| material.get("hardening")).is_some());
    if is_own || !key.starts_with(HARDENING) { None } else { case.hardening() }
}

/// The law whose stresses a strength can be multiplied with.
fn hardening(case: &Case) -> Result<Toml, StudyError> {
    let wrong = |what: &str| {
        let help = "vary the law's own numbers: \"material.hardening.swift.k=normal ± 5 %\"";
        StudyError::new(format!("{STRENGTH}: {what}"), help)
    };
    if chaboche::shifting(case.model().material.chaboche).is_some() {
        return Err(wrong("the sheet has back-stresses, which are not of its hardening law"));
    }
    let law = case.hardening().ok_or_else(|| wrong("the case writes no hardening law"))?;
    match scale(&mut law.clone(), 1.0) {
        0 => Err(wrong("the hardening law has no stresses in the case's text")),
        _ => Ok(law),
    }
}

/// Multiplies all stresses in a value; returns how many there are.
fn scale(value: &mut Toml, factor: f64) -> usize {
    match value {
        Toml::InlineTable(table) => in_table(table, factor),
        Toml::Array(array) => array.iter_mut().map(|item| scale(item, factor)).sum(),
        Toml::String(text) => {
            let is_stress =
                |text: &str| units::parse(text).is_ok_and(|found| found.dimension == Stress::KIND.dimension);
            let Some((number, unit)) = split(text.value()).filter(|_| is_stress(text.value())) else { return 0 };
            let scaled = format!("{} {unit}", significant(number * factor, 12));
            *value = scaled.into();
            1
        }
        _ => 0,
    }
}

fn in_table(table: &mut InlineTable, factor: f64) -> usize {
    table.iter_mut().map(|(_, value)| scale(value, factor)).sum()
}
