//! Units of the solver's numbers, as they are spelled at the end of headers and drawn on axes.

use super::parse;
use super::types::KINDS;

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
    Mm: "mm", "mm um cm m in";
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

/// Every spelling with its unit.
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
    ///
    /// # Errors
    /// When the header ends in no known unit.
    pub fn of_header(header: &str) -> Result<(Self, f64), String> {
        let ends = |(spelling, _): &(&str, Unit)| header.strip_suffix(spelling).is_some_and(|rest| rest.ends_with('_'));
        let longest = spellings().filter(ends).max_by_key(|(spelling, _)| spelling.len());
        let (spelling, unit) = longest.ok_or_else(|| {
            let known = spellings().map(|(spelling, _)| spelling).collect::<Vec<_>>().join(", ");
            format!("column `{header}` must end in a unit, as in `travel_mm` or `punch_force_kN`; known units: {known}")
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
        }
        for (header, factor) in [("x_in", 25.4), ("x_lbf", 4.448_221_615_260_5), ("x_kN_per_m", 1.0)] {
            assert_eq!(Unit::of_header(header).map(|found| found.1), Ok(factor), "{header}");
        }
    }
}
