//! Variables of a study: a key of the case and its values.
//!
//! ```text
//! KEY=FROM..TO UNIT/N           N values, evenly spaced            tools.die.shoulder=4..10 mm/7
//! KEY=FROM..TO UNIT/N log       N values in even ratios            solver.contact_stiffness=3..300 GPa/5 log
//! KEY=FROM..TO UNIT             a search range                     blank.diameter=90..140 mm
//! KEY=START in LOW..HIGH UNIT   a search range with its start      friction=0.1 in 0.01..0.3
//! KEY=A,B,C UNIT                these values                       friction=0.04,0.08,0.12
//! ```

use super::*;
use crate::plot::Spacing;
use crate::units::{Digits, DisplaySettings};

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
    pub fn new(key: &str, unit: String) -> Self {
        Self { key: key.to_owned(), unit, list: Vec::new(), range: None }
    }

    pub fn read(text: &str) -> Result<Self> {
        let help = "write KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT, such as \"tools.die.shoulder=4..10 mm/7\"";
        let wrong = || StudyError::new(format!("`{}` gives no key values", text.trim()), help);
        let (key, values) = split_pair(text).ok_or_else(wrong)?;
        values.split_once("..").map_or_else(|| Self::list(key, values), |ends| Self::range(key, values, ends))
    }

    fn range(key: &str, values: &str, (from, to): (&str, &str)) -> Result<Self> {
        let help = "write FROM..TO UNIT, /N behind it for N values, then `log` for even ratios: \"4..10 mm/7\"; distributions: `scatter`";
        let mut reader = NumberReader::new(key, values, help)?;
        let (start, from) = from.split_once(" in ").map_or((None, from), |(start, from)| (Some(start), from));
        let (to, is_log) = to.trim_end().strip_suffix("log").map_or((to, false), |to| (to, true));
        let counted = to.rsplit_once('/').and_then(|(to, count)| Some((to, count.trim().parse::<usize>().ok()?)));
        let (to, count) = counted.map_or((to, None), |(to, count)| (to, Some(count)));
        let what = format!("has {} values, not {} to {}", count.unwrap_or(0), COUNT.start(), COUNT.end());
        reader.ensure(count.is_none_or(|count| COUNT.contains(&count)), what)?;
        let ends = [reader.number(from)?, reader.number(to)?];
        let start = start.map(|start| reader.number(start)).transpose()?;
        let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
        reader.ensure(low < high, "has no width")?;
        reader.ensure(!is_log || low > 0.0, "has no logarithms: both ends must be above 0")?;
        reader.ensure(start.is_none_or(|start| (low..=high).contains(&start)), "does not hold its start")?;
        let spacing = if is_log { Spacing::Logarithmic } else { Spacing::Even };
        Ok(Self { range: Some(SearchRange { ends, count, spacing, start }), ..Self::new(key, reader.unit()?) })
    }

    fn list(key: &str, values: &str) -> Result<Self> {
        let help = "write A,B,C with one unit behind all: \"4,6,8 mm\"";
        let what = format!("{key}: a decimal comma, or two values, in `{values}`");
        let point = values.replacen(',', ".", 1);
        ensure(!has_decimal_comma(values), what, format!("write a point, {point}, or a blank behind every comma"))?;
        let mut reader = NumberReader { key, text: values, help, unit: String::new() };
        let items: Vec<&str> = values.split(',').map(|item| item.trim().trim_matches('"')).collect();
        reader.ensure(!items.contains(&""), "misses a value")?;
        if items.iter().all(|item| split_number(item).is_some()) {
            items.iter().try_for_each(|item| reader.number(item).map(drop))?;
        }
        let unit = reader.unit()?;
        let list = items.iter().map(|item| item.strip_suffix(&unit).unwrap_or(item).trim().to_owned()).collect();
        Ok(Self { list, ..Self::new(key, unit) })
    }

    pub fn values(&self) -> Result<Vec<String>> {
        let Some(SearchRange { ends, count, spacing, .. }) = self.range else { return Ok(self.list.clone()) };
        let what = format!("{}: the range does not say how many values", self.key);
        let last = count.ok_or_else(|| StudyError::new(what, "write /N behind it: \"4..10 mm/7\""))? - 1;
        let at = |i: usize| if i == last { ends[1] } else { spacing.between(ends, i as f64 / last as f64) };
        Ok((0..=last).map(|i| written(at(i))).collect())
    }

    pub fn search_range(&self) -> Result<SearchRange> {
        let help = "write KEY=FROM..TO UNIT, such as \"blank.diameter=90..140 mm\"";
        self.range.ok_or_else(|| StudyError::new(format!("`{}` gives no range to search", self.key), help))
    }

    /// The override that sets a value, a number or a word.
    pub fn setting(&self, value: &str) -> String {
        let Self { key, unit, .. } = self;
        if number(value).is_none() { format!("{key}={value:?}") } else { with_unit(format!("{key}={value}"), unit) }
    }

    /// Column of a table: the key with its unit, `tools.die.shoulder_mm`.
    pub fn header(&self) -> String {
        let unit = self.unit.replace('/', "_per_").replace('%', "percent").replace('°', "deg").replace([' ', '^'], "");
        format!("{}_{unit}", self.key).trim_end_matches('_').to_owned()
    }

    pub fn display(&self, value: f64) -> String {
        let (unit, factor) = self.axis_unit();
        let is_us = DisplaySettings::current() == DisplaySettings::Us && unit != Unit::None;
        let amount = Amount::new(factor * value, unit, Digits::Significant(4));
        if is_us { amount.to_string() } else { with_unit(significant(value, 6).to_string(), &self.unit) }
    }

    /// Name for tables and axes; the key if it has none.
    pub fn label(&self) -> &str {
        name(&self.key).unwrap_or(&self.key)
    }

    /// Solver unit of an axis, and the factor from the variable's unit to it.
    pub fn axis_unit(&self) -> (Unit, f64) {
        Unit::of_header(&self.header()).unwrap_or((Unit::None, 1.0))
    }
}

