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

use super::{StudyError, fail};
use crate::plot::Spacing;
use crate::units::{Unit, parse, significant};

const COUNT: std::ops::RangeInclusive<usize> = 2..=1_000_000;

#[derive(Clone, Debug)]
pub(super) struct Variable {
    /// Dotted path of keys, as in an override.
    pub key: String,
    /// Empty for plain numbers and words.
    pub unit: String,
    /// Empty with a range.
    list: Vec<String>,
    range: Option<SearchRange>,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct SearchRange {
    /// In the variable's unit; not sorted.
    pub ends: [f64; 2],
    pub count: Option<usize>,
    pub spacing: Spacing,
    pub start: Option<f64>,
}

impl Variable {
    /// A key without values of its own.
    pub fn new(key: &str, unit: String) -> Self {
        Self { key: key.to_owned(), unit, list: Vec::new(), range: None }
    }

    pub fn read(text: &str) -> Result<Self, StudyError> {
        let help = "write KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT, such as \"tools.die.shoulder=4..10 mm/7\"";
        let pair = split_pair(text);
        let (key, values) =
            pair.ok_or_else(|| StudyError::new(format!("`{}` gives no key values", text.trim()), help))?;
        match values.split_once("..") {
            None => Self::list(key, values),
            Some((from, to)) => {
                reject_decimal_comma(key, values)?;
                Self::range(key, values, from, to)
            }
        }
    }

    fn range(key: &str, values: &str, from: &str, to: &str) -> Result<Self, StudyError> {
        let wrong = |what: &str| {
            let help =
                "a range is FROM..TO UNIT, with /N for N values: \"4..10 mm/7\", with `log` behind it for even ratios";
            StudyError::new(format!("{key}: the range `{values}` {what}"), help)
        };
        let number = |text: &str, what| match split_number(text.trim()) {
            Some((number, unit)) => Ok((number, unit.to_owned())),
            None => Err(wrong(what)),
        };
        let (start, from) = match from.split_once(" in ") {
            Some((start, from)) => (Some(number(start, "does not start with a number")?.0), from),
            None => (None, from),
        };
        let (to, is_log) = to.trim_end().strip_suffix("log").map_or((to, false), |to| (to.trim_end(), true));
        let (to, count) = match to.rsplit_once('/').map(|(to, count)| (to, count.trim().parse::<usize>())) {
            Some((to, Ok(count))) => (to, Some(count)),
            _ => (to, None),
        };
        if let Some(count) = count.filter(|count| !COUNT.contains(count)) {
            return Err(wrong(&format!("has {count} values, not {} to {}", COUNT.start(), COUNT.end())));
        }
        let (low, low_unit) = number(from, "does not begin with a number")?;
        let (high, unit) = number(to, "does not end with a number")?;
        one_unit(&low_unit, &unit).map_err(|units| wrong(&units))?;
        if low == high {
            return Err(wrong("has no width"));
        }
        if is_log && low.min(high) <= 0.0 {
            return Err(wrong("has no logarithms: both ends must be above 0"));
        }
        if start.is_some_and(|start| !(low.min(high)..=low.max(high)).contains(&start)) {
            return Err(wrong("does not hold its start"));
        }
        check_unit(key, &unit)?;
        let range = SearchRange {
            ends: [low, high],
            count,
            spacing: if is_log { Spacing::Logarithmic } else { Spacing::Even },
            start,
        };
        Ok(Self { range: Some(range), ..Self::new(key, unit) })
    }

    fn list(key: &str, values: &str) -> Result<Self, StudyError> {
        if let Some(point) = decimal_point(values) {
            let what = format!("{key}: a decimal comma, or two values, in `{values}`");
            return fail(what, format!("write a point, {point}, or a blank behind a comma between values"));
        }
        let items: Vec<&str> = values.split(',').map(|item| item.trim().trim_matches('"')).collect();
        let wrong = |what: &str| {
            let help = "write A,B,C with one unit behind all: \"4,6,8 mm\"";
            StudyError::new(format!("{key}: {what} in `{values}`"), help)
        };
        if items.contains(&"") {
            return Err(wrong("a value is missing"));
        }
        let numbers: Option<Vec<_>> = items.iter().map(|item| split_number(item)).collect();
        let unit = numbers.as_ref().and_then(|numbers| numbers.last()).map_or("", |(_, unit)| unit);
        for (_, other) in numbers.iter().flatten() {
            one_unit(other, unit).map_err(|units| wrong(&units))?;
        }
        check_unit(key, unit)?;
        let list = items.iter().map(|item| item.strip_suffix(unit).unwrap_or(item).trim().to_owned()).collect();
        Ok(Self { list, ..Self::new(key, unit.to_owned()) })
    }

