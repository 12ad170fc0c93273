//! The grammar: number, then factors joined by `*`, `·`, a space or `/`, each with an optional power.

use super::dimension::{self, CELSIUS, Dimension, INCH, ZERO_CELSIUS};

/// Symbol of sheet thicknesses: "6 t".
const THICKNESSES: &str = "t";
/// Metric tonnes-force, and what a shop writes for them.
const TONNES: &str = "tonf";
const SHOP_TONNES: [&str; 5] = [THICKNESSES, "ton", "tons", "tonne", "tonnes"];

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

/// Reason why a text is not the wanted quantity, and what to write instead.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what}\n{help}")]
pub struct QuantityError {
    /// Reason.
    pub what: String,
    /// Remedy.
    pub help: String,
    /// Text with a decimal point in place of its comma.
    pub with_point: Option<String>,
}

impl QuantityError {
    pub(super) fn new(what: impl Into<String>, help: impl Into<String>) -> Self {
        Self { what: what.into(), help: help.into(), with_point: None }
    }
}

/// Reads a quantity such as `0.9 mm`, `60mm`, `20 ga_steel`, `30 N/mm2` or `5.4 tonf_uk/in^2`; `/` divides by the next factor
/// only.
/// Fails when there is no number, a unit is unknown (the closest known ones are named) or the text is malformed.
pub fn parse(text: &str) -> Result<Parsed, QuantityError> {
    let text = text.trim();
    let Some((value, rest)) = split_number(text) else {
        let help = "write a number and a unit, such as \"0.9 mm\"";
        return Err(QuantityError::new(format!("no number in {text:?}"), help));
    };
    if let Some(decimals) = rest.strip_prefix(',') {
        let point = format!("{}.{decimals}", &text[..text.len() - rest.len()]);
        let error = QuantityError::new(format!("decimal comma in {text:?}"), format!("write a point: \"{point}\""));
        return Err(QuantityError { with_point: Some(point), ..error });
    }
    let mut rest = rest.trim_start();
    let whole = |value: f64, dimension: Dimension| Parsed { value, dimension, has_unit: true };
    if let Some(thickness) = gauge_thickness(text, value, rest) {
        return thickness.map(|thickness| whole(thickness, dimension::LENGTH));
    }
    if rest == CELSIUS {
        return Ok(whole(value + ZERO_CELSIUS, dimension::TEMPERATURE));
    }
    // Lengths in thicknesses of the sheet are replaced before they are read.
    rest = if SHOP_TONNES.contains(&rest) { TONNES } else { rest };
    let mut parsed = Parsed { value, dimension: dimension::NONE, has_unit: !rest.is_empty() };
    while !rest.is_empty() {
        let malformed = |at: &str| {
            let help = "units are joined by * and /, powers written ^2: \"5.4 tonf_uk/in^2\"";
            QuantityError::new(format!("{text:?} cannot be read from {at:?} on"), help)
        };
        let (sign, factor) = match rest.strip_prefix('/') {
            Some(divisor) => (-1, divisor.trim_start()),
            None => (1, rest.strip_prefix(['*', '·']).unwrap_or(rest).trim_start()),
        };
        let end = factor.find(|c: char| !(c.is_alphabetic() || "_%°\"″".contains(c))).unwrap_or(factor.len());
        let (name, after) = factor.split_at(end);
        if name.is_empty() {
            return Err(malformed(rest));
        }
        let (factor, dimension) = dimension::find(name).ok_or_else(|| {
            QuantityError::new(format!("unknown unit `{name}` in {text:?}"), dimension::did_you_mean(name))
        })?;
        let (power, after) = split_power(after).ok_or_else(|| malformed(after))?;
        parsed.value *= factor.powi(sign * power);
        parsed.dimension = parsed.dimension.times(dimension, sign * power);
        rest = after.trim_start();
    }
    Ok(parsed)
}

