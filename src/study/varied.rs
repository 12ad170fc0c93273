//! What is varied as a designer names it: a label, numbers in the solver's units or names, and where the case itself stands.

use super::subject::Subject;
use super::vary::Vary;
use crate::table::{Axis, Spacing, Unit};
use crate::units::parse;
use crate::units::{Amount, Digits};
use std::borrow::Cow;

/// Keys that have a name in the shop.
const NAMES: [(&str, &str); 18] = [
    ("friction", "Friction"),
    ("tools.punch.friction", "Friction at the punch"),
    ("tools.die.friction", "Friction at the die"),
    ("tools.holder.friction", "Friction at the holder"),
    ("tools.holder.force", "Holder force"),
    ("tools.holder.gap", "Holder gap"),
    ("tools.die.shoulder", "Die shoulder radius"),
    ("tools.die.throat", "Die throat radius"),
    ("tools.punch.flat.nose", "Punch nose radius"),
    ("tools.punch.flat.radius", "Punch radius"),
    ("tools.punch.travel", "Punch travel"),
    ("blank.radius", "Blank radius"),
    ("blank.diameter", "Blank diameter"),
    ("blank.thickness", "Sheet thickness"),
    ("material", "Sheet"),
    ("material.hardening.swift.k", "Strength K"),
    ("material.hardening.swift.n", "Hardening exponent n"),
    ("press.force", "Rating of the press"),
];

/// What a key is called in the shop; itself where it has no name there.
pub fn label(key: &str) -> Cow<'static, str> {
    let name = NAMES.iter().find(|(known, _)| *known == key);
    name.map_or_else(|| Cow::Owned(key.to_owned()), |(_, name)| Cow::Borrowed(*name))
}

/// One axis of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Varied {
    /// What it is called: in the shop, else its key.
    pub label: Cow<'static, str>,
    /// The solver's unit of `values`.
    pub unit: Unit,
    /// Each value in `unit`; of names their place.
    pub values: Vec<f64>,
    /// Each as a name; empty where they are numbers.
    pub names: Vec<String>,
    /// Where the case stands, in `unit` or as a place among the names.
    pub own: Option<f64>,
    /// Logarithmic where three values or more stand in even ratios: where they are drawn, and between which places numbers
    /// change evenly.
    pub spacing: Spacing,
    /// Keys that go together with it.
    pub with: Vec<String>,
}

impl Varied {
    /// An axis of keys that go together, by the first of them.
    pub fn of(axis: &[Vary], subject: &Subject) -> Self {
        let vary = &axis[0];
        let label = label(&vary.key);
        let with = axis[1..].iter().map(|vary| vary.key.clone()).collect();
        let numbers: Option<Vec<f64>> = vary.values.iter().map(|value| value.number).collect();
        let own = subject.own(&vary.key);
        match numbers {
            Some(numbers) => {
                let (unit, factor) = Unit::of_header(&vary.header()).unwrap_or((Unit::None, 1.0));
                let values: Vec<f64> = numbers.iter().map(|number| factor * number).collect();
                let spacing = Spacing::of(has_even_ratios(&values));
                let own = own.and_then(|own| in_unit(&own, &vary.unit)).map(|own| factor * own);
                Self { label, unit, values, names: Vec::new(), own, spacing, with }
            }
            None => {
                let names: Vec<String> = vary.values.iter().map(|value| value.text.clone()).collect();
                let own = own.and_then(|own| names.iter().position(|name| *name == own)).map(|place| place as f64);
                let values = (0..names.len()).map(|i| i as f64).collect();
                Self { label, unit: Unit::None, values, names, own, spacing: Spacing::Even, with }
            }
        }
    }

    /// Whether its values are names.
    pub fn has_names(&self) -> bool {
        !self.names.is_empty()
    }

    /// To be drawn along.
    pub fn axis(&self) -> Axis {
        match self.has_names() {
            true => Axis::of_names(self.label.clone(), self.names.clone()),
            false => Axis::named(self.label.clone(), self.unit).spaced(self.spacing),
        }
    }

    /// One of its values, as it was given.
    pub fn told(&self, value: f64) -> String {
        match self.names.get(value as usize) {
            Some(name) => name.clone().into(),
            None => Amount::new(value, self.unit, Digits::Converted(3)).into(),
        }
    }

    /// A difference of two of its values, as it is read off between runs.
    pub fn difference(&self, difference: f64) -> Amount {
        Amount::new(difference.abs(), self.unit, Digits::Significant(2))
    }

    /// Its label.
    pub fn message(&self) -> String {
        self.label.clone().into()
    }
}

/// How far a ratio may be off: values are written with twelve digits \[–\].
const EVEN: f64 = 1e-9;

/// Whether three values or more, all above 0 and in order, stand in even ratios.
fn has_even_ratios(values: &[f64]) -> bool {
    let ratios: Vec<f64> = values.windows(2).map(|pair| pair[1] / pair[0]).collect();
    let is_even = |ratio: &f64| (ratio / ratios[0] - 1.0).abs() < EVEN;
    ratios.len() > 1 && values.iter().all(|value| *value > 0.0) && ratios[0] != 1.0 && ratios.iter().all(is_even)
}

/// What a case has for a key, as a number in a unit.
fn in_unit(text: &str, unit: &str) -> Option<f64> {
    let [own, one] = [text.to_owned(), format!("1 {unit}")].map(|text| parse(&text).ok());
    let (own, one) = (own?, one?);
    (own.dimension == one.dimension).then_some(own.value / one.value)
}