    /// All values, for a design of experiments.
    pub fn values(&self) -> Result<Vec<String>, StudyError> {
        let Some(SearchRange { ends, count, spacing, .. }) = self.range else { return Ok(self.list.clone()) };
        let Some(last) = count.map(|count| count - 1) else {
            let what = format!("{}: the range does not say how many values", self.key);
            return fail(what, "write /N behind it: \"4..10 mm/7\"");
        };
        let at = |i: usize| if i == last { ends[1] } else { spacing.between(ends, i as f64 / last as f64) };
        Ok((0..=last).map(|i| written(at(i))).collect())
    }

    /// The interval, for a search or a fit.
    pub fn search_range(&self) -> Result<SearchRange, StudyError> {
        let help = "write KEY=FROM..TO UNIT, such as \"blank.diameter=90..140 mm\"";
        self.range.map_or_else(|| fail(format!("`{}` gives no range to search", self.key), help), Ok)
    }

    /// The override that sets a value, a number or a word.
    pub fn setting(&self, value: &str) -> String {
        let Self { key, unit, .. } = self;
        match (number(value), unit.as_str()) {
            (None, _) => format!("{key}={value:?}"),
            (_, "") => format!("{key}={value}"),
            (_, unit) => format!("{key}={value} {unit}"),
        }
    }

    /// Column of a table: the key with its unit, `tools.die.shoulder_mm`.
    pub fn header(&self) -> String {
        let unit = self.unit.replace('/', "_per_").replace('%', "percent").replace('°', "deg").replace([' ', '^'], "");
        if unit.is_empty() { self.key.clone() } else { format!("{}_{unit}", self.key) }
    }

    pub fn display(&self, value: f64) -> String {
        format!("{} {}", significant(value, 6), self.unit).trim_end().to_owned()
    }

    /// Name for tables and axes; the key if it has none.
    pub fn label(&self) -> &str {
        NAMES.iter().find(|(key, _)| *key == self.key).map_or(&self.key, |(_, name)| name)
    }

    /// Solver unit of an axis, and the factor from the variable's unit to it.
    pub fn axis_unit(&self) -> (Unit, f64) {
        Unit::of_header(&self.header()).unwrap_or((Unit::None, 1.0))
    }

    /// A quantity as written, in the variable's unit; `None` in another dimension.
    pub fn in_unit(&self, text: &str) -> Option<f64> {
        let (own, one) = (parse(text).ok()?, parse(&format!("1 {}", self.unit)).ok()?);
        (own.dimension == one.dimension).then_some(own.value / one.value)
    }
}

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

pub(super) fn number(value: &str) -> Option<f64> {
    value.replace('−', "-").parse().ok().filter(|x: &f64| x.is_finite())
}

pub(super) fn written(value: f64) -> String {
    significant(value, 12).to_string()
}

pub(super) fn repeated<'a>(variables: impl Iterator<Item = &'a Variable>) -> Option<&'a str> {
    let keys: Vec<&str> = variables.map(|variable| variable.key.as_str()).collect();
    (1..keys.len()).find(|&i| keys[..i].contains(&keys[i])).map(|i| keys[i])
}

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
    Some((number(&text[..end])?, text[end..].trim()))
}

fn one_unit(first: &str, unit: &str) -> Result<(), String> {
    match first {
        "" => Ok(()),
        _ if first == unit => Ok(()),
        _ => Err(format!("has two units, {first} and {}", if unit.is_empty() { "none" } else { unit })),
    }
}

