//! A key of a case and the values that a study gives it.
//!
//! ```text
//! KEY=FROM..TO UNIT/N         N values, evenly from FROM to TO           tools.die.shoulder=4..10 mm/7
//! KEY=FROM..TO UNIT/N log     N values, evenly in their logarithms       solver.contact_stiffness=3..300 GPa/5 log
//! KEY=A,B,C UNIT              these values                               friction=0.04,0.08,0.12
//! KEY=... & KEY=...           two keys that go together, one value each   blank.diameter=100..120 mm/3 & tools.punch.travel=30..36 mm/3
//! ```

use super::StudyError;
use crate::table::Spacing;
use crate::units::{parse, significant};

/// Digits of the values of a range: all that a user would have typed.
const DIGITS: usize = 12;

/// Fewest and most values of a range.
const COUNT: std::ops::RangeInclusive<usize> = 2..=1_000_000;

/// A key and its values.
#[derive(Clone, Debug, PartialEq)]
pub struct Vary {
    /// Dotted path of keys, as an override has it.
    pub key: String,
    /// Unit that all values are written in; empty for plain numbers and words.
    pub unit: String,
    /// At least one.
    pub values: Vec<Value>,
}

/// A value of a key.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// Without the unit: `4.5`, or a word such as the name of a sheet.
    pub text: String,
    /// As a number in [`Vary::unit`]; `None` of a word.
    pub number: Option<f64>,
}

impl Value {
    /// A number.
    pub fn number(number: f64) -> Self {
        let number = significant(number, DIGITS);
        Self { text: number.to_string(), number: Some(number) }
    }

    /// What the case has: nothing is written.
    pub fn as_it_stands() -> Self {
        Self { text: String::new(), number: None }
    }

    fn read(text: &str) -> Self {
        Self { text: text.to_owned(), number: text.replace('−', "-").parse().ok().filter(|x: &f64| x.is_finite()) }
    }
}

impl Vary {
    /// Reads keys that go together: `KEY=VALUES`, several of them joined by `&`.
    ///
    /// # Errors
    /// When something is missing, a range is empty, or keys that go together have not as many values.
    pub fn together(text: &str) -> Result<Vec<Self>, StudyError> {
        Self::as_many(text.split('&').map(Self::read).collect::<Result<_, _>>()?)
    }

    /// Keys that go together.
    ///
    /// # Errors
    /// When they have not as many values.
    pub fn as_many(keys: Vec<Self>) -> Result<Vec<Self>, StudyError> {
        if let Some(other) = keys.iter().find(|other| other.values.len() != keys[0].values.len()) {
            let [a, b] = [&keys[0], other].map(|vary| counted(&vary.key, vary.values.len()));
            return Err(StudyError::new(format!("{a} but {b}"), "keys that go together have as many"));
        }
        Ok(keys)
    }

    fn read(text: &str) -> Result<Self, StudyError> {
        let usage = "write KEY=FROM..TO UNIT/N or KEY=A,B,C UNIT, such as \"tools.die.shoulder=4..10 mm/7\"";
        let (key, values) = text
            .split_once('=')
            .map(|(key, values)| (key.trim(), values.trim()))
            .filter(|(key, values)| !key.is_empty() && !values.is_empty())
            .ok_or_else(|| StudyError::new(format!("`{}` gives no key values", text.trim()), usage))?;
        Self::of(key, values)
    }

    /// The values that a text gives a key.
    ///
    /// # Errors
    /// When a range has no count, no width or two units.
    pub fn of(key: &str, values: &str) -> Result<Self, StudyError> {
        match values.split_once("..") {
            Some((from, rest)) => {
                pointed(key, values)?;
                Self::range(key, values, from, rest)
            }
            None => Self::list(key, values),
        }
    }

    fn range(key: &str, written: &str, from: &str, rest: &str) -> Result<Self, StudyError> {
        let wrong = |what: &str| {
            let help = "a range is FROM..TO UNIT/N with two values or more: \"4..10 mm/7\", or with `log` behind it";
            StudyError::new(format!("{key}: the range `{written}` {what}"), help)
        };
        let (to, count) = rest.rsplit_once('/').ok_or_else(|| wrong("does not say how many values"))?;
        let (count, is_log) = match count.trim().strip_suffix("log") {
            Some(count) => (count.trim(), true),
            None => (count.trim(), false),
        };
        let count: usize = count.parse().map_err(|_| wrong("does not say how many values"))?;
        if !COUNT.contains(&count) {
            return Err(wrong(&format!("has {count} values, not {} to {}", COUNT.start(), COUNT.end())));
        }
        let (low, low_unit) = split(from.trim()).ok_or_else(|| wrong("does not begin with a number"))?;
        let (high, unit) = split(to.trim()).ok_or_else(|| wrong("does not end with a number"))?;
        if !low_unit.is_empty() && low_unit != unit {
            return Err(wrong(&format!(
                "has two units, {low_unit} and {}",
                if unit.is_empty() { "none" } else { unit }
            )));
        }
        if low == high {
            return Err(wrong("has no width"));
        }
        if is_log && low.min(high) <= 0.0 {
            return Err(wrong("has no logarithms: both ends must be above 0"));
        }
        known(key, unit)?;
        let at = |i: usize| match (i, i as f64 / (count - 1) as f64) {
            (0, _) => low,
            (i, _) if i + 1 == count => high,
            (_, share) => Spacing::of(is_log).between([low, high], share),
        };
        Ok(Self { key: key.into(), unit: unit.into(), values: (0..count).map(|i| Value::number(at(i))).collect() })
    }

