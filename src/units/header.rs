//! Units as they are spelled in file headers and drawn on axes.

use super::dimensioned::Dimensioned;
use super::parse::parse;
use super::types::{Force, Length, LineForce, Number, Stress, Time};

/// A unit of the solver: mm, N, s, MPa and what follows from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Numbers without a unit.
    None,
    /// Shares of a hundred.
    Percent,
    /// Lengths.
    Mm,
    /// Areas.
    Mm2,
    /// Volumes.
    Mm3,
    /// Forces.
    N,
    /// Forces per length of depth.
    NPerMm,
    /// Stresses and pressures.
    MPa,
    /// Times.
    Second,
    /// Long times.
    Minute,
    /// Strain rates.
    PerSecond,
    /// Work and heat; the solver's N·mm are converted where a table is made.
    Joule,
    /// Work and heat per length of depth.
    JoulePerMm,
    /// Angles.
    Degree,
    /// Degrees Celsius; the solver's kelvins are converted where a table is made.
    Celsius,
}

/// A header whose ending is no unit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("column `{key}` must end in a unit, as in `travel_mm` or `punch_force_kN`; known units: {known}")]
pub struct UnitError {
    /// The header.
    pub key: String,
    /// All units that are known, in words.
    pub known: String,
}

/// How each unit is spelled at the end of a header: the solver's spelling first, then others of the same dimension.
const SPELLINGS: [(Unit, &[&str]); 12] = [
    (Unit::Percent, &["percent"]),
    (Unit::Mm, &["mm", "um", "cm", "m", "in"]),
    (Unit::N, &["N", "kN", "MN", "lbf", "tonf", "tonf_us", "tonf_uk"]),
    (Unit::NPerMm, &["N_per_mm", "N_per_m", "kN_per_mm", "kN_per_m"]),
    (Unit::MPa, &["MPa", "kPa", "GPa"]),
    (Unit::Second, &["s", "ms"]),
    (Unit::Minute, &["min"]),
    (Unit::PerSecond, &["1_per_s"]),
    (Unit::Joule, &["J", "mJ"]),
    (Unit::JoulePerMm, &["J_per_mm", "mJ_per_mm"]),
    (Unit::Degree, &["deg"]),
    (Unit::Celsius, &["C"]),
];

/// Every spelling with its unit.
fn spellings() -> impl Iterator<Item = (&'static str, Unit)> {
    SPELLINGS.iter().flat_map(|(unit, spellings)| spellings.iter().map(|spelling| (*spelling, *unit)))
}

/// How many solver's units one of a spelling is, by the units of case files.
fn factor(spelling: &str, unit: Unit) -> f64 {
    let size =
        |spelling: &str| parse(&format!("1 {}", spelling.replace("_per_", "/"))).map_or(1.0, |parsed| parsed.value);
    if spelling == unit.spelled() { 1.0 } else { size(spelling) / size(unit.spelled()) }
}

impl Unit {
    /// Symbol on an axis.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::None => "–",
            Self::Percent => "%",
            Self::Mm => "mm",
            Self::Mm2 => "mm²",
            Self::Mm3 => "mm³",
            Self::N => "N",
            Self::NPerMm => "N/mm",
            Self::MPa => "MPa",
            Self::Second => "s",
            Self::Minute => "min",
            Self::PerSecond => "1/s",
            Self::Joule => "J",
            Self::JoulePerMm => "J/mm",
            Self::Degree => "°",
            Self::Celsius => "°C",
        }
    }

    /// Largest magnitude that makes sense of what is measured in it: that of case files.
    pub fn largest(self) -> f64 {
        match self {
            Self::Mm => Length::KIND.largest,
            Self::N => Force::KIND.largest,
            Self::NPerMm => LineForce::KIND.largest,
            Self::MPa => Stress::KIND.largest,
            Self::Second => Time::KIND.largest,
            _ => Number::KIND.largest,
        }
    }

    /// Spelling at the end of a header; empty for plain numbers.
    pub fn spelled(self) -> &'static str {
        SPELLINGS.iter().find(|(unit, _)| *unit == self).map_or("", |(_, spellings)| spellings[0])
    }

    /// A key with the unit at its end.
    pub fn keyed(self, key: &str) -> String {
        match self.spelled() {
            "" => key.to_owned(),
            spelled => format!("{key}_{spelled}"),
        }
    }

    /// The solver's unit that a header ends in, and the factor that converts its values to it.
    ///
    /// # Errors
    /// When the header ends in no known unit.
    pub fn of_header(header: &str) -> Result<(Self, f64), UnitError> {
        let ends = |(spelling, _): &(&str, Unit)| header.strip_suffix(spelling).is_some_and(|rest| rest.ends_with('_'));
        spellings()
            .filter(ends)
            .max_by_key(|(spelling, _)| spelling.len())
            .map(|(spelling, unit)| (unit, factor(spelling, unit)))
            .ok_or_else(|| UnitError {
                key: header.to_owned(),
                known: spellings().map(|(spelling, _)| spelling).collect::<Vec<_>>().join(", "),
            })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: factors by hand, with the exact definitions of inch and pound-force.
    #[test]
    fn every_spelling_is_read_back_in_the_solvers_unit() {
        for (spelling, unit) in spellings() {
            assert_eq!(Unit::of_header(&format!("some_thing_{spelling}")).map(|found| found.0), Ok(unit), "{spelling}");
            assert_eq!(Unit::of_header(&unit.keyed("x")), Ok((unit, 1.0)), "{spelling}");
        }
        for (header, factor) in [
            ("x_um", 1e-3),
            ("x_in", 25.4),
            ("x_kN", 1e3),
            ("x_lbf", 4.448_221_615_260_5),
            ("x_kN_per_mm", 1e3),
            ("x_kN_per_m", 1.0),
            ("x_GPa", 1e3),
            ("x_ms", 1e-3),
            ("x_mJ", 1e-3),
            ("x_mJ_per_mm", 1e-3),
        ] {
            assert_eq!(Unit::of_header(header).map(|found| found.1), Ok(factor), "{header}");
        }
    }
}
