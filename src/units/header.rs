//! Units as they are spelled in file headers and drawn on axes.

use super::dimensioned::Dimensioned;
use super::parse::parse;
use super::types::{Force, Length, LineForce, Number, Stress, Time};

/// Unit of the solver: mm, N, s, MPa and what follows from them.
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
    /// Works and heats.
    Joule,
    /// Works and heats per length of depth.
    JoulePerMm,
    /// Angles.
    Degree,
    /// Temperatures.
    Celsius,
}

/// Header without a unit at its end.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("column `{key}` must end in a unit, as in `travel_mm` or `punch_force_kN`; known units: {known}")]
pub struct UnitError {
    /// Header.
    pub key: String,
    /// All known units.
    pub known: String,
}

/// Units with their symbols on axes and their spellings at the end of headers: the solver's first, then others.
const UNITS: [(Unit, &str, &[&str]); 15] = [
    (Unit::None, "–", &[]),
    (Unit::Percent, "%", &["percent"]),
    (Unit::Mm, "mm", &["mm", "um", "cm", "m", "in"]),
    (Unit::Mm2, "mm²", &[]),
    (Unit::Mm3, "mm³", &[]),
    (Unit::N, "N", &["N", "kN", "MN", "lbf", "tonf", "tonf_us", "tonf_uk"]),
    (Unit::NPerMm, "N/mm", &["N_per_mm", "N_per_m", "kN_per_mm", "kN_per_m"]),
    (Unit::MPa, "MPa", &["MPa", "kPa", "GPa"]),
    (Unit::Second, "s", &["s", "ms"]),
    (Unit::Minute, "min", &["min"]),
    (Unit::PerSecond, "1/s", &["1_per_s"]),
    (Unit::Joule, "J", &["J", "mJ"]),
    (Unit::JoulePerMm, "J/mm", &["J_per_mm", "mJ_per_mm"]),
    (Unit::Degree, "°", &["deg"]),
    (Unit::Celsius, "°C", &["C"]),
];

/// Every spelling with its unit.
fn spellings() -> impl Iterator<Item = (&'static str, Unit)> {
    UNITS.iter().flat_map(|(unit, _, spellings)| spellings.iter().map(|spelling| (*spelling, *unit)))
}

impl Unit {
    fn entry(self) -> &'static (Self, &'static str, &'static [&'static str]) {
        UNITS.iter().find(|entry| entry.0 == self).expect("the list has every unit")
    }

    /// Symbol on an axis.
    pub fn symbol(self) -> &'static str {
        self.entry().1
    }

    /// Spelling at the end of a header; empty for plain numbers.
    pub fn spelled(self) -> &'static str {
        self.entry().2.first().unwrap_or(&"")
    }

    /// Largest magnitude that makes sense of a measured value: that of case files.
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

    /// Key with the unit at its end.
    pub fn keyed(self, key: &str) -> String {
        match self.spelled() {
            "" => key.to_owned(),
            spelled => format!("{key}_{spelled}"),
        }
    }

    /// Solver's unit that a header ends in, and the factor that converts its values to it.
    ///
    /// # Errors
    /// When the header ends in no known unit.
    pub fn of_header(header: &str) -> Result<(Self, f64), UnitError> {
        let ends = |(spelling, _): &(&str, Unit)| header.strip_suffix(spelling).is_some_and(|rest| rest.ends_with('_'));
        let longest = spellings().filter(ends).max_by_key(|(spelling, _)| spelling.len());
        let (spelling, unit) = longest.ok_or_else(|| UnitError {
            key: header.to_owned(),
            known: spellings().map(|(spelling, _)| spelling).collect::<Vec<_>>().join(", "),
        })?;
        let size = |name: &str| parse(&format!("1 {}", name.replace("_per_", "/"))).map_or(1.0, |parsed| parsed.value);
        Ok((unit, if spelling == unit.spelled() { 1.0 } else { size(spelling) / size(unit.spelled()) }))
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
            ("x_lbf", 4.448_221_615_260_5),
            ("x_kN_per_m", 1.0),
            ("x_GPa", 1e3),
            ("x_mJ_per_mm", 1e-3),
        ] {
            assert_eq!(Unit::of_header(header).map(|found| found.1), Ok(factor), "{header}");
        }
    }
}