pub(super) fn reject_decimal_comma(key: &str, text: &str) -> Result<(), StudyError> {
    let bytes = text.as_bytes();
    let is_decimal = |three: &[u8]| three[0].is_ascii_digit() && three[1] == b',' && three[2].is_ascii_digit();
    match bytes.windows(3).any(is_decimal) {
        true => {
            fail(format!("{key}: a decimal comma in `{text}`"), format!("write a point: {}", text.replace(',', ".")))
        }
        false => Ok(()),
    }
}

/// The list with a point if it is rather a number with a decimal comma, `0,04`: nobody writes a value as `04`.
fn decimal_point(list: &str) -> Option<String> {
    let parts: Vec<&str> = list.trim().split(',').collect();
    let is_whole = |part: &str| !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_digit());
    let is_decimal = |pair: &[&str]| {
        let rest = pair[1].trim_start_matches(|c: char| c.is_ascii_digit());
        let digits = if rest.starts_with('.') { 0 } else { pair[1].len() - rest.len() };
        let is_padded = digits > 1 && pair[1].starts_with('0');
        let is_share = digits > 0 && parts.len() == 2 && pair[0] == "0";
        is_whole(pair[0].trim_start().trim_start_matches(['-', '−'])) && (is_padded || is_share)
    };
    parts.windows(2).any(is_decimal).then(|| if parts.len() == 2 { parts.join(".") } else { "0.04".to_owned() })
}

/// Refuses a unit that case files do not have; "6 t" is six thicknesses of the sheet.
pub(super) fn check_unit(key: &str, unit: &str) -> Result<(), StudyError> {
    match parse(&format!("1 {unit}")) {
        Err(error) if unit != "t" => fail(format!("{key}: {error}"), "write a unit of case files behind the values"),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(text: &str) -> Result<Vec<String>, StudyError> {
        let variable = Variable::read(text)?;
        Ok(variable.values()?.iter().map(|value| variable.setting(value)).collect())
    }

    /// Trust: by hand.
    #[test]
    fn ranges_and_lists_give_the_overrides_that_a_user_would_type() {
        for (text, expected) in [
            ("a.b=4..10 mm/4", "a.b=4 mm|a.b=6 mm|a.b=8 mm|a.b=10 mm"),
            ("k=0.1 .. 0.3/3", "k=0.1|k=0.2|k=0.3"),
            ("k=1..100 GPa/3 log", "k=1 GPa|k=10 GPa|k=100 GPa"),
            ("friction=0.04,0.08", "friction=0.04|friction=0.08"),
            ("f=0,5,10 kN", "f=0 kN|f=5 kN|f=10 kN"),
            ("material=dc04,\"dc06\"", "material=\"dc04\"|material=\"dc06\""),
            ("f=1e3,2E+3 N", "f=1e3 N|f=2E+3 N"),
        ] {
            assert_eq!(settings(text).unwrap_or_else(|error| panic!("{error}")).join("|"), expected);
        }
        let range = Variable::read("a.k = 500 in 300 .. 800 MPa").expect("a range").search_range().expect("a range");
        assert_eq!((range.start, range.ends), (Some(500.0), [300.0, 800.0]));
        assert_eq!(Variable::read("a.b=1,2 N/mm").expect("a variable").header(), "a.b_N_per_mm");
    }

    /// Trust: each is wrong in the way that its message says.
    #[test]
    fn bad_ranges_and_lists_are_refused() {
        for (text, message) in [
            ("tools.die.shoulder", "gives no key values"),
            ("a=4..10 mm", "does not say how many"),
            ("a=4..10 mm/1", "has 1 values"),
            ("a=4..4 mm/3", "has no width"),
            ("a=4 in..10 mm/3", "has two units, in and mm"),
            ("a=0..10 mm/3 log", "has no logarithms"),
            ("a=4..10 mmm/3", "mmm"),
            ("a=4,,6 mm", "a value is missing"),
            ("a=4 in,6 mm", "two units"),
            ("a=x..3/4", "does not begin with a number"),
            ("a=5 in 1..3", "does not hold its start"),
            ("friction=0,04", "a decimal comma, or two values, in `0,04`\n  help: write a point, 0.04"),
            ("friction=0,04..0,12/3", "a decimal comma in `0,04..0,12/3`\n  help: write a point: 0.04..0.12/3"),
        ] {
            let error = settings(text).expect_err(text).to_string();
            assert!(error.contains(message), "{text}: {error}");
        }
    }
}
