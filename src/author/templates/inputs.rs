//! What may be given to a template, and what was.

pub(super) use self::Default::{Rule, Value};

use super::rules::Picked;
use crate::case::CaseError;
use crate::units::{
    Angle, Dimensioned, Force, Fraction, Length, NonNegative, Number, Positive, QuantityError, Ratio, Stress, closest,
    thicknesses,
};
use std::borrow::Cow;

/// What kind of value an option takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Above zero \[mm\].
    Length,
    /// Above zero \[MPa\].
    Stress,
    /// Above zero \[rad\].
    Angle,
    /// Above zero \[N\].
    Force,
    /// Zero or above, in percent \[–\].
    Share,
    /// Zero or above \[–\].
    Number,
    /// From 0 to 1 \[–\].
    Fraction,
    /// A word.
    Name,
}

impl Kind {
    /// What stands for the value in help texts.
    pub fn placeholder(self) -> &'static str {
        match self {
            Kind::Length => "LENGTH",
            Kind::Stress => "STRESS",
            Kind::Angle => "ANGLE",
            Kind::Force => "FORCE",
            Kind::Share => "PERCENT",
            Kind::Number => "NUMBER",
            Kind::Fraction => "FRACTION",
            Kind::Name => "NAME",
        }
    }

    /// The value, numbers in solver units.
    fn read(self, text: &str) -> Result<Given, QuantityError> {
        fn value<Q: Dimensioned + std::str::FromStr<Err = QuantityError>>(text: &str) -> Result<Given, QuantityError> {
            text.parse::<Q>().map(|quantity| Given::Number(quantity.value()))
        }
        match self {
            Kind::Length => value::<Positive<Length>>(text),
            Kind::Stress => value::<Positive<Stress>>(text),
            Kind::Angle => value::<Positive<Angle>>(text),
            Kind::Force => value::<Positive<Force>>(text),
            Kind::Share => value::<NonNegative<Ratio>>(text),
            Kind::Number => value::<NonNegative<Number>>(text),
            Kind::Fraction => value::<Fraction>(text),
            Kind::Name => Ok(Given::Name(text.to_owned())),
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
    /// Kind of its value.
    pub kind: Kind,
    /// What is taken where it is not given.
    pub default: Default,
    /// What it is, in one line.
    pub about: &'static str,
    /// Of a radius of a round part: the name of the option that takes its diameter instead.
    pub diameter: Option<&'static str>,
}

impl Choice {
    pub(super) const fn new(key: &'static str, kind: Kind, default: Default, about: &'static str) -> Self {
        Self { key, kind, default, about, diameter: None }
    }

    pub(super) const fn length(key: &'static str, default: Default, about: &'static str) -> Self {
        Self::new(key, Kind::Length, default, about)
    }

    /// A radius of a round part, which may also be given as a diameter.
    pub(super) const fn radius(
        key: &'static str,
        diameter: &'static str,
        default: Default,
        about: &'static str,
    ) -> Self {
        Self { diameter: Some(diameter), ..Self::length(key, default, about) }
    }

    /// The names under which it may be given.
    pub fn keys(&self) -> impl Iterator<Item = &'static str> + use<> {
        std::iter::once(self.key).chain(self.diameter)
    }
}

/// What an option was given as.
enum Given {
    /// In solver units.
    Number(f64),
    Name(String),
}

/// The values of a template's options.
pub(super) struct Inputs {
    values: Vec<(Choice, Option<Given>)>,
}

