//! Units as they are spelled in file headers and drawn on axes.

use crate::model::Geometry;

/// A unit of the solver: mm, N, s, MPa and what follows from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// Numbers without a unit.
    None,
    Percent,
    Mm,
    N,
    NPerMm,
    MPa,
    Second,
    Minute,
    PerSecond,
    /// Of work and heat; the solver's N·mm are converted where a table is made.
    Joule,
    JoulePerMm,
    /// Of angles.
    Degree,
    /// Degrees Celsius; the solver's kelvins are converted where a table is made.
    Celsius,
}

/// A header whose ending is no unit.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("column `{key}` must end in a unit, as in `travel_mm` or `punch_force_kN`; known units: {known}")]
pub struct UnitError {
    pub key: String,
    pub known: String,
}

/// What the end of a header means: its spelling, the solver's unit, and how many of these it is.
const SPELLINGS: [(&str, Unit, f64); 28] = [
    ("percent", Unit::Percent, 1.0),
    ("mm", Unit::Mm, 1.0),
    ("um", Unit::Mm, 1e-3),
    ("cm", Unit::Mm, 10.0),
    ("m", Unit::Mm, 1e3),
    ("in", Unit::Mm, 25.4),
    ("N", Unit::N, 1.0),
    ("kN", Unit::N, 1e3),
    ("MN", Unit::N, 1e6),
    ("lbf", Unit::N, 4.4482216152605),
    ("tonf_uk", Unit::N, 9964.016418),
    ("N_per_mm", Unit::NPerMm, 1.0),
    ("N_per_m", Unit::NPerMm, 1e-3),
    ("kN_per_mm", Unit::NPerMm, 1e3),
    ("kN_per_m", Unit::NPerMm, 1.0),
    ("MPa", Unit::MPa, 1.0),
    ("kPa", Unit::MPa, 1e-3),
    ("GPa", Unit::MPa, 1e3),
    ("s", Unit::Second, 1.0),
    ("ms", Unit::Second, 1e-3),
    ("min", Unit::Minute, 1.0),
    ("1_per_s", Unit::PerSecond, 1.0),
    ("J", Unit::Joule, 1.0),
    ("mJ", Unit::Joule, 1e-3),
    ("J_per_mm", Unit::JoulePerMm, 1.0),
    ("mJ_per_mm", Unit::JoulePerMm, 1e-3),
    ("deg", Unit::Degree, 1.0),
    ("C", Unit::Celsius, 1.0),
];

impl Unit {
    /// As drawn on an axis.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::None => "–",
            Self::Percent => "%",
            Self::Mm => "mm",
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

    /// As spelled at the end of a header; empty for plain numbers.
    pub fn spelled(self) -> &'static str {
        SPELLINGS.iter().find(|(_, unit, _)| *unit == self).map_or("", |(spelling, ..)| spelling)
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
        SPELLINGS
            .iter()
            .filter(|(spelling, ..)| header.strip_suffix(spelling).is_some_and(|rest| rest.ends_with('_')))
            .max_by_key(|(spelling, ..)| spelling.len())
            .map(|&(_, unit, factor)| (unit, factor))
            .ok_or_else(|| UnitError {
                key: header.to_owned(),
                known: SPELLINGS.map(|(spelling, ..)| spelling).join(", "),
            })
    }
}

/// Unit of forces: of the whole ring, or per mm of depth.
pub fn force_unit(geometry: Geometry) -> Unit {
    match geometry {
        Geometry::Axisymmetric => Unit::N,
        Geometry::PlaneStrain => Unit::NPerMm,
    }
}

/// One N·mm, the solver's unit of work \[J\].
pub const JOULES: f64 = 1e-3;

/// Unit in which work and heat are written, after [`JOULES`]: of the whole ring, or per mm of depth.
pub fn energy_unit(geometry: Geometry) -> Unit {
    match geometry {
        Geometry::Axisymmetric => Unit::Joule,
        Geometry::PlaneStrain => Unit::JoulePerMm,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_spelling_is_read_back_and_the_first_of_a_unit_is_the_solvers() {
        for (spelling, unit, factor) in SPELLINGS {
            assert_eq!(Unit::of_header(&format!("some_thing_{spelling}")), Ok((unit, factor)));
            assert_eq!(Unit::of_header(&unit.keyed("x")), Ok((unit, 1.0)));
        }
    }

    #[test]
    fn headers_without_a_unit_are_refused_with_the_known_ones() {
        for header in ["thickness", "mm", "strain_1", "force_kp"] {
            let message = Unit::of_header(header).unwrap_err().to_string();
            assert!(message.contains(header) && message.contains("N_per_mm"), "{message}");
        }
    }
}
