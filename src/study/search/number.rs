//! A number of a run by one of its names.

use crate::study::row::header;
use crate::study::verify::Number;
use crate::study::{Solved, StudyError};
use crate::units::{Parsed, Unit, ZERO_CELSIUS, did_you_mean, parse};

/// A number of a run, by its key, its column of `study.csv` or what tables call it.
#[derive(Clone, Debug, PartialEq)]
pub struct Named {
    /// As it was written.
    pub text: String,
    /// In lower case, with _ between its words.
    key: String,
}

impl Named {
    /// Reads a name; `None` of an empty one.
    pub fn read(text: &str) -> Option<Self> {
        let text = text.trim();
        let key = plain(text);
        let key = key.strip_prefix("springback_").unwrap_or(&key).to_owned();
        (!key.is_empty()).then(|| Self { text: text.to_owned(), key })
    }

    /// The number of a run.
    ///
    /// # Errors
    /// Where it has none of that name, with those that it has.
    pub fn find<'a>(&self, solved: &'a Solved) -> Result<&'a Number, StudyError> {
        let numbers = &solved.outcome.numbers;
        let is = |number: &&Number| {
            [plain(number.key), format!("{}_judged", number.key), plain(&header(number)), plain(number.label)]
                .contains(&self.key)
        };
        numbers.iter().find(is).ok_or_else(|| {
            let near = did_you_mean(&self.key, numbers.iter().map(|number| number.key));
            let mut known: Vec<&str> = numbers.iter().map(|number| number.key).collect();
            known.dedup();
            let help = format!("{near}it has {}", known.join(", "));
            StudyError::new(format!("a run of this case has no number `{}`", self.text), help)
        })
    }

    /// A value that the number is held against, in the number's unit.
    ///
    /// # Errors
    /// When it is in a unit of another kind, or in none.
    pub fn limit(&self, number: &Number, given: &Parsed) -> Result<f64, StudyError> {
        let unit = number.amount.unit;
        let symbol = if unit == Unit::Degree { "deg" } else { unit.symbol() };
        let one = if unit == Unit::None { parse("1") } else { parse(&format!("1 {symbol}")) };
        let fits = one.as_ref().is_ok_and(|one| one.dimension == given.dimension && one.has_unit == given.has_unit);
        match (one, unit) {
            (Ok(_), Unit::Celsius) if fits => Ok(given.value - ZERO_CELSIUS),
            (Ok(one), _) if fits => Ok(given.value / one.value),
            _ => {
                let what = format!("`{}` is {}, not {}", self.text, measured(symbol), given.dimension.describe());
                let example = if unit == Unit::None { "1.5".to_owned() } else { format!("1.5 {symbol}") };
                Err(StudyError::new(what, format!("write the value as \"{example}\"")))
            }
        }
    }
}

/// What a number with a unit is, in words.
fn measured(symbol: &str) -> String {
    match symbol {
        "–" => "a plain number".into(),
        symbol => format!("in {symbol}"),
    }
}

fn plain(text: &str) -> String {
    text.to_lowercase().replace([' ', '-'], "_")
}
