//! Units of text: SI or US customary, one setting of the whole process.

use super::Unit;
use super::dimension::{INCH, LBF};
use std::sync::atomic::{AtomicBool, Ordering};

/// Unit system of texts. Files for programs (CSV, JSON numbers) are always SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DisplaySettings {
    /// mm, kN, MPa, J, °C.
    Si,
    /// Inches, US tons and pounds of force, ksi, foot-pounds, °F.
    Us,
}

static IS_US: AtomicBool = AtomicBool::new(false);

/// Unit of a displayed number, and the conversion to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayUnit {
    /// Symbol behind the number; empty for plain numbers.
    pub symbol: &'static str,
    /// Factor from the solver's unit.
    pub factor: f64,
    /// Offset, added after the factor.
    pub offset: f64,
}

impl DisplayUnit {
    /// Converts a number from the solver's unit.
    pub fn convert(self, value: f64) -> f64 {
        value * self.factor + self.offset
    }

    /// Decimals beyond those of the solver's unit, for the same resolution.
    pub(super) fn extra_decimals(self) -> usize {
        if self.symbol == "in" { 2 } else { 0 }
    }
}

impl DisplaySettings {
    /// The setting of the process.
    pub fn current() -> Self {
        if IS_US.load(Ordering::Relaxed) { Self::Us } else { Self::Si }
    }

    /// Sets it for the whole process.
    pub fn set(self) {
        IS_US.store(self == Self::Us, Ordering::Relaxed);
    }

    /// Display unit of a number of this size.
    pub fn unit(self, unit: Unit, size: f64) -> DisplayUnit {
        const PSI: f64 = LBF / (INCH * INCH);
        const TON: f64 = 2000.0 * LBF;
        let size = size.abs();
        let (symbol, factor) = match (self, unit) {
            (_, Unit::None) => ("", 1.0),
            (Self::Si, Unit::N) if size >= 1000.0 => ("kN", 1e-3),
            (Self::Si, Unit::NPerMm) if size >= 1000.0 => ("kN/mm", 1e-3),
            (Self::Si, Unit::Joule) if size >= 1e4 => ("kJ", 1e-3),
            (Self::Us, Unit::Mm) => ("in", 1.0 / INCH),
            (Self::Us, Unit::Mm2) => ("in²", 1.0 / (INCH * INCH)),
            (Self::Us, Unit::Mm3) => ("in³", 1.0 / (INCH * INCH * INCH)),
            (Self::Us, Unit::N) if size >= TON => ("US tonf", 1.0 / TON),
            (Self::Us, Unit::N) => ("lbf", 1.0 / LBF),
            (Self::Us, Unit::NPerMm) => ("lbf/in", INCH / LBF),
            (Self::Us, Unit::MPa) if size >= 1000.0 * PSI => ("ksi", 1e-3 / PSI),
            (Self::Us, Unit::MPa) => ("psi", 1.0 / PSI),
            (Self::Us, Unit::Joule) => ("ft lbf", 1000.0 / (12.0 * INCH * LBF)),
            (Self::Us, Unit::JoulePerMm) => ("ft lbf/in", 1000.0 / (12.0 * LBF)),
            (Self::Us, Unit::Celsius) => ("°F", 1.8),
            (_, unit) => (unit.symbol(), 1.0),
        };
        DisplayUnit { symbol, factor, offset: if symbol == "°F" { 32.0 } else { 0.0 } }
    }
}
