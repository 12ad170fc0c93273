//! A stretch of a key's values, or of several that move together: what a search looks through.
//!
//! ```text
//! KEY=FROM..TO UNIT            blank.diameter=90..140 mm
//! KEY=FROM..TO UNIT/N          looked at in N places first
//! KEY=FROM..TO UNIT log        in even ratios instead of even steps
//! KEY=... & KEY=...            the second key moves with the first
//! KEY                          from half to twice what the case has
//! ```

use super::varied::label;
use super::vary::{Value, Vary};
use super::{StudyError, Subject};
use crate::table::Spacing;
use crate::units::{Amount, Digits};
use crate::units::{Unit, parse, significant};
use std::borrow::Cow;
use toml_edit::{DocumentMut, Item};

/// Least and most places that a stretch is looked at first.
const PLACES: std::ops::RangeInclusive<usize> = 3..=1000;

/// What a key is looked through by, over its value in the case, where no span is given \[–\].
const ABOUT: [f64; 2] = [0.5, 2.0];

/// How near a limit is found by default, over the span \[–\].
pub const SHARE: f64 = 0.005;

/// Keys that move together from one end to the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Span {
    /// The first is told; each goes from its first value to its last.
    keys: Vec<Vary>,
    /// Ends of the first key, in its unit, rising.
    ends: [f64; 2],
    /// Whether equal differences or equal ratios are equally far apart.
    spacing: Spacing,
    /// Places to look at first, where that is given.
    places: Option<usize>,
    /// How near the limit is to be found, in the unit of the first key; a share of the span by default.
    tolerance: Option<f64>,
    /// Whether the first key has whole numbers only.
    is_whole: bool,
}

impl Span {
    /// Reads a span; of a key without one, from what the case has.
    ///
    /// # Errors
    /// When it is no range, has an unknown unit, or the case has no number at a key without a range.
    pub fn read(text: &str, subject: &Subject) -> Result<Self, StudyError> {
        let help = "write KEY=FROM..TO UNIT, such as \"blank.diameter=90..140 mm\"";
        let (mut keys, mut places, mut is_log) = (Vec::new(), None, false);
        for part in text.split('&').map(str::trim) {
            let (key, values) = match part.split_once('=') {
                Some((key, values)) => (key.trim(), values.trim().to_owned()),
                None => (part, about(part, subject)?),
            };
            if key.is_empty() || !values.contains("..") {
                return Err(StudyError::new(format!("`{part}` gives no range to search"), help));
            }
            let (range, log) = match values.strip_suffix("log") {
                Some(range) => (range.trim(), true),
                None => (values.as_str(), false),
            };
            let count = range.rsplit_once('/').and_then(|(_, count)| count.trim().parse::<usize>().ok());
            if let Some(count) = count.filter(|count| !PLACES.contains(count)) {
                let what = format!("{key}: {count} places are not {} to {}", PLACES.start(), PLACES.end());
                return Err(StudyError::new(what, help));
            }
            let counted = if count.is_some() { range.to_owned() } else { format!("{range}/2") };
            keys.push(Vary::of(key, &format!("{counted}{}", if log { " log" } else { "" }))?);
            (places, is_log) = (places.or(count), is_log || log);
        }
        let span = Self::of(keys, Spacing::of(is_log), places);
        Ok(Self { is_whole: span.is_of_whole_numbers(subject), ..span })
    }

    /// Whether the first key makes a case at its first end, and none half a step from there.
    fn is_of_whole_numbers(&self, subject: &Subject) -> bool {
        let [low, high] = self.ends;
        let makes_a_case = |x: f64| subject.case(&[self.keys[0].setting(&Value::number(x))]).is_ok();
        let is_plain = self.unit().is_empty() && [low, high].iter().all(|end| end.fract() == 0.0);
        is_plain && makes_a_case(low) && !makes_a_case(low + 0.5) && makes_a_case(low + 1.0)
    }

    /// Of keys with their ranges.
    fn of(mut keys: Vec<Vary>, spacing: Spacing, places: Option<usize>) -> Self {
        let end = |vary: &Vary, last: bool| {
            let value = if last { vary.values.last() } else { vary.values.first() };
            value.and_then(|value| value.number).unwrap_or_default()
        };
        if end(&keys[0], false) > end(&keys[0], true) {
            keys.iter_mut().for_each(|vary| vary.values.reverse());
        }
        let ends = [false, true].map(|last| end(&keys[0], last));
        Self { keys, ends, spacing, places, tolerance: None, is_whole: false }
    }

    /// The same, its limit to be found as near as that: `0.2 mm`.
    ///
    /// # Errors
    /// When that is no number above 0 in a unit of the key.
    pub fn within(self, tolerance: &str) -> Result<Self, StudyError> {
        let unit = &self.keys[0].unit;
        let wrong = || {
            let example = format!("write a number above 0 in the unit of the key, such as \"0.1 {unit}\"");
            StudyError::new(format!("`{tolerance}` is no tolerance of {}", self.key()), example)
        };
        let one = parse(&format!("1 {unit}")).map_err(|_| wrong())?;
        let given = parse(tolerance).ok().filter(|given| given.dimension == one.dimension).ok_or_else(wrong)?;
        let size = given.value / one.value;
        if !(size > 0.0 && size.is_finite()) || one.has_unit != given.has_unit {
            return Err(wrong());
        }
        Ok(Self { tolerance: Some(size), ..self })
    }

    /// The key that is told.
    pub fn key(&self) -> &str {
        &self.keys[0].key
    }

