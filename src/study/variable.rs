//! Variables of a study: a key of the case and its values.
//!
//! ```text
//! KEY=FROM..TO UNIT/N           N values, evenly spaced            tools.die.shoulder=4..10 mm/7
//! KEY=FROM..TO UNIT/N log       N values in even ratios            solver.contact_stiffness=3..300 GPa/5 log
//! KEY=FROM..TO UNIT             a search range                     blank.diameter=90..140 mm
//! KEY=START in LOW..HIGH UNIT   a search range with its start      friction=0.1 in 0.01..0.3
//! KEY=A,B,C UNIT                these values                       friction=0.04,0.08,0.12
//! KEY=... & KEY=...             variables that move together
//! ```

use super::StudyError;
use crate::table::Spacing;
use crate::units::{Unit, parse, significant};

/// Digits of computed values.
const DIGITS: usize = 12;
const COUNT: std::ops::RangeInclusive<usize> = 2..=1_000_000;
const USAGE: &str = "write KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT, such as \"tools.die.shoulder=4..10 mm/7\"";

/// A key of the case and its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Dotted path of keys, as in an override.
    pub key: String,
    /// Unit of all values; empty for plain numbers and words.
    pub unit: String,
    /// Its values.
    pub domain: Domain,
}

/// Values of a variable.
#[derive(Clone, Debug, PartialEq)]
pub enum Domain {
    /// A list, at least one.
    List(Vec<Value>),
    /// An interval.
    Range(SearchRange),
}

/// An interval of a variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SearchRange {
    /// First and last value, in the variable's unit; not sorted.
    pub ends: [f64; 2],
    /// Number of values, if given.
    pub count: Option<usize>,
    /// Even differences or even ratios.
    pub spacing: Spacing,
    /// Start of a fit, if given.
    pub start: Option<f64>,
}

/// A value of a variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// Without the unit.
    pub text: String,
    /// In the variable's unit; `None` for a word.
    pub number: Option<f64>,
}

impl Value {
    /// A number.
    pub fn number(number: f64) -> Self {
        let number = significant(number, DIGITS);
        Self { text: number.to_string(), number: Some(number) }
    }

    fn read(text: &str) -> Self {
        Self { text: text.to_owned(), number: text.replace('−', "-").parse().ok().filter(|x: &f64| x.is_finite()) }
    }
}

impl Variable {
    /// Reads variables that move together, `KEY=VALUES` joined by `&`.
    ///
    /// # Errors
    /// When one of them gives no values.
    pub fn read_together(text: &str) -> Result<Vec<Self>, StudyError> {
        text.split('&').map(Self::read).collect()
    }