fn name(key: &str) -> Option<&'static str> {
    include_str!("names.csv").lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(','))
}

pub(super) fn written(value: f64) -> String {
    significant(value, 12).to_string()
}

pub(super) fn with_unit(number: String, unit: &str) -> String {
    if unit.is_empty() { number } else { number + " " + unit }
}

pub(super) fn check_distinct<'a>(variables: impl Iterator<Item = &'a Variable>, what: &str, help: &str) -> Result<()> {
    let mut keys = BTreeSet::new();
    variables.map(|variable| &variable.key).try_for_each(|key| ensure(keys.insert(key), format!("{key} {what}"), help))
}

pub(super) fn in_words(text: &str) -> String {
    let known = split_pair(text).and_then(|(key, value)| Some((name(key)?, value)));
    known.map_or_else(|| text.to_owned(), |(name, value)| format!("{name} {}", value.trim_matches('"')))
}

pub(super) fn split_pair(text: &str) -> Option<(&str, &str)> {
    let (key, values) = text.split_once('=')?;
    Some((key.trim(), values.trim())).filter(|(key, values)| !key.is_empty() && !values.is_empty())
}

fn has_decimal_comma(list: &str) -> bool {
    let items: Vec<&str> = list.trim().split(',').collect();
    let digits = |item: &str| item.bytes().take_while(u8::is_ascii_digit).count();
    let is_share = items.len() == 2 && items[0] == "0" && digits(items[1]) > 0 && !items[1].contains('.');
    is_share || items[1..].iter().any(|item| item.starts_with('0') && digits(item) > 1)
}

pub(super) struct NumberReader<'a> {
    key: &'a str,
    text: &'a str,
    help: &'static str,
    pub unit: String,
}

impl<'a> NumberReader<'a> {
    /// Reader of a text in which a comma separates nothing.
    pub fn new(key: &'a str, text: &'a str, help: &'static str) -> Result<Self> {
        let is_decimal = |three: &[u8]| three[0].is_ascii_digit() && three[1] == b',' && three[2].is_ascii_digit();
        let (what, point) = (format!("{key}: a decimal comma in `{text}`"), text.replace(',', "."));
        ensure(!text.as_bytes().windows(3).any(is_decimal), what, format!("write a point: {point}"))?;
        Ok(Self { key, text, help, unit: String::new() })
    }

    pub fn wrong(&self, what: impl AsRef<str>) -> StudyError {
        StudyError::new(format!("{}: `{}` {}", self.key, self.text, what.as_ref()), self.help)
    }

    pub fn ensure(&self, holds: bool, what: impl AsRef<str>) -> Result<()> {
        if holds { Ok(()) } else { Err(self.wrong(what)) }
    }

    pub fn number(&mut self, text: &str) -> Result<f64> {
        let text = text.trim();
        let (number, unit) = split_number(text).ok_or_else(|| self.wrong(format!("has no number in `{text}`")))?;
        if self.unit.is_empty() {
            unit.clone_into(&mut self.unit);
        }
        self.ensure(unit.is_empty() || unit == self.unit, format!("has two units, {} and {unit}", self.unit))?;
        Ok(number)
    }

    /// The unit of all numbers, of those that case files have; "6 t" is six thicknesses of the sheet.
    pub fn unit(&self) -> Result<String> {
        let help = "write a unit of case files behind the values";
        match parse(&format!("1 {}", self.unit)) {
            Err(error) if self.unit != "t" => fail(format!("{}: {error}", self.key), help),
            _ => Ok(self.unit.clone()),
        }
    }
}

pub(super) fn number(text: &str) -> Option<f64> {
    text.replace('−', "-").parse().ok().filter(|x: &f64| x.is_finite())
}

pub(super) fn split_number(text: &str) -> Option<(f64, &str)> {
    let is_exponent = |rest: &str| rest.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit());
    let is_of_number = |(i, c): (usize, char)| {
        c.is_ascii_digit() || ".+-−".contains(c) || (matches!(c, 'e' | 'E') && is_exponent(&text[i + 1..]))
    };
    let end = text.char_indices().find(|&at| !is_of_number(at)).map_or(text.len(), |(i, _)| i);
    Some((number(&text[..end])?, text[end..].trim()))
}

pub(super) fn in_unit(text: &str, unit: &str) -> Option<f64> {
    let (number, own) = split_number(text.trim())?;
    if own == unit {
        return Some(number);
    }
    let [given, zero, one] = [text.to_owned(), format!("0 {unit}"), format!("1 {unit}")].map(|text| parse(&text).ok());
    let (given, zero, one) = (given?, zero?, one?);
    let is_alike = own.is_empty() == unit.is_empty() && given.dimension == one.dimension;
    is_alike.then_some((given.value - zero.value) / (one.value - zero.value))
}