    fn list(key: &str, written: &str) -> Result<Self, StudyError> {
        let items: Vec<&str> = written.split(',').map(|item| item.trim().trim_matches('"')).collect();
        let wrong = |what: String| {
            StudyError::new(
                format!("{key}: {what} in `{written}`"),
                "write A,B,C with one unit behind all: \"4,6,8 mm\"",
            )
        };
        if let Some(point) = with_point(written) {
            let what = format!("{key}: a decimal comma, or two values, in `{written}`");
            return Err(StudyError::new(
                what,
                format!("write a point, {point}, or a blank behind a comma between values"),
            ));
        }
        if items.iter().any(|item| item.is_empty()) {
            return Err(wrong("a value is missing".into()));
        }
        let Some(numbers) = items.iter().map(|item| split(item)).collect::<Option<Vec<_>>>() else {
            return Ok(Self {
                key: key.into(),
                unit: String::new(),
                values: items.into_iter().map(Value::read).collect(),
            });
        };
        let unit = numbers.last().map_or("", |(_, unit)| unit);
        if let Some((_, other)) = numbers.iter().find(|(_, other)| !other.is_empty() && *other != unit) {
            return Err(wrong(format!(
                "there are two units, {other} and {}",
                if unit.is_empty() { "none" } else { unit }
            )));
        }
        known(key, unit)?;
        let plain = |item: &str| Value::read(item.strip_suffix(unit).unwrap_or(item).trim());
        Ok(Self { key: key.into(), unit: unit.into(), values: items.into_iter().map(plain).collect() })
    }

    /// The override that sets the key: `tools.die.shoulder=4.5 mm`.
    pub fn setting(&self, value: &Value) -> String {
        match (&value.number, self.unit.as_str()) {
            (None, _) => format!("{}={:?}", self.key, value.text),
            (_, "") => format!("{}={}", self.key, value.text),
            (_, unit) => format!("{}={} {unit}", self.key, value.text),
        }
    }

    /// The key with its unit as in the header of a CSV file: `tools.die.shoulder_mm`.
    pub fn header(&self) -> String {
        let unit = self.unit.replace('/', "_per_").replace('%', "percent").replace('°', "deg").replace([' ', '^'], "");
        if unit.is_empty() { self.key.clone() } else { format!("{}_{unit}", self.key) }
    }
}

/// A number and the unit behind it; `None` where a word stands.
pub(super) fn split(text: &str) -> Option<(f64, &str)> {
    let is_of_number = |(i, c): (usize, char)| {
        c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | '−') || (matches!(c, 'e' | 'E') && exponent(&text[i + 1..]))
    };
    let end = text.char_indices().find(|&at| !is_of_number(at)).map_or(text.len(), |(i, _)| i);
    let number: f64 = text[..end].replace('−', "-").parse().ok()?;
    number.is_finite().then(|| (number, text[end..].trim()))
}

/// Refuses a decimal comma where no comma can stand.
pub(super) fn pointed(key: &str, text: &str) -> Result<(), StudyError> {
    let is_digit = |part: &str, last: bool| {
        let end = if last { part.chars().next_back() } else { part.chars().next() };
        end.is_some_and(|c| c.is_ascii_digit())
    };
    let parts: Vec<&str> = text.split(',').collect();
    match parts.windows(2).any(|pair| is_digit(pair[0], true) && is_digit(pair[1], false)) {
        true => Err(StudyError::new(
            format!("{key}: a decimal comma in `{text}`"),
            format!("write a point: {}", parts.join(".")),
        )),
        false => Ok(()),
    }
}