    /// Reads `KEY=VALUES`.
    ///
    /// # Errors
    /// When either is missing or the values cannot be read.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let (key, values) =
            split_pair(text).ok_or_else(|| StudyError::new(format!("`{}` gives no key values", text.trim()), USAGE))?;
        Self::new(key, values)
    }

    /// Reads the values of a key.
    ///
    /// # Errors
    /// When a range is empty, a value is missing, or units differ.
    pub fn new(key: &str, values: &str) -> Result<Self, StudyError> {
        let Some((from, to)) = values.split_once("..") else { return Self::list(key, values) };
        reject_decimal_comma(key, values)?;
        Self::range(key, values, from, to)
    }

    fn range(key: &str, values: &str, from: &str, to: &str) -> Result<Self, StudyError> {
        let wrong = |what: &str| {
            let help =
                "a range is FROM..TO UNIT, with /N for N values: \"4..10 mm/7\", with `log` behind it for even ratios";
            StudyError::new(format!("{key}: the range `{values}` {what}"), help)
        };
        let number = |text, what| number_or(text, || wrong(what));
        let (start, from) = match from.split_once(" in ") {
            Some((start, from)) => (Some(number(start, "does not start with a number")?.0), from),
            None => (None, from),
        };
        let (to, is_log) = match to.trim_end().strip_suffix("log") {
            Some(to) => (to.trim_end(), true),
            None => (to, false),
        };
        let (to, count) = match to.rsplit_once('/').map(|(to, count)| (to, count.trim().parse::<usize>())) {
            Some((to, Ok(count))) => (to, Some(count)),
            _ => (to, None),
        };
        if let Some(count) = count.filter(|count| !COUNT.contains(count)) {
            return Err(wrong(&format!("has {count} values, not {} to {}", COUNT.start(), COUNT.end())));
        }
        let (low, low_unit) = number(from, "does not begin with a number")?;
        let (high, unit) = number(to, "does not end with a number")?;
        one_unit([low_unit, unit]).map_err(|units| wrong(&units))?;
        if low == high {
            return Err(wrong("has no width"));
        }
        if is_log && low.min(high) <= 0.0 {
            return Err(wrong("has no logarithms: both ends must be above 0"));
        }
        if start.is_some_and(|start| !(low.min(high)..=low.max(high)).contains(&start)) {
            return Err(wrong("does not hold its start"));
        }
        check_unit(key, unit)?;
        let range = SearchRange { ends: [low, high], count, spacing: Spacing::of(is_log), start };
        Ok(Self { key: key.into(), unit: unit.into(), domain: Domain::Range(range) })
    }

    fn list(key: &str, values: &str) -> Result<Self, StudyError> {
        if let Some(point) = decimal_point(values) {
            let what = format!("{key}: a decimal comma, or two values, in `{values}`");
            let help = format!("write a point, {point}, or a blank behind a comma between values");
            return Err(StudyError::new(what, help));
        }
        let items: Vec<&str> = values.split(',').map(|item| item.trim().trim_matches('"')).collect();
        let wrong = |what: &str| {
            StudyError::new(
                format!("{key}: {what} in `{values}`"),
                "write A,B,C with one unit behind all: \"4,6,8 mm\"",
            )
        };
        if items.iter().any(|item| item.is_empty()) {
            return Err(wrong("a value is missing"));
        }
        let numbers: Option<Vec<_>> = items.iter().map(|item| split_number(item)).collect();
        let unit = numbers.as_ref().and_then(|numbers| numbers.last()).map_or("", |(_, unit)| unit);
        for (_, other) in numbers.iter().flatten() {
            one_unit([other, unit]).map_err(|units| wrong(&units))?;
        }
        check_unit(key, unit)?;
        let list = items.iter().map(|item| Value::read(item.strip_suffix(unit).unwrap_or(item).trim())).collect();
        Ok(Self { key: key.into(), unit: unit.into(), domain: Domain::List(list) })
    }

    /// All values, for a design of experiments.
    ///
    /// # Errors
    /// When a range has no number of values.
    pub fn values(&self) -> Result<Vec<Value>, StudyError> {
        match &self.domain {
            Domain::List(values) => Ok(values.clone()),
            Domain::Range(SearchRange { ends, count: Some(count), spacing, .. }) => {
                let last = count - 1;
                let at = |i: usize| match i {
                    0 => ends[0],
                    i if i == last => ends[1],
                    i => spacing.between(*ends, i as f64 / last as f64),
                };
                Ok((0..*count).map(|i| Value::number(at(i))).collect())
            }
            Domain::Range(_) => {
                let help = "write /N behind it: \"4..10 mm/7\"";
                Err(StudyError::new(format!("{}: the range does not say how many values", self.key), help))
            }
        }
    }

    /// The interval, for a search or a fit.
    ///
    /// # Errors
    /// When it is a list.
    pub fn search_range(&self) -> Result<SearchRange, StudyError> {
        match self.domain {
            Domain::Range(range) => Ok(range),
            Domain::List(_) => {
                let help = "write KEY=FROM..TO UNIT, such as \"blank.diameter=90..140 mm\"";
                Err(StudyError::new(format!("`{}` gives no range to search", self.key), help))
            }
        }
    }

    /// The override that sets a value.
    pub fn setting(&self, value: &Value) -> String {
        match (&value.number, self.unit.as_str()) {
            (None, _) => format!("{}={:?}", self.key, value.text),
            (_, "") => format!("{}={}", self.key, value.text),
            (_, unit) => format!("{}={} {unit}", self.key, value.text),
        }
    }

    /// Column of a table: the key with its unit, `tools.die.shoulder_mm`.
    pub fn header(&self) -> String {
        let unit = self.unit.replace('/', "_per_").replace('%', "percent").replace('°', "deg").replace([' ', '^'], "");
        if unit.is_empty() { self.key.clone() } else { format!("{}_{unit}", self.key) }
    }

    /// A value with its unit.
    pub fn display(&self, value: f64) -> String {
        format!("{} {}", significant(value, 6), self.unit).trim_end().to_owned()
    }

    /// Name for tables and axes; the key if it has none.
    pub fn label(&self) -> String {
        let name = NAMES.iter().find(|(key, _)| *key == self.key);
        name.map_or_else(|| self.key.clone(), |(_, name)| (*name).to_owned())
    }

    /// Solver unit of an axis, and the factor from the variable's unit to it.
    pub fn axis_unit(&self) -> (Unit, f64) {
        Unit::of_header(&self.header()).unwrap_or((Unit::None, 1.0))
    }

    /// A quantity as written, in the variable's unit; `None` in another dimension.
    pub fn in_unit(&self, text: &str) -> Option<f64> {
        let [own, one] = [text.to_owned(), format!("1 {}", self.unit)].map(|text| parse(&text).ok());
        let (own, one) = (own?, one?);
        (own.dimension == one.dimension).then_some(own.value / one.value)
    }
}

