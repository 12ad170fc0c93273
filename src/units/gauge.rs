//! Sheet gauges: numbers that stand for a thickness, another one for each metal.

use super::error::QuantityError;
use super::unit::INCH;
use std::ops::RangeInclusive;

/// Gauges that are understood: from the heaviest that is called sheet to the thinnest of the table.
pub(super) const GAUGES: RangeInclusive<usize> = 3..=30;
/// Words for a gauge without a metal.
const BARE: [&str; 3] = ["ga", "gauge", "gage"];

/// Weight that a sheet of uncoated steel of each of [`GAUGES`] is called by \[oz/ft²\].
const STEEL_OUNCES: [f64; 28] = [
    160.0, 150.0, 140.0, 130.0, 120.0, 110.0, 100.0, 90.0, 80.0, 70.0, 60.0, 50.0, 45.0, 40.0, 36.0, 32.0, 28.0, 24.0,
    22.0, 20.0, 18.0, 16.0, 14.0, 12.0, 11.0, 10.0, 9.0, 8.0,
];
/// Weight of steel an inch thick, by which the gauge's weight becomes a thickness \[oz/ft²/in\]: 41.82 lb/ft²/in.
const STEEL_INCH: f64 = 16.0 * 41.82;

/// Thickness of uncoated steel by the US Manufacturers' Standard Gauge \[mm\]: 20 is 0.0359 in.
///
/// Source: the weights and 41.82 lb/ft² per inch as handbooks quote them; the standard itself not read. Printed tables round
/// to 0.0001 in, so does this. Galvanised and stainless sheet have gauges of their own.
fn steel(gauge: usize) -> f64 {
    let inches = STEEL_OUNCES[gauge - GAUGES.start()] / STEEL_INCH;
    (1e4 * inches).round() / 1e4 * INCH
}

/// Thickness of aluminium by Brown & Sharpe's gauge, which is the American wire gauge \[mm\]: 20 is 0.0320 in.
///
/// 0.005 in · 92^((36 − gauge)/39). Source: ASTM B258 (not read; the formula is in common use). Rounded as printed tables
/// are, to 0.0001 in.
fn aluminium(gauge: usize) -> f64 {
    let inches = 0.005 * 92_f64.powf((36.0 - gauge as f64) / 39.0);
    (1e4 * inches).round() / 1e4 * INCH
}

/// Thickness of a number before a word for a gauge \[mm\]; `None` for other words.
pub(super) fn thickness(found: &str, number: f64, word: &str) -> Option<Result<f64, QuantityError>> {
    let of: Option<fn(usize) -> f64> = match word {
        "ga_steel" => Some(steel),
        "ga_al" => Some(aluminium),
        word if BARE.contains(&word) => None,
        _ => return None,
    };
    let Some(gauge) = Some(number as usize).filter(|n| *n as f64 == number && GAUGES.contains(n)) else {
        let (from, to) = (GAUGES.start(), GAUGES.end());
        let help = format!("gauges are whole numbers from {from} to {to}; else write the thickness in mm or in");
        return Some(Err(QuantityError::new(format!("{found:?} is no gauge of sheet"), help)));
    };
    Some(of.map(|of| of(gauge)).ok_or_else(|| {
        let (steel, aluminium) = (steel(gauge), aluminium(gauge));
        QuantityError::new(
            format!("{found:?} is {steel:.3} mm of steel and {aluminium:.3} mm of aluminium"),
            format!("write \"{gauge} ga_steel\" (Manufacturers' Standard Gauge) or \"{gauge} ga_al\" (Brown & Sharpe)"),
        )
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: thicknesses as handbooks print them [in], which round to 0.0001 in.
    #[test]
    fn gauges_are_those_of_printed_tables() {
        let printed = [(3, 0.2391), (10, 0.1345), (14, 0.0747), (16, 0.0598), (18, 0.0478), (20, 0.0359), (30, 0.0120)];
        for (gauge, inches) in printed {
            assert!((steel(gauge) / INCH - inches).abs() < 1e-9, "{gauge}: {}", steel(gauge) / INCH);
        }
        for (gauge, inches) in [(10, 0.1019), (16, 0.0508), (18, 0.0403), (20, 0.0320), (24, 0.0201), (30, 0.0100)] {
            assert!((aluminium(gauge) / INCH - inches).abs() < 1e-9, "{gauge}: {}", aluminium(gauge) / INCH);
        }
    }
}
