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

use super::error::ensure;
use super::variable::split_pair;
use super::{Run, RunTable, StudyError};
use crate::assess::Light;
use crate::units::{Parsed, Unit, ZERO_CELSIUS, did_you_mean, parse};

/// A condition on a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    pub(super) text: String,
    terms: Vec<Term>,
}

#[derive(Clone, Debug, PartialEq)]
enum Term {
    NoTear,
    Light { row: Option<String>, worst: Light },
    Quantity(Comparison),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Comparison {
    pub quantity: String,
    is_less: bool,
    or_equal: bool,
    limit: Parsed,
    /// Place of the response, and the limit in its unit, once they are known.
    pub resolved: Option<(usize, f64)>,
}

const USAGE: &str = "write \"no red\", \"no red or amber\", \"no tear\", \"ROW not red\" or \"QUANTITY < LIMIT\", \
                     several joined by `and`, such as \"no red and thinning < 20 %\"";

impl Condition {
    /// Reads a condition.
    pub fn read(text: &str) -> Result<Self, StudyError> {
        let terms = text.split(" and ").map(Term::read).collect::<Result<_, _>>()?;
        Ok(Self { text: text.split_whitespace().collect::<Vec<_>>().join(" "), terms })
    }

    /// Finds its quantities and rows among those of a study's runs.
    pub fn resolve(&mut self, runs: &RunTable) -> Result<(), StudyError> {
        self.terms.iter_mut().try_for_each(|term| match term {
            Term::Quantity(comparison) => comparison.resolve(runs),
            Term::Light { row: Some(row), .. } => {
                let keys: Vec<&str> = runs.rows.iter().map(|(key, _)| key.as_str()).collect();
                let help = format!("{}it has {}", did_you_mean(row, keys.iter().copied()), keys.join(", "));
                ensure(keys.contains(&row.as_str()), format!("the verdict on this case has no row `{row}`"), help)
            }
            Term::Light { row: None, .. } | Term::NoTear => Ok(()),
        })
    }

    /// Whether a run satisfies it; `None` if it has no result or lacks a number.
    pub fn holds(&self, run: &Run) -> Option<bool> {
        let all: Vec<Option<bool>> = self.terms.iter().map(|term| term.holds(run)).collect();
        let known = if all.contains(&Some(false)) { Some(false) } else { (!all.contains(&None)).then_some(true) };
        known.filter(|_| run.is_known())
    }

    pub(super) fn limits(&self) -> Vec<(usize, f64)> {
        let limit = |term: &Term| if let Term::Quantity(comparison) = term { comparison.resolved } else { None };
        self.terms.iter().filter_map(limit).collect()
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
                let value = run.response(place)?;
                Some(if value == limit { comparison.or_equal } else { (value < limit) == comparison.is_less })
            }
        }
    }

    fn read(text: &str) -> Result<Self, StudyError> {
        let wrong = || StudyError::new(format!("`{}` is no condition", text.trim()), USAGE);
        let words: Vec<&str> = text.split_whitespace().filter(|word| *word != "is").collect();
        let worst = |words: &[&str]| match words {
            ["red"] => Ok(Light::Red),
            ["amber"] | ["red", "or", "amber"] | ["amber", "or", "red"] => Ok(Light::Amber),
            _ => Err(wrong()),
        };
        match words.iter().position(|word| *word == "not") {
            _ if matches!(words[..], ["no", "tear" | "tears" | "tearing"]) => return Ok(Self::NoTear),
            _ if words.first() == Some(&"no") => return Ok(Self::Light { row: None, worst: worst(&words[1..])? }),
            Some(at) if at > 0 => {
                let row = Some(words[..at].join("_").to_lowercase());
                return Ok(Self::Light { row, worst: worst(&words[at + 1..])? });
            }
            _ => {}
        }
        let at = text.find(['<', '>', '≤', '≥']).filter(|at| !text[..*at].trim().is_empty()).ok_or_else(wrong)?;
        let (name, rest) = text.split_at(at);
        let value = rest.trim_start_matches(['<', '>', '≤', '≥']);
        let or_equal = value.starts_with('=') || rest.starts_with(['≤', '≥']);
        let comparison = Comparison::new(name, value.trim_start_matches('='))?;
        Ok(Self::Quantity(Comparison { is_less: rest.starts_with(['<', '≤']), or_equal, ..comparison }))
    }
}

impl Comparison {
    /// Reads `QUANTITY=VALUE`, a wanted value.
    pub fn target(text: &str) -> Result<Self, StudyError> {
        let help = "write QUANTITY=VALUE UNIT, such as \"draw_in=8 mm\"";
        let pair = split_pair(text).ok_or_else(|| StudyError::new(format!("`{text}` is no target"), help));
        pair.and_then(|(quantity, value)| Self::new(quantity, value))
    }

    fn new(quantity: &str, value: &str) -> Result<Self, StudyError> {
        let value = if value.ends_with("°C") { value.to_owned() } else { value.replace('°', " deg") };
        let limit = parse(value.trim())
            .map_err(|error| StudyError::new(error.to_string(), "write a number with a unit, such as 20 % or 60 kN"))?;
        Ok(Self { quantity: quantity.trim().to_owned(), is_less: false, or_equal: true, limit, resolved: None })
    }

    /// Finds its response and converts its value to the response's unit.
    pub fn resolve(&mut self, runs: &RunTable) -> Result<(), StudyError> {
        let place = runs.response(&self.quantity)?;
        let (unit, given) = (runs.responses[place].quantity.amount.unit, self.limit);
        let symbol = match unit {
            Unit::None | Unit::Thicknesses => "",
            Unit::Degree => "deg",
            unit => unit.symbol(),
        };
        let one = parse(format!("1 {symbol}").trim_end()).ok();
        let one = one.filter(|one| one.dimension == given.dimension && one.has_unit == given.has_unit);
        let what = format!("`{}` is in {}, not {}", self.quantity, unit.symbol(), given.dimension.describe());
        let help = format!("write the value as \"{}\"", format!("1.5 {symbol}").trim_end());
        let one = one.ok_or_else(|| StudyError::new(what, help))?;
        let value = if unit == Unit::Celsius { given.value - ZERO_CELSIUS } else { given.value / one.value };
        self.resolved = Some((place, value));
        Ok(())
    }
}
