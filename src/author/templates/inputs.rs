//! Options of templates and their values.

use super::*;
use crate::units::{
    Angle, Dimensioned, Force, Fraction, Length, NonNegative, Number, Positive, QuantityError, Ratio, Stress,
    thicknesses,
};
use serde::Serialize;
use std::{collections::BTreeMap, str::FromStr};

/// Option of a template.
#[derive(Clone, Debug, Deserialize, Serialize)]
pub struct Choice {
    /// Name, without dashes in front.
    pub key: String,
    /// Kind of its value, as in help texts: LENGTH, FEED, STRESS, ANGLE, FORCE, PERCENT, NUMBER, FRACTION, SWITCH or NAME.
    pub value: String,
    /// Default value, or in words the rule that picks it.
    pub default: String,
    /// Description in one line.
    pub about: String,
    /// Option that takes the diameter in place of this radius, or the whole width in place of the half.
    pub diameter: Option<String>,
}

impl Choice {
    /// Names of the option: its own and that of the diameter.
    pub fn keys(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.key.as_str()).chain(self.diameter.as_deref())
    }

    fn read(&self, text: &str) -> Result<f64, QuantityError> {
        fn number<Q: Dimensioned + FromStr<Err = QuantityError>>(text: &str) -> Result<f64, QuantityError> {
            text.parse::<Q>().map(Dimensioned::value)
        }
        match self.value.as_str() {
            "LENGTH" => number::<Positive<Length>>(text),
            "FEED" => number::<NonNegative<Length>>(text),
            "STRESS" => number::<Positive<Stress>>(text),
            "ANGLE" => number::<Positive<Angle>>(text),
            "FORCE" => number::<Positive<Force>>(text),
            "PERCENT" => number::<NonNegative<Ratio>>(text),
            "NUMBER" => number::<NonNegative<Number>>(text),
            "FRACTION" => number::<Fraction>(text),
            "SWITCH" => match text {
                "yes" | "true" => Ok(1.0),
                "no" | "false" => Ok(0.0),
                _ => {
                    let what = format!("{text:?} is neither yes nor no");
                    Err(QuantityError { what, help: String::new(), with_point: None })
                }
            },
            _ => Ok(0.0),
        }
    }
}

const THICKNESS: &str = "thickness";

pub(in crate::author) struct Inputs {
    options: Vec<Choice>,
    /// Name under which an option was given, text and number, by key.
    given: BTreeMap<String, (String, String, f64)>,
}

impl Inputs {
    pub fn of_sheet() -> Self {
        Self { options: SHEET.0.clone(), given: BTreeMap::new() }
    }

    pub fn read(template: &Template, given: &[(&str, &str)]) -> Result<Self, CaseError> {
        let mut inputs = Self { options: template.options().cloned().collect(), given: BTreeMap::new() };
        // Other lengths may be multiples of the thickness.
        let (first, rest): (Vec<_>, Vec<_>) = given.iter().partition(|(key, _)| *key == THICKNESS);
        first.into_iter().chain(rest).try_for_each(|(key, text)| inputs.add(template.name, key, text))?;
        Ok(inputs)
    }

    fn add(&mut self, template: &str, key: &str, text: &str) -> Result<(), CaseError> {
        let Some(choice) = self.options.iter().find(|choice| choice.keys().any(|known| known == key)) else {
            let all: Vec<String> = self.options.iter().flat_map(Choice::keys).map(|key| format!("--{key}")).collect();
            let meant = did_you_mean(&format!("--{key}"), all.iter().map(String::as_str));
            let what = format!("the template {template} has no option --{key}");
            return Err(CaseError::bare(what, format!("{meant}it has {}", all.join(", "))));
        };
        let multiple = thicknesses(text).filter(|_| choice.value == "LENGTH" && key != THICKNESS);
        let plain = multiple.map_or(text.to_owned(), |count| format!("{} mm", count * self.value(THICKNESS)));
        let number = choice.read(&plain).map_err(|error| {
            let message = error.to_string();
            let (what, help) = message.split_once('\n').unwrap_or((&message, ""));
            CaseError::bare(format!("--{key}: {what}"), help.to_owned())
        })?;
        let number = if choice.key == key { number } else { 0.5 * number };
        // Half of the widest blank; only a part is longer.
        let what = || format!("--{key} {text} is odd: stampings are up to {} mm wide", rules::WIDEST);
        let fits = choice.value != "LENGTH" || key == "length" || number <= 0.5 * rules::WIDEST;
        ensure(fits, what, "is the unit right?")?;
        let before = self.given.insert(choice.key.clone(), (key.to_owned(), text.to_owned(), number));
        before.map_or(Ok(()), |(other, ..)| Err(both_given(&other, key)))
    }

    pub fn either(&self, keys: [&str; 2]) -> Result<(), CaseError> {
        match keys.map(|key| self.given.get(key)) {
            [Some((one, ..)), Some((other, ..))] => Err(both_given(one, other)),
            _ => Ok(()),
        }
    }

    pub fn only_with(&self, key: &str, of: &str) -> Result<(), CaseError> {
        let what = || format!("--{key} is given without --{of}");
        ensure(!self.given.contains_key(key) || self.given.contains_key(of), what, &format!("give --{of} too"))
    }

    pub fn number(&self, key: &str) -> Option<f64> {
        self.given.get(key).map(|(_, _, number)| *number)
    }

    pub fn is_on(&self, key: &str) -> bool {
        self.number(key) == Some(1.0)
    }

    pub fn name(&self, key: &str) -> Option<&str> {
        self.given.get(key).map(|(_, text, _)| text.as_str())
    }

    pub fn value(&self, key: &str) -> f64 {
        let choice = || self.options.iter().find(|choice| choice.key == key);
        let default = || choice().and_then(|choice| choice.read(&choice.default).ok());
        self.number(key).or_else(default).unwrap_or_else(|| unreachable!("--{key} has a value for a default"))
    }

    pub fn values<const N: usize>(&self, keys: [&str; N]) -> [f64; N] {
        keys.map(|key| self.value(key))
    }

    pub fn pick(&self, key: &str, rule: impl FnOnce() -> Picked) -> Picked {
        Picked::or(self.number(key), rule)
    }
}

fn both_given(one: &str, other: &str) -> CaseError {
    CaseError::bare(format!("--{one} and --{other} are both given"), "keep one of them".into())
}