    /// What that key is called in the shop.
    pub fn label(&self) -> Cow<'static, str> {
        label(self.key())
    }

    /// Its unit.
    pub fn unit(&self) -> &str {
        &self.keys[0].unit
    }

    /// All keys that move.
    pub fn keys(&self) -> &[Vary] {
        &self.keys
    }

    /// The solver's unit of its values, and how many of these its own unit is; `None` of multiples of the thickness.
    pub fn solver_unit(&self) -> Option<(Unit, f64)> {
        match self.unit() {
            "" => return Some((Unit::None, 1.0)),
            "%" => return Some((Unit::Percent, 1.0)),
            "°C" => return Some((Unit::Celsius, 1.0)),
            _ => {}
        }
        let own = parse(&format!("1 {}", self.unit())).ok()?;
        let all = [
            (Unit::Mm, "mm"),
            (Unit::N, "N"),
            (Unit::NPerMm, "N/mm"),
            (Unit::MPa, "MPa"),
            (Unit::Second, "s"),
            (Unit::Degree, "deg"),
        ];
        all.into_iter().find_map(|(unit, symbol)| {
            let one = parse(&format!("1 {symbol}")).ok().filter(|one| one.dimension == own.dimension)?;
            Some((unit, own.value / one.value))
        })
    }

    /// A value as it is told.
    pub fn told(&self, x: f64) -> String {
        self.to(x, 4)
    }

    /// A difference of two values as it is told.
    pub fn difference(&self, x: f64) -> String {
        self.to(x.abs(), 2)
    }

    /// As it stands in the key's own unit, in another one to so many digits.
    fn to(&self, x: f64, digits: usize) -> String {
        match self.solver_unit() {
            Some((unit, times)) => Amount::new(significant(x * times, 12), unit, Digits::Converted(digits)).into(),
            None => format!("{x} {}", self.unit()).into(),
        }
    }

    /// Its ends, in its unit.
    pub fn ends(&self) -> [f64; 2] {
        self.ends
    }

    /// Whether equal differences or equal ratios are equally far apart.
    pub fn spacing(&self) -> Spacing {
        self.spacing
    }

    /// Places that it is looked at first, where that is given.
    pub fn places(&self) -> Option<usize> {
        self.places
    }

    /// How near a limit is to be found there, in the unit of the key.
    pub fn tolerance(&self, x: f64) -> f64 {
        let [low, high] = self.ends;
        let tolerance = self.tolerance.unwrap_or_else(|| match self.spacing {
            Spacing::Logarithmic => x * ((high / low).ln() * SHARE).exp_m1(),
            Spacing::Even => SHARE * (high - low),
        });
        if self.is_whole { tolerance.max(1.0) } else { tolerance }
    }

    /// The value at a share of the way, rounded as a shop would write it: to the decimal below half the tolerance.
    pub fn at(&self, share: f64) -> f64 {
        let [low, high] = self.ends;
        if share <= 0.0 || share >= 1.0 {
            return if share <= 0.0 { low } else { high };
        }
        let x = self.spacing.between(self.ends, share);
        let step = if self.is_whole { 1.0 } else { 10f64.powf((0.5 * self.tolerance(x)).log10().floor()) };
        significant((x / step).round() * step, 12).clamp(low, high)
    }

    /// The share of the way that a value is at.
    pub fn share(&self, x: f64) -> f64 {
        self.spacing.share(self.ends, x)
    }

    /// The values of all its keys where the first has this one.
    pub fn values(&self, x: f64) -> Vec<Value> {
        let share = self.share(x);
        let of = |vary: &Vary| {
            let [from, to] = [vary.values.first(), vary.values.last()].map(|v| v.and_then(|v| v.number).unwrap_or(0.0));
            let is_log = self.spacing.is_logarithmic() && from.min(to) > 0.0;
            Value::number(Spacing::of(is_log).between([from, to], share))
        };
        let others = self.keys[1..].iter().map(of);
        std::iter::once(Value::number(x)).chain(others).collect()
    }

    /// The overrides that set its keys.
    pub fn settings(&self, values: &[Value]) -> Vec<String> {
        self.keys.iter().zip(values).map(|(vary, value)| vary.setting(value)).collect()
    }
}

/// A range about what the case has at a key: its half to twice.
fn about(key: &str, subject: &Subject) -> Result<String, StudyError> {
    let unknown = || {
        let what = format!("the case has no number at `{key}` to search about");
        StudyError::new(what, format!("give the range: \"{key}=FROM..TO UNIT\""))
    };
    let case = subject.case(&[])?;
    let document: DocumentMut = case.text.parse().map_err(|_| unknown())?;
    let at = |path: &str| {
        path.split('.').try_fold(document.as_item(), |item: &Item, key| match key.parse::<usize>() {
            Ok(index) => item.get(index),
            Err(_) => item.get(key),
        })
    };
    // What a case has from the axis may be searched across.
    let twin = key.strip_suffix("diameter").map(|start| format!("{start}radius"));
    let (item, times) = match (at(key), twin.as_deref().and_then(at)) {
        (Some(item), _) => (item, 1.0),
        (None, Some(item)) => (item, 2.0),
        (None, None) => return Err(unknown()),
    };
    let written = item.as_str().map_or_else(|| item.to_string(), str::to_owned);
    let one = Vary::of(key, written.trim()).map_err(|_| unknown())?;
    let value = one.values[0].number.filter(|x| *x > 0.0 && one.values.len() == 1).ok_or_else(unknown)?;
    let [low, high] = ABOUT.map(|share| significant(share * times * value, 4));
    Ok(format!("{low}..{high} {}", one.unit))
}
