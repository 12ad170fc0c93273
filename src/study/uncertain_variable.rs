//! An uncertain variable: a key of the case with a distribution, or the strength of its sheet.

use super::StudyError;
use super::distribution::{Distribution, WrittenDistribution};
use super::variable::{Domain, Value, Variable, split_number};
use crate::case::Case;
use crate::material::chaboche;
use crate::units::{self, Dimensioned, Stress, significant};
use toml_edit::{InlineTable, Value as Toml};

/// Name of the factor on all stresses of the hardening law.
pub const STRENGTH: &str = "strength";

const HARDENING: &str = "material.hardening";

/// A key with a distribution.
#[derive(Clone, Debug)]
pub struct UncertainVariable {
    /// Dotted path of keys, or [`STRENGTH`].
    pub key: String,
    /// In its unit.
    pub distribution: Distribution,
    variable: Variable,
    /// The law that the strength scales.
    hardening: Option<Toml>,
}

impl UncertainVariable {
    /// Reads the distribution of a key.
    ///
    /// # Errors
    /// When that is no distribution, or asks for a value that the case does not write.
    pub fn new(case: &Case, key: &str, scatter: &str) -> Result<Self, StudyError> {
        let written = WrittenDistribution::read(key, scatter)?;
        let hardening = if key == STRENGTH { Some(hardening(case)?) } else { law_of_library(case, key) };
        let own = || if key == STRENGTH { Ok((1.0, String::new())) } else { own(case, key) };
        let (distribution, unit) = written.of(key, own)?;
        let variable = Variable { key: key.to_owned(), unit, domain: Domain::List(Vec::new()) };
        Ok(Self { key: key.to_owned(), distribution, variable, hardening })
    }

    /// The column of its values.
    pub fn header(&self) -> String {
        self.variable.header()
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
            law => law.iter().map(|law| format!("{HARDENING}={law}")).chain([self.variable.setting(value)]).collect(),
        }
    }

    /// Whether both set the same key.
    pub fn conflicts_with(&self, other: &Self) -> bool {
        self.key == other.key || self.key == STRENGTH && other.key.starts_with(HARDENING)
    }
}

/// The case's value of a key, with its unit.
fn own(case: &Case, key: &str) -> Result<(f64, String), StudyError> {
    let found = case.written(key);
    let wrong = |what: String| StudyError::new(what, "write the middle too: \"normal 1 ± 0.02 mm\"");
    let (path, text) = found.first().ok_or_else(|| wrong(format!("the case writes no {key} to scatter about")))?;
    if let Some((other, differs)) = found.iter().find(|(_, other)| other != text) {
        return Err(wrong(format!("the case has {text} at {path} and {differs} at {other}")));
    }
    let (number, unit) = split_number(text).ok_or_else(|| wrong(format!("{path} is no number in the case: {text}")))?;
    Ok((number, unit.to_owned()))
}

/// The law of a library sheet, which must be written into the case before one of its numbers can be changed.
fn law_of_library(case: &Case, key: &str) -> Option<Toml> {
    let is_own = case
        .text
        .parse::<toml_edit::DocumentMut>()
        .is_ok_and(|text| text.get("material").and_then(|material| material.get("hardening")).is_some());
    if is_own || !key.starts_with(HARDENING) { None } else { case.hardening() }
}

/// The hardening law with stresses that a factor can scale.
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
            let Some((number, unit)) = split_number(text.value()).filter(|_| is_stress(text.value())) else { return 0 };
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