impl Inputs {
    /// The values given by name to a template that has these options.
    ///
    /// # Errors
    /// When an option is none of these or given twice, or a value is none of its kind.
    pub fn read(
        template: &str,
        options: impl Iterator<Item = &'static Choice>,
        given: &[(&str, &str)],
    ) -> Result<Self, CaseError> {
        let mut values: Vec<(Choice, Option<Given>)> = options.map(|choice| (*choice, None)).collect();
        let thickness = thickness(&values, given);
        let mut seen: Vec<&str> = Vec::new();
        for (key, text) in given {
            let Some((choice, value)) = values.iter_mut().find(|(choice, _)| choice.keys().any(|known| known == *key))
            else {
                return Err(unknown(template, values.iter().flat_map(|(choice, _)| choice.keys()).collect(), key));
            };
            if let Some(other) = seen.iter().find(|seen| choice.keys().any(|known| known == **seen)) {
                let what = match other == key {
                    true => format!("--{key} is given twice"),
                    false => format!("--{other} and --{key} are both given"),
                };
                return Err(CaseError::bare(what, "keep one of them".into()));
            }
            seen.push(key);
            let read = choice.kind.read(&plain(text, choice, thickness)).map_err(|error| {
                let message = error.to_string();
                let (what, help) = message.split_once('\n').unwrap_or((&message, ""));
                CaseError::bare(format!("--{key}: {what}"), help.to_owned())
            })?;
            *value = Some(match read {
                Given::Number(across) if choice.diameter == Some(*key) => Given::Number(0.5 * across),
                read => read,
            });
        }
        Ok(Self { values })
    }

    fn entry(&self, key: &str) -> &(Choice, Option<Given>) {
        let entry = self.values.iter().find(|(choice, _)| choice.key == key);
        entry.unwrap_or_else(|| unreachable!("templates ask for their own options only, not for {key}"))
    }

    /// The number that was given, if any.
    pub fn given(&self, key: &str) -> Option<f64> {
        match self.entry(key).1 {
            Some(Given::Number(number)) => Some(number),
            _ => None,
        }
    }

    /// The word that was given, if any.
    pub fn name(&self, key: &str) -> Option<&str> {
        match &self.entry(key).1 {
            Some(Given::Name(name)) => Some(name),
            _ => None,
        }
    }

    /// The number that was given, or the option's default value.
    pub fn value(&self, key: &str) -> f64 {
        self.given(key).unwrap_or_else(|| {
            let choice = &self.entry(key).0;
            let Default::Value(text) = choice.default else { unreachable!("--{key} is picked by a rule") };
            let Ok(Given::Number(number)) = choice.kind.read(text) else { unreachable!("defaults are well written") };
            number
        })
    }

    /// What was given, or what a rule picks.
    pub fn pick(&self, key: &str, rule: impl FnOnce() -> Picked) -> Picked {
        Picked::or(self.given(key), rule)
    }
}

/// The option whose value is the thickness of the sheet.
const THICKNESS: &str = "thickness";

/// Thickness of the sheet \[mm\], given or not; `None` where it is ill written, which is said where it is read.
fn thickness(values: &[(Choice, Option<Given>)], given: &[(&str, &str)]) -> Option<f64> {
    let (choice, _) = values.iter().find(|(choice, _)| choice.key == THICKNESS)?;
    let written = given.iter().find(|(key, _)| *key == THICKNESS).map_or(choice.default.words(), |(_, text)| text);
    match choice.kind.read(written) {
        Ok(Given::Number(thickness)) => Some(thickness),
        _ => None,
    }
}

/// A length in thicknesses of the sheet, "6 t", in millimetres; other texts as they are.
fn plain<'t>(text: &'t str, choice: &Choice, thickness: Option<f64>) -> Cow<'t, str> {
    let is_multiple = choice.kind == Kind::Length && choice.key != THICKNESS;
    match thicknesses(text).zip(thickness).filter(|_| is_multiple) {
        Some((count, thickness)) => format!("{} mm", count * thickness).into(),
        None => text.into(),
    }
}

fn unknown(template: &str, known: Vec<&str>, key: &str) -> CaseError {
    let near = closest(key, known.iter().copied());
    let meant = near.first().map_or(String::new(), |near| format!("did you mean --{near}? "));
    let all: Vec<String> = known.iter().map(|key| format!("--{key}")).collect();
    CaseError::bare(
        format!("the template {template} has no option --{key}"),
        format!("{meant}it has {}", all.join(", ")),
    )
}
