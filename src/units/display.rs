//! Units of text: SI or US customary, one setting of the whole process.

use super::Unit;
use super::unit::{INCH, LBF};
use std::sync::atomic::{AtomicU8, Ordering};

/// Unit system of texts. Files for programs (CSV, JSON numbers) are always SI.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum DisplaySettings {
    /// mm, kN, MPa, J, °C.
    #[default]
    Si,
    /// Inches, US tons and pounds of force, ksi, foot-pounds, °F.
    Us,
}

static CURRENT: AtomicU8 = AtomicU8::new(DisplaySettings::Si as u8);

/// Scope of a [`DisplaySettings`]: restores the previous setting when dropped.
#[must_use]
#[derive(Debug)]
pub struct DisplayScope(DisplaySettings);

impl DisplaySettings {
    /// The setting of the process.
    pub fn current() -> Self {
        if CURRENT.load(Ordering::Relaxed) == Self::Us as u8 { Self::Us } else { Self::Si }
    }

    /// Sets it for the whole process.
    pub fn set(self) {
        CURRENT.store(self as u8, Ordering::Relaxed);
    }

    /// Sets it until the scope is dropped.
    pub fn scope(self) -> DisplayScope {
        let before = Self::current();
        self.set();
        DisplayScope(before)
    }
}

impl Drop for DisplayScope {
    fn drop(&mut self) {
        self.0.set();
    }
}

/// Unit of a displayed number, and the conversion to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayUnit {
    /// Symbol behind the number; empty for plain numbers.
    pub symbol: &'static str,
    /// Factor from the solver's unit.
    pub factor: f64,
    /// Offset, added after the factor.
    pub offset: f64,
    /// Decimals beyond those of the solver's unit, for the same resolution.
    pub extra_decimals: usize,
}

impl DisplayUnit {
    const fn scaled(symbol: &'static str, factor: f64) -> Self {
        Self { symbol, factor, offset: 0.0, extra_decimals: 0 }
    }

    /// Converts a number from the solver's unit.
    pub fn convert(self, value: f64) -> f64 {
        value * self.factor + self.offset
    }
}

impl Unit {
    /// Display unit of a number of this size, by the current [`DisplaySettings`].
    pub fn display(self, size: f64) -> DisplayUnit {
        DisplaySettings::current().unit(self, size)
    }
}

impl DisplaySettings {
    /// Display unit of a number of this size.
    pub fn unit(self, unit: Unit, size: f64) -> DisplayUnit {
        let of = DisplayUnit::scaled;
        match (self, unit) {
            (_, Unit::None) => of("", 1.0),
            (Self::Si, Unit::N) if size.abs() >= 1000.0 => of("kN", 1e-3),
            (Self::Si, Unit::NPerMm) if size.abs() >= 1000.0 => of("kN/mm", 1e-3),
            (Self::Si, Unit::Joule) if size.abs() >= 1e4 => of("kJ", 1e-3),
            (Self::Us, Unit::Mm) => DisplayUnit { extra_decimals: 2, ..of("in", 1.0 / INCH) },
            (Self::Us, Unit::Mm2) => of("in²", 1.0 / (INCH * INCH)),
            (Self::Us, Unit::Mm3) => of("in³", 1.0 / (INCH * INCH * INCH)),
            (Self::Us, Unit::N) if size.abs() >= 2000.0 * LBF => of("US tonf", 1.0 / (2000.0 * LBF)),
            (Self::Us, Unit::N) => of("lbf", 1.0 / LBF),
            (Self::Us, Unit::NPerMm) => of("lbf/in", INCH / LBF),
            (Self::Us, Unit::MPa) if size.abs() >= 1000.0 * LBF / (INCH * INCH) => {
                of("ksi", INCH * INCH / (1000.0 * LBF))
            }
            (Self::Us, Unit::MPa) => of("psi", INCH * INCH / LBF),
            (Self::Us, Unit::Joule) => of("ft lbf", 1000.0 / (12.0 * INCH * LBF)),
            (Self::Us, Unit::JoulePerMm) => of("ft lbf/in", 1000.0 / (12.0 * LBF)),
            (Self::Us, Unit::Celsius) => DisplayUnit { offset: 32.0, ..of("°F", 1.8) },
            (_, unit) => of(unit.symbol(), 1.0),
        }
    }
}
