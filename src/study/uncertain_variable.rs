//! An uncertain variable: a key of the case with a distribution, or the strength of its sheet.

use super::distribution::Distribution;
use super::variable::{number, split_number, split_pair, written};
use super::{StudyError, Variable, fail};
use crate::case::Case;
use crate::material::chaboche;
use crate::units::{self, Dimensioned, Stress, significant};
use toml_edit::Value;

pub(super) const STRENGTH: &str = "strength";

const HARDENING: &str = "material.hardening";

/// A key with a distribution, or [`STRENGTH`].
#[derive(Clone, Debug)]
pub(super) struct UncertainVariable {
    pub variable: Variable,
    distribution: Distribution,
    /// The law that the strength scales, or that must be written into the case before one of its numbers can be changed.
    hardening: Option<Value>,
}

impl UncertainVariable {
    /// Reads `KEY=DISTRIBUTION`.
    pub fn read(case: &Case, text: &str) -> Result<Self, StudyError> {
        let help = "write KEY=DISTRIBUTION, such as \"friction=uniform 0.05..0.12\"";
        let Some((key, distribution)) = split_pair(text) else {
            return fail(format!("`{text}` gives no key a distribution"), help);
        };
        let is_strength = key == STRENGTH;
        let own = || if is_strength { Ok((1.0, String::new())) } else { own_value(case, key) };
        let (distribution, unit) = Distribution::read(key, distribution, own)?;
        let hardening = if is_strength { Some(scalable_law(case)?) } else { library_law(case, key) };
        Ok(Self { variable: Variable::new(key, unit), distribution, hardening })
    }

    /// Its value at a coordinate between 0 and 1.
    pub fn value(&self, coordinate: f64) -> String {
        written(self.distribution.quantile(coordinate))
    }

    /// The overrides that set a value.
    pub fn settings(&self, value: &str) -> Vec<String> {
        let law = |law: &Value| format!("{HARDENING}={law}");
        match &self.hardening {
            Some(own) if self.variable.key == STRENGTH => {
                let mut scaled = own.clone();
                scale(&mut scaled, number(value).unwrap_or(1.0));
                vec![law(&scaled)]
            }
            own => own.iter().map(law).chain([self.variable.setting(value)]).collect(),
        }
    }

    /// Whether both set the same key.
    pub fn conflicts_with(&self, other: &Self) -> bool {
        let (own, other) = (&self.variable.key, &other.variable.key);
        own == other || own == STRENGTH && other.starts_with(HARDENING)
    }
}

fn own_value(case: &Case, key: &str) -> Result<(f64, String), StudyError> {
    let all = case.written(key);
    let wrong = |what: String| StudyError::new(what, "write the middle too: \"normal 1 ± 0.02 mm\"");
    let (path, text) = all.first().ok_or_else(|| wrong(format!("the case writes no {key} to scatter about")))?;
    if let Some((other, differs)) = all.iter().find(|(_, other)| other != text) {
        return Err(wrong(format!("the case has {text} at {path} and {differs} at {other}")));
    }
    let (number, unit) = split_number(text).ok_or_else(|| wrong(format!("{path} is no number in the case: {text}")))?;
    Ok((number, unit.to_owned()))
}

fn library_law(case: &Case, key: &str) -> Option<Value> {
    let text = case.text.parse::<toml_edit::DocumentMut>();
    let is_own = text.is_ok_and(|text| text.get("material").and_then(|material| material.get("hardening")).is_some());
    case.hardening().filter(|_| !is_own && key.starts_with(HARDENING))
}

fn scalable_law(case: &Case) -> Result<Value, StudyError> {
    let wrong = |what: &str| {
        let help = "vary the law's own numbers: \"material.hardening.swift.k=normal ± 5 %\"";
        fail(format!("{STRENGTH}: {what}"), help)
    };
    match case.hardening() {
        _ if chaboche::shifting(case.model().material.chaboche).is_some() => {
            wrong("the sheet has back-stresses, which are not of its hardening law")
        }
        None => wrong("the case writes no hardening law"),
        Some(law) if scale(&mut law.clone(), 1.0) == 0 => wrong("the hardening law has no stresses in the case's text"),
        Some(law) => Ok(law),
    }
}

/// Multiplies all stresses in a value; returns how many there are.
fn scale(value: &mut Value, factor: f64) -> usize {
    match value {
        Value::InlineTable(table) => table.iter_mut().map(|(_, value)| scale(value, factor)).sum(),
        Value::Array(array) => array.iter_mut().map(|item| scale(item, factor)).sum(),
        Value::String(text) => {
            let is_stress = units::parse(text.value()).is_ok_and(|x| x.dimension == Stress::KIND.dimension);
            let Some((number, unit)) = split_number(text.value()).filter(|_| is_stress) else { return 0 };
            *value = format!("{} {unit}", significant(number * factor, 12)).into();
            1
        }
        _ => 0,
    }
}
