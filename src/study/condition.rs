//! Conditions on a run: `no red`, `thinning < 20 % and punch_force <= 60 kN`.
//!
//! ```text
//! no red                 no row of the verdict is red            no red or amber
//! ROW not red            that row is not                         wrinkling not red or amber
//! no tear                the sheet does not tear
//! QUANTITY < LIMIT       <, <=, >, >= of a number of the run      draw_in >= 8 mm
//! ... and ...            all of them
//! ```
//!
//! Runs in which the sheet tears never satisfy a condition on a quantity.

use super::{Run, RunTable, StudyError};
use crate::assess::Light;
use crate::units::{Parsed, Unit, ZERO_CELSIUS, did_you_mean, parse};

/// A condition on a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Text as written.
    pub text: String,
    terms: Vec<Term>,
}

#[derive(Clone, Debug, PartialEq)]
enum Term {
    Light { row: Option<String>, worst: Light },
    NoTear,
    Quantity(Comparison),
}

/// A quantity and the value that it is compared with.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Name of the quantity.
    pub quantity: String,
    is_less: bool,
    or_equal: bool,
    limit: Parsed,
    /// Place of the response, and the limit in its unit, once they are known.
    resolved: Option<(usize, f64)>,
}

const USAGE: &str = "write \"no red\", \"no red or amber\", \"no tear\", \"ROW not red\" or \"QUANTITY < LIMIT\", \
                     several joined by `and`, such as \"no red and thinning < 20 %\"";

impl Condition {
    /// Reads a condition.
    ///
    /// # Errors
    /// When a part of it is none.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let terms = text.split(" and ").map(term).collect::<Result<_, _>>()?;
        Ok(Self { text: text.split_whitespace().collect::<Vec<_>>().join(" "), terms })
    }

    /// Finds its quantities and rows among those of a study's runs.
    ///
    /// # Errors
    /// When one is missing, or its limit has another unit.
    pub fn resolve(&mut self, runs: &RunTable) -> Result<(), StudyError> {
        for term in &mut self.terms {
            match term {
                Term::Quantity(comparison) => drop(comparison.resolve(runs)?),
                Term::Light { row: Some(row), .. } if !runs.rows.iter().any(|(key, _)| key == row) => {
                    let keys = || runs.rows.iter().map(|(key, _)| key.as_str());
                    let help = format!("{}it has {}", did_you_mean(row, keys()), keys().collect::<Vec<_>>().join(", "));
                    return Err(StudyError::new(format!("the verdict on this case has no row `{row}`"), help));
                }
                Term::Light { .. } | Term::NoTear => {}
            }
        }
        Ok(())
    }

    /// Whether a run satisfies it; `None` if it has no result or lacks a number.
    pub fn holds(&self, run: &Run) -> Option<bool> {
        if !run.is_known() {
            return None;
        }
        let mut all = Some(true);
        for term in &self.terms {
            match term.holds(run) {
                Some(false) => return Some(false),
                Some(true) => {}
                None => all = None,
            }
        }
        all
    }

    /// Places of its responses, each with the limit.
    pub fn limits(&self) -> impl Iterator<Item = (usize, f64)> {
        self.terms.iter().filter_map(|term| match term {
            Term::Quantity(comparison) => comparison.resolved,
            _ => None,
        })
    }
}

impl Term {
    fn holds(&self, run: &Run) -> Option<bool> {
        match self {
            Self::NoTear => Some(!run.tears()),
            Self::Light { row, worst } => {
                let has = |rows: &[String]| rows.iter().any(|key| row.as_ref().is_none_or(|row| row == key));
                Some(!(has(&run.red) || *worst == Light::Amber && has(&run.amber)))
            }
            Self::Quantity(_) if run.tears() => Some(false),
            Self::Quantity(comparison) => {
                let (place, limit) = comparison.resolved?;
                let value = run.numbers[place];
                match value == limit {
                    _ if !value.is_finite() => None,
                    true => Some(comparison.or_equal),
                    false => Some((value < limit) == comparison.is_less),
                }
            }
        }
    }
}

