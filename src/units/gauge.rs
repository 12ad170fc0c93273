//! Sheet gauges: numbers that stand for a thickness, another one for each metal.

use super::QuantityError;
use super::dimension::INCH;

const HEAVIEST: usize = 3;

/// Thickness of uncoated steel by the US Manufacturers' Standard Gauge, from the heaviest on \[in\].
///
/// Source: printed tables, which follow from weights per square foot at 41.82 lb/ft² per inch; the standard not read.
/// Galvanised and stainless sheet have gauges of their own.
const STEEL: [f64; 28] = [
    0.2391, 0.2242, 0.2092, 0.1943, 0.1793, 0.1644, 0.1495, 0.1345, 0.1196, 0.1046, 0.0897, 0.0747, 0.0673, 0.0598,
    0.0538, 0.0478, 0.0418, 0.0359, 0.0329, 0.0299, 0.0269, 0.0239, 0.0209, 0.0179, 0.0164, 0.0149, 0.0135, 0.0120,
];

/// Thickness of aluminium by Brown & Sharpe's gauge, which is the American wire gauge \[in\]: 20 is 0.0320 in.
///
/// 0.005 in · 92^((36 − gauge)/39). Source: ASTM B258 (not read; the formula is in common use). Rounded as printed tables
/// are, to 0.0001 in.
fn aluminium(gauge: usize) -> f64 {
    (1e4 * 0.005 * 92_f64.powf((36.0 - gauge as f64) / 39.0)).round() / 1e4
}

/// Thickness of a number before a word for a gauge \[mm\]; `None` for other words.
pub(super) fn thickness(text: &str, number: f64, word: &str) -> Option<Result<f64, QuantityError>> {
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
