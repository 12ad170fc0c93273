//! Why a text is not the quantity that is wanted.

use super::unit::{UNITS, meant};
use super::{Dimension, Kind};

/// Why a text is not a quantity. The message's first line says what is wrong, the second what to write.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum QuantityError {
    #[error("no number in {found:?}\nwrite a number and a unit, such as \"0.9 mm\"")]
    NoNumber { found: String },
    #[error("decimal comma in {found:?}\nwrite a point: \"{point}\"")]
    DecimalComma { found: String, point: String },
    #[error("{found} needs a unit\nwrite \"{}\"; {} may also be written {}", .kind.with_unit(.found), .kind.name, .kind.written())]
    MissingUnit { found: String, kind: &'static Kind },
    #[error("unknown unit `{unit}` in {found:?}\n{}", known(.closest))]
    UnknownUnit { found: String, unit: String, closest: Vec<&'static str> },
    #[error(
        "{found:?} cannot be read from {at:?} on\nunits are joined by * and /, powers written ^2: \"5.4 tonf_uk/in^2\""
    )]
    Malformed { found: String, at: String },
    #[error("{found:?} is {}, wanted {}\nwrite for example {}", .is.describe(), .kind.name, .kind.written())]
    WrongDimension { found: String, is: Dimension, kind: &'static Kind },
    #[error("{found} is out of range for {}\nits magnitude must be at most {} {}: check the unit", .kind.name, .kind.largest, .kind.unit)]
    TooLarge { found: String, kind: &'static Kind },
    #[error("must be positive, found {found}\nwrite for example {}", .kind.written())]
    NotPositive { found: String, kind: &'static Kind },
    #[error("must not be negative, found {found}\nwrite for example {}", .kind.written())]
    Negative { found: String, kind: &'static Kind },
    #[error("must lie between 0 and 1, found {found}\nit is a fraction, such as 0.1")]
    NotFraction { found: String },
}

impl Kind {
    /// What a bare number most likely means: the solver's unit, degrees, or a share that is to be a percentage.
    fn with_unit(&self, found: &str) -> String {
        // Of angles, temperature and mass nobody writes the solver's unit.
        let unusual = self.unit == "rad" || self.unit.contains('K') || self.unit.contains("s^2");
        let usual = self.examples[0].split_once(' ').filter(|_| unusual).map_or(self.unit, |(_, unit)| unit);
        match found.parse::<f64>() {
            Ok(share) if self.unit == "%" && share < 1.0 => format!("{} %", (1e6 * share).round() / 1e4),
            _ => format!("{found} {usual}"),
        }
    }

    /// The examples, quoted where the case file wants quotes.
    pub(super) fn written(&self) -> String {
        let quoted = |text: &&str| if self.unit.is_empty() { (*text).into() } else { format!("{text:?}") };
        self.examples.iter().map(quoted).collect::<Vec<_>>().join(" or ")
    }
}

impl QuantityError {
    pub(super) fn unknown_unit(found: &str, unit: &str) -> Self {
        let closest = match meant(unit) {
            Some(name) => vec![name],
            None => closest(unit, UNITS.iter().map(|known| known.0)),
        };
        Self::UnknownUnit { found: found.into(), unit: unit.into(), closest }
    }
}

fn known(closest: &[&str]) -> String {
    if closest.is_empty() {
        let all: Vec<&str> = UNITS.iter().map(|unit| unit.0).collect();
        format!("known units: {}", all.join(", "))
    } else {
        format!("did you mean {}?", closest.iter().map(|c| format!("`{c}`")).collect::<Vec<_>>().join(" or "))
    }
}

/// The words closest to `word`, at most three: few edits, upper and lower case counted as half of one.
pub(crate) fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let allowed = match word.chars().count() {
        0..=2 => 2,
        3..=5 => 4,
        _ => 6,
    };
    let mut near: Vec<(usize, &str)> =
        known.map(|k| (half_edits(word, k), k)).filter(|(d, k)| *d <= allowed && *d < 2 * k.chars().count()).collect();
    near.sort_by_key(|(d, _)| *d);
    let best = near.first().map_or(0, |(d, _)| *d);
    near.into_iter().filter(|(d, _)| *d <= best + 1).map(|(_, k)| k).take(3).collect()
}

/// Levenshtein's distance in halves; a change of case costs one half.
fn half_edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).map(|j| 2 * j).collect();
    for ca in a.chars().take(64) {
        let mut diagonal = row[0];
        row[0] += 2;
        for (j, &cb) in b.iter().enumerate() {
            let change = if ca == cb { 0 } else { 2 - usize::from(ca.eq_ignore_ascii_case(&cb)) };
            let best = (diagonal + change).min(row[j] + 2).min(row[j + 1] + 2);
            diagonal = row[j + 1];
            row[j + 1] = best;
        }
    }
    row[b.len()]
}