impl Comparison {
    /// Reads `QUANTITY=VALUE`, a wanted value.
    ///
    /// # Errors
    /// When there is no name, or no value with a unit.
    pub fn target(text: &str) -> Result<Self, StudyError> {
        let wrong =
            || StudyError::new(format!("`{text}` is no target"), "write QUANTITY=VALUE UNIT, such as \"draw_in=8 mm\"");
        let (quantity, value) = text.split_once('=').ok_or_else(wrong)?;
        Self::new(quantity, quantity_of(value)?).ok_or_else(wrong)
    }

    fn new(quantity: &str, limit: Parsed) -> Option<Self> {
        let quantity = quantity.trim().to_owned();
        (!quantity.is_empty()).then_some(Self { quantity, is_less: false, or_equal: true, limit, resolved: None })
    }

    /// Finds its response and converts its value to the response's unit.
    ///
    /// # Errors
    /// When no run has the quantity, or the value is of another dimension.
    pub fn resolve(&mut self, runs: &RunTable) -> Result<(usize, f64), StudyError> {
        let place = runs.response(&self.quantity)?;
        let unit = runs.responses[place].number.quantity.amount.unit;
        let symbol = if unit == Unit::Degree { "deg" } else { unit.symbol() };
        let one = if unit == Unit::None { parse("1") } else { parse(&format!("1 {symbol}")) };
        let given = self.limit;
        let one = one.ok().filter(|one| one.dimension == given.dimension && one.has_unit == given.has_unit);
        let value = match (one, unit) {
            (Some(_), Unit::Celsius) => given.value - ZERO_CELSIUS,
            (Some(one), _) => given.value / one.value,
            (None, _) => {
                let example = if unit == Unit::None { "1.5".to_owned() } else { format!("1.5 {symbol}") };
                let what = format!("`{}` is in {symbol}, not {}", self.quantity, given.dimension.describe());
                return Err(StudyError::new(what, format!("write the value as \"{example}\"")));
            }
        };
        self.resolved = Some((place, value));
        Ok((place, value))
    }
}

fn term(text: &str) -> Result<Term, StudyError> {
    let wrong = || StudyError::new(format!("`{}` is no condition", text.trim()), USAGE);
    let words: Vec<&str> = text.split_whitespace().collect();
    let worst = |words: &[&str]| match words {
        ["red"] => Some(Light::Red),
        ["amber"] | ["red", "or", "amber"] | ["amber", "or", "red"] => Some(Light::Amber),
        _ => None,
    };
    if let ["no", "tear" | "tears" | "tearing"] = words[..] {
        return Ok(Term::NoTear);
    }
    if let Some(worst) = words.strip_prefix(&["no"]).and_then(worst) {
        return Ok(Term::Light { row: None, worst });
    }
    if let Some(at) = words.iter().position(|word| *word == "not") {
        let row =
            words[..at].iter().filter(|word| **word != "is").copied().collect::<Vec<_>>().join("_").to_lowercase();
        let worst = worst(&words[at + 1..]).filter(|_| !row.is_empty()).ok_or_else(wrong)?;
        return Ok(Term::Light { row: Some(row), worst });
    }
    let at = text.find(['<', '>', '≤', '≥']).ok_or_else(wrong)?;
    let (name, rest) = text.split_at(at);
    let sign = rest.chars().next().unwrap_or('<');
    let rest = &rest[sign.len_utf8()..];
    let (or_equal, value) = match rest.strip_prefix('=') {
        Some(value) => (true, value),
        None => (matches!(sign, '≤' | '≥'), rest),
    };
    let comparison = Comparison::new(name, quantity_of(value)?).ok_or_else(wrong)?;
    Ok(Term::Quantity(Comparison { is_less: matches!(sign, '<' | '≤'), or_equal, ..comparison }))
}

fn quantity_of(text: &str) -> Result<Parsed, StudyError> {
    let text = text.trim();
    let text = if text.ends_with("°C") { text.to_owned() } else { text.replace('°', " deg") };
    parse(&text)
        .map_err(|error| StudyError::new(error.to_string(), "write a number with a unit, such as 20 % or 60 kN"))
}