/// Names of keys on the shop floor.
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

/// Key and values around the first `=`; `None` if either is empty.
pub(super) fn split_pair(text: &str) -> Option<(&str, &str)> {
    let (key, values) = text.split_once('=')?;
    Some((key.trim(), values.trim())).filter(|(key, values)| !key.is_empty() && !values.is_empty())
}

/// A number and the unit behind it; `None` for a word.
pub(super) fn split_number(text: &str) -> Option<(f64, &str)> {
    let is_exponent = |rest: &str| rest.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit());
    let is_of_number = |(i, c): (usize, char)| {
        c.is_ascii_digit()
            || matches!(c, '.' | '+' | '-' | '−')
            || (matches!(c, 'e' | 'E') && is_exponent(&text[i + 1..]))
    };
    let end = text.char_indices().find(|&at| !is_of_number(at)).map_or(text.len(), |(i, _)| i);
    let number: f64 = text[..end].replace('−', "-").parse().ok()?;
    number.is_finite().then(|| (number, text[end..].trim()))
}

fn number_or(text: &str, wrong: impl FnOnce() -> StudyError) -> Result<(f64, &str), StudyError> {
    split_number(text.trim()).ok_or_else(wrong)
}

fn one_unit([first, unit]: [&str; 2]) -> Result<(), String> {
    if first.is_empty() || first == unit {
        return Ok(());
    }
    Err(format!("has two units, {first} and {}", if unit.is_empty() { "none" } else { unit }))
}

/// Refuses a decimal comma in a text that has no list.
pub(super) fn reject_decimal_comma(key: &str, text: &str) -> Result<(), StudyError> {
    let is_digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let parts: Vec<&str> = text.split(',').collect();
    let is_decimal = |pair: &[&str]| is_digit(pair[0].chars().next_back()) && is_digit(pair[1].chars().next());
    match parts.windows(2).any(is_decimal) {
        true => Err(StudyError::new(
            format!("{key}: a decimal comma in `{text}`"),
            format!("write a point: {}", parts.join(".")),
        )),
        false => Ok(()),
    }
}

/// The list with a point if it is rather a number with a decimal comma, `0,04`: nobody writes a value as `04`.
fn decimal_point(list: &str) -> Option<String> {
    let parts: Vec<&str> = list.trim().split(',').collect();
    let is_whole = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
    let is_decimal = |pair: &[&str]| {
        let digits = pair[1].len() - pair[1].trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let ends = !pair[1][digits..].starts_with('.');
        let is_padded = digits > 1 && pair[1].starts_with('0') && ends;
        let is_share = parts.len() == 2 && pair[0] == "0" && digits > 0 && ends;
        is_whole(pair[0].trim_start().trim_start_matches(['-', '−'])) && (is_padded || is_share)
    };
    parts.windows(2).any(is_decimal).then(|| if parts.len() == 2 { parts.join(".") } else { "0.04".to_owned() })
}

/// Refuses a unit that case files do not know.
pub(super) fn check_unit(key: &str, unit: &str) -> Result<(), StudyError> {
    match parse(&format!("1 {unit}")) {
        // "6 t" is six thicknesses of the sheet.
        Err(_) if unit == "t" => Ok(()),
        Ok(_) => Ok(()),
        Err(error) => Err(StudyError::new(format!("{key}: {error}"), "write a unit of case files behind the values")),
    }
}

#[cfg(test)]
#[path = "variable_tests.rs"]
mod tests;