fn split_number(text: &str) -> Option<(f64, &str)> {
    let is_part = |(_, c): &(usize, char)| c.is_ascii_digit() || "+-−.eE".contains(*c);
    let characters: Vec<(usize, char)> = text.char_indices().take(400).take_while(is_part).collect();
    let mut ends = characters.iter().rev().map(|(i, c)| i + c.len_utf8());
    ends.find_map(|end| Some((text[..end].replace('−', "-").parse().ok()?, &text[end..])))
}

/// The number of sheet thicknesses in "6 t"; `None` of any other text.
pub fn thicknesses(text: &str) -> Option<f64> {
    split_number(text.trim()).filter(|(_, unit)| unit.trim() == THICKNESSES).map(|(number, _)| number)
}

fn split_power(text: &str) -> Option<(i32, &str)> {
    let raised = |sign: char, power: i32| text.strip_prefix(sign).map(|rest| (power, rest));
    if let Some(square_or_cube) = raised('²', 2).or_else(|| raised('³', 3)) {
        return Some(square_or_cube);
    }
    let power = match text.strip_prefix('^') {
        Some(power) => power,
        None if text.starts_with(|c: char| c.is_ascii_digit()) => text,
        None => return Some((1, text)),
    };
    let sign = usize::from(power.starts_with('-'));
    let end = power[sign..].find(|c: char| !c.is_ascii_digit()).map_or(power.len(), |n| sign + n);
    let (value, rest) = power.split_at(end);
    value.parse().ok().filter(|n: &i32| n.abs() <= 9).map(|n| (n, rest))
}

/// Heaviest gauge that is called sheet.
const HEAVIEST: usize = 3;

/// Thickness of uncoated steel by the US Manufacturers' Standard Gauge, from the heaviest on \[in\].
///
/// Source: printed tables, by weights at 41.82 lb/ft² per inch (not read). Galvanised and stainless have their own.
const STEEL: [f64; 28] = [
    0.2391, 0.2242, 0.2092, 0.1943, 0.1793, 0.1644, 0.1495, 0.1345, 0.1196, 0.1046, 0.0897, 0.0747, 0.0673, 0.0598,
    0.0538, 0.0478, 0.0418, 0.0359, 0.0329, 0.0299, 0.0269, 0.0239, 0.0209, 0.0179, 0.0164, 0.0149, 0.0135, 0.0120,
];

/// Thickness of aluminium by Brown & Sharpe's gauge, which is the American wire gauge \[in\]: 20 is 0.0320 in.
///
/// 0.005 in · 92^((36 − gauge)/39), to 0.0001 in as tables are. Source: ASTM B258 (not read; in common use).
fn aluminium(gauge: usize) -> f64 {
    (1e4 * 0.005 * 92_f64.powf((36.0 - gauge as f64) / 39.0)).round() / 1e4
}

/// Thickness of a number before a word for a gauge \[mm\]; `None` for other words.
fn gauge_thickness(text: &str, number: f64, word: &str) -> Option<Result<f64, QuantityError>> {
    if !["ga_steel", "ga_al", "ga", "gauge", "gage"].contains(&word) {
        return None;
    }
    let gauge = number as usize;
    let steel = gauge.checked_sub(HEAVIEST).and_then(|i| STEEL.get(i)).filter(|_| gauge as f64 == number);
    let (what, help) = match (steel.map(|inches| inches * INCH), aluminium(gauge) * INCH, word) {
        (Some(steel), _, "ga_steel") => return Some(Ok(steel)),
        (Some(_), aluminium, "ga_al") => return Some(Ok(aluminium)),
        (Some(steel), aluminium, _) => (
            format!("{text:?} is {steel:.3} mm of steel and {aluminium:.3} mm of aluminium"),
            format!("write \"{gauge} ga_steel\" (Manufacturers' Standard Gauge) or \"{gauge} ga_al\" (Brown & Sharpe)"),
        ),
        (None, ..) => (
            format!("{text:?} is no gauge of sheet"),
            "gauges are whole numbers from 3 to 30; else write the thickness in mm or in".to_owned(),
        ),
    };
    Some(Err(QuantityError::new(what, help)))
}
