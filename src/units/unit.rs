//! Units of the solver's numbers, as they are spelled at the end of headers, and of texts: SI or US customary.

use super::{dimension::INCH, dimension::LBF, parse, types::KINDS};
use std::sync::atomic::{AtomicBool, Ordering};

macro_rules! units {
    ($($unit:ident: $symbol:literal, $spellings:literal;)*) => {
        /// Unit of the solver: mm, N, s, MPa and what follows from them.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Unit {
            $(#[doc = concat!("Symbol `", $symbol, "`.")] $unit,)*
        }

        /// Units with their symbols on axes and their spellings at the end of headers: the solver's first, then others.
        const UNITS: &[(Unit, &str, &str)] = &[$((Unit::$unit, $symbol, $spellings)),*];
    };
}

units! {
    None: "–", "";
    Percent: "%", "percent";
    Thicknesses: "t", "";
    Mm: "mm", "mm um cm m in inch inches";
    Mm2: "mm²", "";
    Mm3: "mm³", "";
    N: "N", "N kN MN lbf tonf tonf_us tonf_uk";
    NPerMm: "N/mm", "N_per_mm N_per_m kN_per_mm kN_per_m";
    MPa: "MPa", "MPa kPa GPa";
    Second: "s", "s ms";
    Minute: "min", "min";
    PerSecond: "1/s", "1_per_s";
    Joule: "J", "J mJ";
    JoulePerMm: "J/mm", "J_per_mm mJ_per_mm";
    Degree: "°", "deg";
    Celsius: "°C", "C";
}

fn spellings() -> impl Iterator<Item = (&'static str, Unit)> {
    UNITS.iter().flat_map(|(unit, _, spellings)| spellings.split_whitespace().map(|spelling| (spelling, *unit)))
}

impl Unit {
    /// Symbol on an axis.
    pub fn symbol(self) -> &'static str {
        UNITS[self as usize].1
    }

    /// Spelling at the end of a header; empty for plain numbers.
    pub fn spelled(self) -> &'static str {
        UNITS[self as usize].2.split(' ').next().unwrap_or_default()
    }

    /// Largest magnitude that makes sense of a measured value: that of case files.
    pub fn largest(self) -> f64 {
        KINDS.iter().find(|kind| kind.unit == self.symbol()).map_or(1e12, |kind| kind.largest)
    }

    /// Key with the unit at its end.
    pub fn keyed(self, key: &str) -> String {
        [key, self.spelled()].join("_").trim_end_matches('_').to_owned()
    }

    /// Solver's unit that a header ends in, and the factor that converts its values to it.
    /// Fails when the header ends in no known unit.
    pub fn of_header(header: &str) -> Result<(Self, f64), String> {
        let ends = |(spelling, _): &(&str, Unit)| header.strip_suffix(spelling).is_some_and(|rest| rest.ends_with('_'));
        let (spelling, unit) =
            spellings().filter(ends).max_by_key(|(spelling, _)| spelling.len()).ok_or_else(|| {
                let known = spellings().map(|(spelling, _)| spelling).collect::<Vec<_>>().join(", ");
                format!("column `{header}` must end in a unit, as `travel_mm`; known units: {known}")
            })?;
        let size = |name: &str| parse(&format!("1 {}", name.replace("_per_", "/"))).map_or(1.0, |parsed| parsed.value);
        Ok((unit, if spelling == unit.spelled() { 1.0 } else { size(spelling) / size(unit.spelled()) }))
    }
}

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
}

impl DisplayUnit {
    /// Converts a number from the solver's unit.
    pub fn convert(self, value: f64) -> f64 {
        value * self.factor + if self.symbol == "°F" { 32.0 } else { 0.0 }
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
        DisplayUnit { symbol, factor }
    }
}
