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

use super::{Run, RunTable, StudyError, fail};
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
    Light { row: Option<String>, worst: Light },
    NoTear,
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
        for term in &mut self.terms {
            match term {
                Term::Quantity(comparison) => comparison.resolve(runs)?,
                Term::Light { row: Some(row), .. } if !runs.rows.iter().any(|(key, _)| key == row) => {
                    let keys = || runs.rows.iter().map(|(key, _)| key.as_str());
                    let help = format!("{}it has {}", did_you_mean(row, keys()), keys().collect::<Vec<_>>().join(", "));
                    return fail(format!("the verdict on this case has no row `{row}`"), help);
                }
                Term::Light { .. } | Term::NoTear => {}
            }
        }
        Ok(())
    }

    /// Whether a run satisfies it; `None` if it has no result or lacks a number.
    pub fn holds(&self, run: &Run) -> Option<bool> {
        let all: Vec<Option<bool>> = self.terms.iter().map(|term| term.holds(run)).collect();
        match run.is_known() {
            true if all.contains(&Some(false)) => Some(false),
            true if !all.contains(&None) => Some(true),
            _ => None,
        }
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
        let words: Vec<&str> = text.split_whitespace().collect();
        let worst = |words: &[&str]| match words {
            ["red"] => Some(Light::Red),
            ["amber"] | ["red", "or", "amber"] | ["amber", "or", "red"] => Some(Light::Amber),
            _ => None,
        };
        if let ["no", "tear" | "tears" | "tearing"] = words[..] {
            return Ok(Self::NoTear);
        }
        if let Some(worst) = words.strip_prefix(&["no"]).and_then(worst) {
            return Ok(Self::Light { row: None, worst });
        }
        if let Some(at) = words.iter().position(|word| *word == "not") {
            let row: Vec<&str> = words[..at].iter().filter(|word| **word != "is").copied().collect();
            let worst = worst(&words[at + 1..]).filter(|_| !row.is_empty()).ok_or_else(wrong)?;
            return Ok(Self::Light { row: Some(row.join("_").to_lowercase()), worst });
        }
        let (name, rest) = text.split_at(text.find(['<', '>', '≤', '≥']).ok_or_else(wrong)?);
        let value = rest.trim_start_matches(['<', '>', '≤', '≥']);
        let (is_less, or_equal) =
            (rest.starts_with(['<', '≤']), value.starts_with('=') || rest.starts_with(['≤', '≥']));
        let comparison = Comparison::new(name, value.trim_start_matches('='))?.ok_or_else(wrong)?;
        Ok(Self::Quantity(Comparison { is_less, or_equal, ..comparison }))
    }
}

impl Comparison {
    /// Reads `QUANTITY=VALUE`, a wanted value.
    pub fn target(text: &str) -> Result<Self, StudyError> {
        let wrong =
            || StudyError::new(format!("`{text}` is no target"), "write QUANTITY=VALUE UNIT, such as \"draw_in=8 mm\"");
        let (quantity, value) = text.split_once('=').ok_or_else(wrong)?;
        Self::new(quantity, value)?.ok_or_else(wrong)
    }

    fn new(quantity: &str, value: &str) -> Result<Option<Self>, StudyError> {
        let (quantity, value) = (quantity.trim().to_owned(), value.trim());
        let value = if value.ends_with("°C") { value.to_owned() } else { value.replace('°', " deg") };
        let limit = parse(&value)
            .map_err(|error| StudyError::new(error.to_string(), "write a number with a unit, such as 20 % or 60 kN"))?;
        let is_named = !quantity.is_empty();
        Ok(is_named.then_some(Self { quantity, is_less: false, or_equal: true, limit, resolved: None }))
    }

    /// Finds its response and converts its value to the response's unit.
    pub fn resolve(&mut self, runs: &RunTable) -> Result<(), StudyError> {
        let place = runs.response(&self.quantity)?;
        let unit = runs.responses[place].quantity.amount.unit;
        let symbol = match unit {
            Unit::None => "",
            Unit::Degree => "deg",
            unit => unit.symbol(),
        };
        let given = self.limit;
        let one = parse(format!("1 {symbol}").trim_end()).ok();
        let Some(one) = one.filter(|one| one.dimension == given.dimension && one.has_unit == given.has_unit) else {
            let what = format!("`{}` is in {}, not {}", self.quantity, unit.symbol(), given.dimension.describe());
            return fail(what, format!("write the value as \"{}\"", format!("1.5 {symbol}").trim_end()));
        };
        let value = if unit == Unit::Celsius { given.value - ZERO_CELSIUS } else { given.value / one.value };
        self.resolved = Some((place, value));
        Ok(())
    }
}
