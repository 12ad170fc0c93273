//! Options of templates and their values.

use super::Template;
use crate::assess::design::Picked;
use crate::case::CaseError;
use crate::units::{
    Angle, Dimensioned, Force, Fraction, Length, NonNegative, Number, Positive, QuantityError, Ratio, Stress, closest,
    thicknesses,
};
use std::collections::BTreeMap;
use std::str::FromStr;

/// Kind of an option's value.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Placeholder of the value in help texts.
    pub placeholder: &'static str,
    /// Number in the solver's unit; 0 for a name.
    read: fn(&str) -> Result<f64, QuantityError>,
}

impl Kind {
    pub(super) const LENGTH: Self = Self::of::<Positive<Length>>("LENGTH");
    pub(super) const STRESS: Self = Self::of::<Positive<Stress>>("STRESS");
    pub(super) const ANGLE: Self = Self::of::<Positive<Angle>>("ANGLE");
    pub(super) const FORCE: Self = Self::of::<Positive<Force>>("FORCE");
    pub(super) const SHARE: Self = Self::of::<NonNegative<Ratio>>("PERCENT");
    pub(super) const NUMBER: Self = Self::of::<NonNegative<Number>>("NUMBER");
    pub(super) const FRACTION: Self = Self::of::<Fraction>("FRACTION");
    pub(super) const NAME: Self = Self { placeholder: "NAME", read: |_| Ok(0.0) };

    const fn of<Q: Dimensioned + FromStr<Err = QuantityError>>(placeholder: &'static str) -> Self {
        Self { placeholder, read: |text| text.parse::<Q>().map(Dimensioned::value) }
    }
}

/// An option of a template.
#[derive(Clone, Copy, Debug)]
pub struct Choice {
    /// Name, without dashes in front.
    pub key: &'static str,
    /// Kind of its value.
    pub kind: Kind,
    /// Default value, or in words the rule that picks it.
    pub default: &'static str,
    /// Description in one line.
    pub about: &'static str,
    /// Option that takes the diameter in place of this radius.
    pub diameter: Option<&'static str>,
}

pub(super) const NOSE: Choice = Choice::length("nose", "6 thicknesses", "radius of the punch's corner");
pub(super) const SHOULDER: Choice = Choice::length("shoulder", "6 thicknesses", "radius of the die's corner");
pub(super) const CLEARANCE: Choice = Choice::length("clearance", "t √β", "gap between punch and die");
pub(super) const STRIP_CLEARANCE: Choice = Choice { default: "1.1 thicknesses", ..CLEARANCE };
pub(super) const HOLDER_PRESSURE: Choice = Choice {
    key: "holder-pressure",
    kind: Kind::STRESS,
    default: "Siebel's, or what keeps the rim down",
    about: "pressure of the holder on the flange",
    diameter: None,
};

impl Choice {
    pub(super) const fn new(key: &'static str, kind: Kind, default: &'static str, about: &'static str) -> Self {
        Self { key, kind, default, about, diameter: None }
    }

    pub(super) const fn length(key: &'static str, default: &'static str, about: &'static str) -> Self {
        Self::new(key, Kind::LENGTH, default, about)
    }

    pub(super) const fn or_diameter(self, key: &'static str) -> Self {
        Self { diameter: Some(key), ..self }
    }

    /// Names of the option: its own and that of the diameter.
    pub fn keys(&self) -> impl Iterator<Item = &'static str> + use<> {
        std::iter::once(self.key).chain(self.diameter)
    }
}

/// Option whose value is the thickness of the sheet.
const THICKNESS: &str = "thickness";

/// Values of a template's options.
pub(super) struct Inputs {
    options: Vec<&'static Choice>,
    /// Name under which an option was given, text and number, by key.
    given: BTreeMap<&'static str, (String, String, f64)>,
}

impl Inputs {
    /// # Errors
    /// When an option is unknown or given twice, or a value is not of its kind.
    pub fn read(template: &Template, given: &[(&str, &str)]) -> Result<Self, CaseError> {
        let mut inputs = Self { options: template.options().collect(), given: BTreeMap::new() };
        // Other lengths may be multiples of the thickness.
        let (first, rest): (Vec<_>, Vec<_>) = given.iter().partition(|(key, _)| *key == THICKNESS);
        first.into_iter().chain(rest).try_for_each(|(key, text)| inputs.add(template.name, key, text))?;
        Ok(inputs)
    }

    fn add(&mut self, template: &str, key: &str, text: &str) -> Result<(), CaseError> {
        let Some(choice) = self.options.iter().find(|choice| choice.keys().any(|known| known == key)) else {
            let known = || self.options.iter().flat_map(|choice| choice.keys());
            let meant = closest(key, known()).first().map_or(String::new(), |near| format!("did you mean --{near}? "));
            let all: Vec<String> = known().map(|key| format!("--{key}")).collect();
            let what = format!("the template {template} has no option --{key}");
            return Err(CaseError::bare(what, format!("{meant}it has {}", all.join(", "))));
        };
        let is_length = choice.kind.placeholder == Kind::LENGTH.placeholder && key != THICKNESS;
        let multiple = thicknesses(text).filter(|_| is_length);
        let plain = multiple.map_or(text.to_owned(), |count| format!("{} mm", count * self.value(THICKNESS)));
        let number = (choice.kind.read)(&plain).map_err(|error| {
            let message = error.to_string();
            let (what, help) = message.split_once('\n').unwrap_or((&message, ""));
            CaseError::bare(format!("--{key}: {what}"), help.to_owned())
        })?;
        let number = if choice.diameter == Some(key) { 0.5 * number } else { number };
        match self.given.insert(choice.key, (key.to_owned(), text.to_owned(), number)) {
            Some((other, ..)) => {
                Err(CaseError::bare(format!("--{other} and --{key} are both given"), "keep one of them".into()))
            }
            None => Ok(()),
        }
    }

    /// Number that was given, if any.
    pub fn number(&self, key: &str) -> Option<f64> {
        self.given.get(key).map(|(_, _, number)| *number)
    }

    /// Word that was given, if any.
    pub fn name(&self, key: &str) -> Option<&str> {
        self.given.get(key).map(|(_, text, _)| text.as_str())
    }

    /// Number that was given, or the option's default value.
    pub fn value(&self, key: &str) -> f64 {
        let choice = || self.options.iter().find(|choice| choice.key == key);
        let default = || choice().and_then(|choice| (choice.kind.read)(choice.default).ok());
        self.number(key).or_else(default).unwrap_or_else(|| unreachable!("--{key} has a value for a default"))
    }

    /// Number that was given, or what a rule picks.
    pub fn pick(&self, key: &str, rule: impl FnOnce() -> Picked) -> Picked {
        Picked::or(self.number(key), rule)
    }
}