/// A list that is rather a number with a decimal comma, `0,04` or `1,05 mm`, with a point: behind a comma without a blank nobody
/// writes a value as `04`, and two values of which the first is `0` are asked about.
fn with_point(list: &str) -> Option<String> {
    let parts: Vec<&str> = list.trim().split(',').collect();
    let is_whole = |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_digit());
    let decimals = |part: &str| part.len() - part.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let is_decimal = |pair: &[&str]| {
        let digits = decimals(pair[1]);
        let is_padded = digits > 1 && pair[1].starts_with('0') && !pair[1][digits..].starts_with('.');
        let is_share = parts.len() == 2 && pair[0] == "0" && digits > 0 && !pair[1][digits..].starts_with('.');
        is_whole(pair[0].trim_start().trim_start_matches(['-', '−'])) && (is_padded || is_share)
    };
    parts.windows(2).any(is_decimal).then(|| if parts.len() == 2 { parts.join(".") } else { "0.04".to_owned() })
}

/// Whether what stands behind an `e` is a power of ten.
fn exponent(rest: &str) -> bool {
    rest.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit())
}

/// A unit is one of case files.
pub(super) fn known(key: &str, unit: &str) -> Result<(), StudyError> {
    match parse(&format!("1 {unit}")) {
        Ok(_) => Ok(()),
        // "6 t" is six thicknesses of the sheet, which the case knows.
        Err(_) if unit == "t" => Ok(()),
        Err(error) => Err(StudyError::new(format!("{key}: {error}"), "write a unit of case files behind the values")),
    }
}

/// `friction has 1 value`
pub(super) fn counted(key: &str, values: usize) -> String {
    format!("{key} has {values} value{}", if values == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn settings(text: &str) -> Vec<Vec<String>> {
        let keys = Vary::together(text).unwrap_or_else(|error| panic!("{error}"));
        keys.iter().map(|vary| vary.values.iter().map(|value| vary.setting(value)).collect()).collect()
    }

    /// Trust: by hand.
    #[test]
    fn ranges_lists_and_pairs_give_the_overrides_that_a_user_would_type() {
        assert_eq!(settings("a.b=4..10 mm/4"), [["a.b=4 mm", "a.b=6 mm", "a.b=8 mm", "a.b=10 mm"]]);
        assert_eq!(settings("k=0.1 .. 0.3/3"), [["k=0.1", "k=0.2", "k=0.3"]]);
        assert_eq!(settings("k=1..100 GPa/3 log"), [["k=1 GPa", "k=10 GPa", "k=100 GPa"]]);
        assert_eq!(settings("friction=0.04,0.08,0.12"), [["friction=0.04", "friction=0.08", "friction=0.12"]]);
        assert_eq!(settings("f=0, 10 kN"), [["f=0 kN", "f=10 kN"]]);
        assert_eq!(settings("f=0,5,10 kN"), [["f=0 kN", "f=5 kN", "f=10 kN"]]);
        assert_eq!(settings("r=4, 6, 8 mm"), [["r=4 mm", "r=6 mm", "r=8 mm"]]);
        assert_eq!(settings("material=dc04,\"dc06\""), [["material=\"dc04\"", "material=\"dc06\""]]);
        assert_eq!(settings("f=1e3,2E+3 N"), [["f=1e3 N", "f=2E+3 N"]]);
        assert_eq!(
            settings("a=1..3 mm/3 & b=2,4,6 kN"),
            [["a=1 mm", "a=2 mm", "a=3 mm"], ["b=2 kN", "b=4 kN", "b=6 kN"]]
        );
        let header = |text: &str| Vary::together(text).expect("keys")[0].header();
        assert_eq!(header("a.b=1,2 N/mm"), "a.b_N_per_mm");
        assert_eq!(header("friction=0.1,0.2"), "friction");
    }

    /// Trust: each is wrong in the way that its message says.
    #[test]
    fn what_is_no_range_or_list_is_told() {
        for (text, said) in [
            ("tools.die.shoulder", "gives no key values"),
            ("a=4..10 mm", "does not say how many"),
            ("a=4..10 mm/1", "has 1 values"),
            ("a=4..4 mm/3", "has no width"),
            ("a=4 in..10 mm/3", "has two units, in and mm"),
            ("a=0..10 mm/3 log", "has no logarithms"),
            ("a=4..10 mmm/3", "mmm"),
            ("a=4,,6 mm", "a value is missing"),
            ("a=4 in,6 mm", "two units"),
            ("a=1,2 & b=1,2,3", "a has 2 values but b has 3 values"),
            ("a=1 & b=1,2", "a has 1 value but b has 2 values"),
            ("a=x..3/4", "does not begin with a number"),
            ("friction=0,04", "a decimal comma, or two values, in `0,04`\n  help: write a point, 0.04"),
            ("t=1,03 mm", "write a point, 1.03 mm"),
            ("friction=0,04,0,08", "a decimal comma"),
            ("friction=0,04..0,12/3", "a decimal comma in `0,04..0,12/3`\n  help: write a point: 0.04..0.12/3"),
        ] {
            let error = Vary::together(text).expect_err(text).to_string();
            assert!(error.contains(said), "{text}: {error}");
        }
    }
}
