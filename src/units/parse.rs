//! The grammar: number, then factors joined by `*`, `·`, a space or `/`, each with an optional power.

use super::error::QuantityError;
use super::gauge;
use super::unit::{self, Dimension};

/// Symbol of sheet thicknesses: "6 t".
const THICKNESSES: &str = "t";

/// Number in solver units, and its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parsed {
    /// The number, in solver units.
    pub value: f64,
    /// Its dimension.
    pub dimension: Dimension,
    /// Whether any unit was written.
    pub has_unit: bool,
}

/// Reads a quantity such as `0.9 mm`, `60mm`, `20 ga_steel`, `30 N/mm2` or `5.4 tonf_uk/in^2`; `/` divides by the next factor
/// only.
///
/// # Errors
/// When there is no number, a unit is unknown (the closest known ones are named) or the text is malformed.
pub fn parse(text: &str) -> Result<Parsed, QuantityError> {
    let text = text.trim();
    let (number, mut rest) = split_number(text);
    let Ok(mut value) = number.replace('−', "-").parse::<f64>() else {
        return Err(QuantityError::new(
            format!("no number in {text:?}"),
            "write a number and a unit, such as \"0.9 mm\"",
        ));
    };
    if let Some(decimals) = rest.strip_prefix(',') {
        let point = format!("{number}.{decimals}");
        let help = format!("write a point: \"{point}\"");
        return Err(QuantityError {
            with_point: Some(point),
            ..QuantityError::new(format!("decimal comma in {text:?}"), help)
        });
    }
    let malformed = |at: &str| {
        let help = "units are joined by * and /, powers written ^2: \"5.4 tonf_uk/in^2\"";
        QuantityError::new(format!("{text:?} cannot be read from {at:?} on"), help)
    };
    if rest.trim() == unit::CELSIUS {
        return Ok(Parsed { value: value + unit::ZERO_CELSIUS, dimension: unit::TEMPERATURE, has_unit: true });
    }
    if let Some(thickness) = gauge::thickness(text, value, rest.trim()) {
        return Ok(Parsed { value: thickness?, dimension: unit::LENGTH, has_unit: true });
    }
    if rest.trim() == THICKNESSES {
        let what = format!("{text:?} are thicknesses of the sheet, and here no sheet is known");
        return Err(QuantityError::new(what, "write a length, such as \"6 mm\""));
    }
    let (mut dimension, has_unit) = (unit::NONE, !rest.trim().is_empty());
    while !rest.trim_start().is_empty() {
        let joint = rest.trim_start();
        let (sign, factor) = match joint.chars().next() {
            Some('/') => (-1, &joint[1..]),
            Some(c @ ('*' | '·')) => (1, &joint[c.len_utf8()..]),
            _ => (1, joint),
        };
        let factor = factor.trim_start();
        let end = factor.find(|c: char| !(c.is_alphabetic() || matches!(c, '_' | '%' | '°'))).unwrap_or(factor.len());
        let end = if factor.starts_with(['"', '″']) { factor.chars().next().map_or(0, char::len_utf8) } else { end };
        let (name, after) = factor.split_at(end);
        if name.is_empty() {
            return Err(malformed(joint));
        }
        let unit = unit::find(name).ok_or_else(|| QuantityError::unknown_unit(text, name))?;
        let (power, after) = split_power(after).ok_or_else(|| malformed(after))?;
        value *= unit.1.powi(sign * power);
        dimension = dimension.times(unit.2, sign * power);
        rest = after;
    }
    Ok(Parsed { value, dimension, has_unit })
}

/// Splits a leading decimal number off; the exponent belongs to it only when digits follow the `e`.
fn split_number(text: &str) -> (&str, &str) {
    let digits = |s: &str| s.len() - s.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let sign = |s: &str| s.chars().next().filter(|c| matches!(c, '+' | '-' | '−')).map_or(0, char::len_utf8);
    let mut end = sign(text);
    end += digits(&text[end..]);
    if text[end..].starts_with('.') {
        end += 1 + digits(&text[end + 1..]);
    }
    if text[end..].starts_with(['e', 'E']) {
        let exponent = end + 1 + sign(&text[end + 1..]);
        let n = digits(&text[exponent..]);
        if n > 0 {
            end = exponent + n;
        }
    }
    text.split_at(end)
}

/// The number of sheet thicknesses in "6 t"; `None` of any other text.
pub fn thicknesses(text: &str) -> Option<f64> {
    let (number, rest) = split_number(text.trim());
    (rest.trim() == THICKNESSES).then(|| number.replace('−', "-").parse().ok())?
}

/// Splits `^2`, `2`, `²` or `³` off; no power is 1.
fn split_power(text: &str) -> Option<(i32, &str)> {
    for (sign, power) in [("²", 2), ("³", 3)] {
        if let Some(rest) = text.strip_prefix(sign) {
            return Some((power, rest));
        }
    }
    let power = match text.strip_prefix('^') {
        Some(power) => power,
        None if text.starts_with(|c: char| c.is_ascii_digit()) => text,
        None => return Some((1, text)),
    };
    let sign = power.len() - power.strip_prefix('-').unwrap_or(power).len();
    let end = power[sign..].find(|c: char| !c.is_ascii_digit()).map_or(power.len(), |n| sign + n);
    let (value, rest) = power.split_at(end);
    value.parse().ok().filter(|n: &i32| n.abs() <= 9).map(|n| (n, rest))
}
