//! What may be given to a template, and what was.

use super::Template;
use super::rules::Picked;
use crate::case::CaseError;
use crate::quantity::{Angle, Length, NonNegative, Number, Positive, Quantity, QuantityError, Ratio, Stress, closest};

/// What kind of value an option takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Above zero \[mm\].
    Length,
    /// Above zero \[MPa\].
    Stress,
    /// Above zero \[rad\].
    Angle,
    /// Zero or above, in percent \[–\].
    Share,
    /// Zero or above \[–\].
    Number,
}

impl Kind {
    /// What stands for the value in help texts.
    pub fn placeholder(self) -> &'static str {
        match self {
            Kind::Length => "LENGTH",
            Kind::Stress => "STRESS",
            Kind::Angle => "ANGLE",
            Kind::Share => "PERCENT",
            Kind::Number => "NUMBER",
        }
    }

    /// The value in solver units.
    fn read(self, text: &str) -> Result<f64, QuantityError> {
        fn value<Q: Quantity + std::str::FromStr<Err = QuantityError>>(text: &str) -> Result<f64, QuantityError> {
            text.parse::<Q>().map(Q::value)
        }
        match self {
            Kind::Length => value::<Positive<Length>>(text),
            Kind::Stress => value::<Positive<Stress>>(text),
            Kind::Angle => value::<Positive<Angle>>(text),
            Kind::Share => value::<NonNegative<Ratio>>(text),
            Kind::Number => value::<NonNegative<Number>>(text),
        }
    }
}

/// What is taken where nothing is given.
#[derive(Clone, Copy, Debug)]
pub enum Default {
    /// This value.
    Value(&'static str),
    /// What a rule gives, in words.
    Rule(&'static str),
}

impl Default {
    /// The value, or the rule in words.
    pub fn words(self) -> &'static str {
        let (Self::Value(words) | Self::Rule(words)) = self;
        words
    }
}

/// An option of a template.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// Its name, without dashes in front.
    pub key: &'static str,
    pub kind: Kind,
    pub default: Default,
    pub about: &'static str,
}

impl Choice {
    pub(super) const fn new(key: &'static str, kind: Kind, default: Default, about: &'static str) -> Self {
        Self { key, kind, default, about }
    }
}

/// The values of a template's options.
pub(super) struct Inputs {
    values: Vec<(Choice, Option<f64>)>,
}

impl Inputs {
    pub fn read(template: &Template, given: &[(&str, &str)]) -> Result<Self, CaseError> {
        let mut values: Vec<(Choice, Option<f64>)> = template.options().map(|choice| (*choice, None)).collect();
        for (key, text) in given {
            let Some((choice, value)) = values.iter_mut().find(|(choice, _)| choice.key == *key) else {
                return Err(unknown(template, key));
            };
            let read = choice.kind.read(text).map_err(|error| {
                let message = error.to_string();
                let (what, help) = message.split_once('\n').unwrap_or((&message, ""));
                CaseError::bare(format!("--{key}: {what}"), help.to_owned())
            })?;
            if value.replace(read).is_some() {
                return Err(CaseError::bare(format!("--{key} is given twice"), "keep one of them".into()));
            }
        }
        Ok(Self { values })
    }

    fn entry(&self, key: &str) -> &(Choice, Option<f64>) {
        let entry = self.values.iter().find(|(choice, _)| choice.key == key);
        entry.unwrap_or_else(|| unreachable!("templates ask for their own options only, not for {key}"))
    }

    /// What was given, if anything.
    pub fn given(&self, key: &str) -> Option<f64> {
        self.entry(key).1
    }

    /// What was given, or the option's default value.
    pub fn value(&self, key: &str) -> f64 {
        let (choice, given) = self.entry(key);
        given.unwrap_or_else(|| match choice.default {
            Default::Value(text) => choice.kind.read(text).expect("defaults are well written"),
            Default::Rule(_) => unreachable!("--{key} is picked by a rule"),
        })
    }

    /// What was given, or what a rule picks.
    pub fn pick(&self, key: &str, rule: impl FnOnce() -> Picked) -> Picked {
        self.given(key).map_or_else(rule, Picked::given)
    }
}

fn unknown(template: &Template, key: &str) -> CaseError {
    let known: Vec<&str> = template.options().map(|choice| choice.key).collect();
    let near = closest(key, known.iter().copied());
    let meant = near.first().map_or(String::new(), |near| format!("did you mean --{near}? "));
    let all: Vec<String> = known.iter().map(|key| format!("--{key}")).collect();
    CaseError::bare(
        format!("the template {} has no option --{key}", template.name),
        format!("{meant}it has {}", all.join(", ")),
    )
}
