//! Numbers as text, long texts cut, and the word that was probably meant.

use std::borrow::Borrow;

/// Longest quote in a message \[characters\].
const LONGEST: usize = 300;

/// The value to nine significant digits: without binary noise at the end.
pub fn rounded(value: f64) -> f64 {
    significant(value, 9)
}

/// The value to so many significant digits.
pub fn significant(value: f64, digits: usize) -> f64 {
    let decimals = digits.max(1) - 1;
    format!("{value:.decimals$e}").parse::<f64>().map_or(value, |v| v + 0.0) // −0 becomes 0
}

/// A positive value, up to so many significant digits.
pub fn rounded_up(value: f64, digits: i32) -> f64 {
    let step = 10f64.powi(value.log10().floor() as i32 + 1 - digits);
    rounded((value / step).ceil() * step)
}

/// At most so many decimals, without zeros at the end and without a minus before 0: `30.5`, `0`.
pub fn trimmed(value: f64, decimals: i32) -> String {
    let scale = 10f64.powi(decimals);
    without_zeros(&format!("{:.*}", decimals.max(0) as usize, (value * scale).round() / scale + 0.0)).to_owned()
}

/// A decimal number without zeros at the end of its decimals.
pub fn without_zeros(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// Joins the parts that are not empty.
pub fn joined<S: Borrow<str>>(parts: impl IntoIterator<Item = S>, separator: &str) -> String {
    parts.into_iter().filter(|part| !part.borrow().is_empty()).collect::<Vec<S>>().join(separator)
}

pub(crate) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}

pub(crate) fn shortened(text: &str) -> String {
    let length = text.chars().count();
    if length <= 2 * LONGEST {
        return text.to_owned();
    }
    text.chars().take(LONGEST).chain(" … ".chars()).chain(text.chars().skip(length - LONGEST / 3)).collect()
}

/// The words closest to `word`, at most three: few edits, upper and lower case counted as half of one.
pub fn closest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let word: String = word.chars().take(64).collect();
    let length = word.chars().count();
    let allowed = 2 + 2 * usize::from(length > 2) + 2 * usize::from(length > 5);
    let half_edits = |other: &str| {
        strsim::levenshtein(&word, other) + strsim::levenshtein(&word.to_ascii_lowercase(), &other.to_ascii_lowercase())
    };
    let mut near: Vec<_> = known.map(|known| (half_edits(known), known)).collect();
    near.retain(|(d, known)| *d <= allowed && *d < 2 * known.chars().count());
    near.sort_by_key(|(d, _)| *d);
    let best = near.first().map_or(0, |(d, _)| *d);
    near.into_iter().filter(|(d, _)| *d <= best + 1).map(|(_, k)| k).take(3).collect()
}

/// A question to stand before what is known, with a space at its end; nothing where no known word is close.
pub(crate) fn did_you_mean<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> String {
    closest(word, known).first().map_or(String::new(), |near| format!("did you mean `{near}`? "))
}
