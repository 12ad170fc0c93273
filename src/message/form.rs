//! How a user wants to be told.

use super::Message;
use super::language::Language;
use crate::units::Unit;

/// Between a number and its unit: a line does not end there.
pub const NO_BREAK: char = '\u{a0}';

/// Language and system of units of what is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Form {
    /// Of words and of the decimal sign.
    pub language: Language,
    /// Of numbers.
    pub system: System,
}

impl Form {
    /// The words for it.
    pub fn tell(self, what: impl Into<Message>) -> String {
        what.into().told(self)
    }
}

/// A system of units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum System {
    /// mm, kN, MPa, J, °C.
    #[default]
    Si,
    /// Inches, US tons and pounds of force, ksi, foot-pounds, °F.
    Us,
}

/// Pound-force \[N\]: 0.453 592 37 kg × 9.806 65 m/s².
const LBF: f64 = 4.448_221_615_260_5;
const INCH: f64 = 25.4;

/// A unit to tell numbers in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Told {
    /// As it stands behind the number; empty for plain numbers.
    pub symbol: &'static str,
    /// The solver's unit in this one.
    pub factor: f64,
    /// Added after that.
    pub offset: f64,
    /// Decimals more than the solver's unit wants for the same fineness.
    pub finer: usize,
}

impl System {
    /// The unit that numbers as large as this are told in.
    pub fn told(self, unit: Unit, size: f64) -> Told {
        let of = |symbol, factor| Told { symbol, factor, offset: 0.0, finer: 0 };
        match (self, unit) {
            (_, Unit::None) => of("", 1.0),
            (Self::Si, Unit::N) if size.abs() >= 1000.0 => of("kN", 1e-3),
            (Self::Si, Unit::NPerMm) if size.abs() >= 1000.0 => of("kN/mm", 1e-3),
            (Self::Si, Unit::Joule) if size.abs() >= 1e4 => of("kJ", 1e-3),
            (Self::Us, Unit::Mm) => Told { finer: 2, ..of("in", 1.0 / INCH) },
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
            (Self::Us, Unit::Celsius) => Told { offset: 32.0, ..of("°F", 1.8) },
            (_, unit) => of(unit.symbol(), 1.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: the exact definitions of inch and pound, by hand.
    #[test]
    fn us_units_are_the_si_ones_by_their_definitions() {
        let told = |unit, value: f64| {
            let to = System::Us.told(unit, value);
            (to.symbol, value * to.factor + to.offset)
        };
        for (unit, value, symbol, expected) in [
            (Unit::Mm, 25.4, "in", 1.0),
            (Unit::Mm2, 645.16, "in²", 1.0),
            (Unit::Mm3, 16_387.064, "in³", 1.0),
            (Unit::N, 8_896.443_230_521, "US tonf", 1.0),
            (Unit::N, 444.822_161_526_05, "lbf", 100.0),
            (Unit::NPerMm, 17.512_683_523_62, "lbf/in", 100.0),
            (Unit::MPa, 68.947_572_931_68, "ksi", 10.0),
            (Unit::MPa, 0.689_475_729_316_8, "psi", 100.0),
            (Unit::Joule, 135.581_794_833_14, "ft lbf", 100.0),
            (Unit::Celsius, 100.0, "°F", 212.0),
        ] {
            let (is, number) = told(unit, value);
            assert!(is == symbol && (number - expected).abs() < 1e-9 * expected, "{value} {unit:?} → {number} {is}");
        }
    }
}
