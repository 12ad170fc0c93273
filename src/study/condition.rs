//! Conditions on a run: `no red`, `thinning < 20 % and punch_force <= 60 kN`.
//!
//! ```text
//! no red                 no row of the verdict is red            no red or amber
//! ROW not red            that row is not                         wrinkling not red or amber
//! no tear                the sheet does not tear
//! no wrinkles            no row on wrinkles is red
//! QUANTITY < LIMIT       <, <=, >, >= of a number of the run      draw_in >= 8 mm
//! ... and ...            all of them
//! ```
//!
//! Runs in which the sheet tears never satisfy a condition on a quantity.

use super::*;

/// A condition on a run, or the target of a search.
#[derive(Clone, Debug)]
pub struct Condition {
    pub(super) text: String,
    terms: Vec<Term>,
}

type Comparison = fn(&f64, &f64) -> bool;

/// A quantity is resolved to the place of its response, and the limit in its unit.
#[derive(Clone, Debug)]
enum Term {
    Without(FailureMode),
    Light { row: Option<String>, worst: Light },
    Quantity { name: String, compare: Comparison, limit: String, resolved: Option<(usize, f64)> },
}

const COMPARISONS: [(&str, Comparison); 6] =
    [("<=", f64::le), ("≤", f64::le), (">=", f64::ge), ("≥", f64::ge), ("<", f64::lt), (">", f64::gt)];
const USAGE: &str = "write \"no red\", \"no red or amber\", \"no tear\", \"no wrinkles\", \"ROW not red\" or \"QUANTITY < LIMIT\", \
                     several joined by `and`, such as \"no red and thinning < 20 %\"";

impl Condition {
    /// Reads a condition.
    pub fn read(text: &str) -> Result<Self> {
        let terms = text.split(" and ").map(Term::read).collect::<Result<_, _>>()?;
        Ok(Self { text: text.split_whitespace().collect::<Vec<_>>().join(" "), terms })
    }

    pub(super) fn target(text: &str) -> Result<Self> {
        let help = "write QUANTITY=VALUE UNIT, such as \"draw_in=8 mm\"";
        let (name, value) = split_pair(text).ok_or_else(|| StudyError::new(format!("`{text}` is no target"), help))?;
        Ok(Self { text: name.to_owned(), terms: vec![Term::quantity(name, value, f64::eq)?] })
    }

    /// Finds its quantities and rows among those of a study's runs.
    pub fn resolve(&mut self, runs: &RunTable) -> Result<()> {
        self.terms.iter_mut().try_for_each(|term| term.resolve(runs))
    }

    /// Whether a run satisfies it; `None` if it has no result or lacks a number.
    pub fn holds(&self, run: &Run) -> Option<bool> {
        let all: Vec<Option<bool>> = self.terms.iter().map(|term| term.holds(run)).collect();
        let known = if all.contains(&Some(false)) { Some(false) } else { (!all.contains(&None)).then_some(true) };
        known.filter(|_| run.is_known())
    }

    pub(super) fn limits(&self) -> Vec<(usize, f64)> {
        let limit = |term: &Term| if let Term::Quantity { resolved, .. } = term { *resolved } else { None };
        self.terms.iter().filter_map(limit).collect()
    }
}

impl Term {
    fn holds(&self, run: &Run) -> Option<bool> {
        match self {
            Self::Without(mode) => Some(!run.failures.contains(mode)),
            Self::Light { row, worst } => {
                let has = |rows: &[String]| rows.iter().any(|key| row.as_ref().is_none_or(|row| row == key));
                Some(!(has(&run.red) || *worst == Light::Amber && has(&run.amber)))
            }
            Self::Quantity { .. } if run.tears() => Some(false),
            Self::Quantity { compare, resolved, .. } => {
                let (place, limit) = (*resolved)?;
                run.response(place).map(|value| compare(&value, &limit))
            }
        }
    }

    fn read(text: &str) -> Result<Self> {
        let wrong = || StudyError::new(format!("`{}` is no condition", text.trim()), USAGE);
        let light = |row: Option<String>, words: &[&str]| match words {
            ["red"] => Ok(Self::Light { row, worst: Light::Red }),
            ["amber"] | ["red", "or", "amber"] | ["amber", "or", "red"] => Ok(Self::Light { row, worst: Light::Amber }),
            _ => Err(wrong()),
        };
        let words: Vec<&str> = text.split_whitespace().filter(|word| *word != "is").collect();
        match (&words[..], words.iter().position(|word| *word == "not")) {
            (["no", "tear" | "tears" | "tearing"], _) => return Ok(Self::Without(FailureMode::Tears)),
            (["no", "wrinkle" | "wrinkles"], _) => return Ok(Self::Without(FailureMode::Wrinkles)),
            (["no", light_words @ ..], _) => return light(None, light_words),
            (_, Some(at)) if at > 0 => return light(Some(words[..at].join("_").to_lowercase()), &words[at + 1..]),
            _ => {}
        }
        let split = |(sign, compare): &(&str, Comparison)| text.split_once(sign).map(|pair| (pair, *compare));
        match COMPARISONS.iter().find_map(split) {
            Some(((name, value), compare)) if !name.trim().is_empty() => Self::quantity(name, value, compare),
            _ => Err(wrong()),
        }
    }

    fn quantity(name: &str, value: &str, compare: Comparison) -> Result<Self> {
        let value = value.trim();
        let limit = if value.ends_with("°C") { value.to_owned() } else { value.replace('°', " deg") };
        let help = "write a number with a unit, such as 20 % or 60 kN";
        parse(&limit).map_err(|error| StudyError::new(error.to_string(), help))?;
        Ok(Self::Quantity { name: name.trim().to_owned(), compare, limit, resolved: None })
    }

    fn resolve(&mut self, runs: &RunTable) -> Result<()> {
        match self {
            Self::Quantity { name, limit, resolved, .. } => {
                let place = runs.response(name)?;
                let unit = runs.responses[place].quantity.amount.unit;
                let symbol = match unit {
                    Unit::None | Unit::Thicknesses => "",
                    Unit::Degree => "deg",
                    unit => unit.symbol(),
                };
                let what = format!("`{name}` is in {}, not `{limit}`", unit.symbol());
                let help = format!("write the value as \"{}\"", format!("1.5 {symbol}").trim_end());
                *resolved = Some((place, in_unit(limit, symbol).ok_or_else(|| StudyError::new(what, help))?));
                Ok(())
            }
            Self::Light { row: Some(row), .. } => {
                let keys: Vec<&str> = runs.rows.iter().map(|(key, _)| key.as_str()).collect();
                let help = format!("{}it has {}", did_you_mean(row, keys.iter().copied()), keys.join(", "));
                ensure(keys.contains(&row.as_str()), format!("the verdict on this case has no row `{row}`"), help)
            }
            Self::Light { row: None, .. } | Self::Without(_) => Ok(()),
        }
    }
}
