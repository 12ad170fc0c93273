//! Units and their dimensions.

/// Exponents of length, force, time, angle and temperature. An angle is a dimension, so that degrees are no plain number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension([i32; 5]);

pub(super) const NONE: Dimension = Dimension([0; 5]);
pub(super) const LENGTH: Dimension = Dimension([1, 0, 0, 0, 0]);
pub(super) const FORCE: Dimension = Dimension([0, 1, 0, 0, 0]);
pub(super) const TIME: Dimension = Dimension([0, 0, 1, 0, 0]);
pub(super) const ANGLE: Dimension = Dimension([0, 0, 0, 1, 0]);
pub(super) const TEMPERATURE: Dimension = Dimension([0, 0, 0, 0, 1]);
pub(super) const MASS: Dimension = FORCE.times(TIME, 2).over(LENGTH);
pub(super) const POWER: Dimension = FORCE.times(LENGTH, 1).over(TIME);
pub(super) const STRESS: Dimension = FORCE.over(LENGTH).over(LENGTH);

impl Dimension {
    /// Dimension of a quotient.
    pub(super) const fn over(self, by: Self) -> Self {
        self.times(by, -1)
    }

    /// Dimension of `self` times `other` to a power; saturates far beyond anything physical.
    pub(super) const fn times(self, other: Self, power: i32) -> Self {
        let mut sum = self.0;
        let mut i = 0;
        while i < sum.len() {
            sum[i] = sum[i].saturating_add(other.0[i].saturating_mul(power));
            i += 1;
        }
        Self(sum)
    }

    /// Name such as "a length", otherwise the exponents.
    pub fn describe(self) -> String {
        const NAMED: [(Dimension, &str); 15] = [
            (NONE, "a plain number"),
            (LENGTH, "a length"),
            (FORCE, "a force"),
            (TIME, "a time"),
            (ANGLE, "an angle"),
            (TEMPERATURE, "a temperature"),
            (STRESS, "a stress"),
            (FORCE.over(LENGTH), "a force per length"),
            (LENGTH.over(TIME), "a speed"),
            (NONE.over(TIME), "a strain rate"),
            (LENGTH.times(LENGTH, 1), "an area"),
            (FORCE.times(LENGTH, 1), "a moment or an energy"),
            (MASS, "a mass"),
            (POWER, "a power"),
            (MASS.over(LENGTH).over(LENGTH).over(LENGTH), "a density"),
        ];
        if let Some((_, name)) = NAMED.iter().find(|(dimension, _)| *dimension == self) {
            return (*name).into();
        }
        let powers = ["length", "force", "time", "angle", "temperature"].iter().zip(self.0).filter(|(_, n)| *n != 0);
        let powers: Vec<String> =
            powers.map(|(name, n)| if n == 1 { (*name).into() } else { format!("{name}^{n}") }).collect();
        format!("of dimension {}", powers.join(" "))
    }
}

/// A unit: name, factor to solver units, dimension.
pub(super) struct Unit(pub &'static str, pub f64, pub Dimension);

/// Pound-force [N]: 0.453 592 37 kg × 9.806 65 m/s².
pub(super) const LBF: f64 = 4.448_221_615_260_5;
pub(super) const INCH: f64 = 25.4;

/// Every unit that may be written.
pub(super) const UNITS: [Unit; 43] = [
    Unit("mm", 1.0, LENGTH),
    Unit("cm", 10.0, LENGTH),
    Unit("m", 1000.0, LENGTH),
    Unit("um", 1e-3, LENGTH),
    Unit("in", INCH, LENGTH),
    Unit("inch", INCH, LENGTH),
    Unit("inches", INCH, LENGTH),
    Unit("\"", INCH, LENGTH),
    Unit("″", INCH, LENGTH),
    Unit("mil", 1e-3 * INCH, LENGTH),
    Unit("ft", 304.8, LENGTH),
    Unit("N", 1.0, FORCE),
    Unit("kN", 1e3, FORCE),
    Unit("MN", 1e6, FORCE),
    Unit("lbf", LBF, FORCE),
    Unit("kgf", 9.806_65, FORCE),
    Unit("kp", 9.806_65, FORCE),
    Unit("tonf", 9_806.65, FORCE), // metric: the ratings of presses mostly are
    Unit("tonf_us", 2000.0 * LBF, FORCE),
    Unit("tonf_uk", 2240.0 * LBF, FORCE),
    Unit("Pa", 1e-6, STRESS),
    Unit("kPa", 1e-3, STRESS),
    Unit("bar", 0.1, STRESS),
    Unit("MPa", 1.0, STRESS),
    Unit("GPa", 1e3, STRESS),
    Unit("psi", LBF / (INCH * INCH), STRESS),
    Unit("ksi", 1e3 * LBF / (INCH * INCH), STRESS),
    Unit("s", 1.0, TIME),
    Unit("ms", 1e-3, TIME),
    Unit("min", 60.0, TIME),
    Unit("h", 3600.0, TIME),
    Unit("rad", 1.0, ANGLE),
    Unit("deg", std::f64::consts::PI / 180.0, ANGLE),
    Unit("K", 1.0, TEMPERATURE),
    Unit("kg", 1e-3, MASS), // 1 kg = 1 N s²/m
    Unit("g", 1e-6, MASS),
    Unit("mJ", 1.0, FORCE.times(LENGTH, 1)),
    Unit("J", 1e3, FORCE.times(LENGTH, 1)),
    Unit("kJ", 1e6, FORCE.times(LENGTH, 1)),
    Unit("W", 1e3, POWER),
    Unit("kW", 1e6, POWER),
    Unit("mol", 1.0, NONE),
    Unit("%", 0.01, NONE),
];

/// Other names of units in lower case, without the plural's s.
const OTHER_NAMES: [(&str, &str); 18] = [
    ("in", "inch inche in"),
    ("mm", "millimetre millimeter mm"),
    ("cm", "centimetre centimeter"),
    ("m", "metre meter"),
    ("um", "micron µm μm"),
    ("N", "newton"),
    ("kN", "kilonewton"),
    ("lbf", "lb"),
    ("tonf", "ton tonne t_f tf tonf_metric"),
    ("tonf_us", "ton tonf_short"),
    ("tonf_uk", "ton tonf_long"),
    ("Pa", "pascal"),
    ("s", "sec second"),
    ("deg", "degree °"),
    ("K", "kelvin"),
    (CELSIUS, "c ºc celsiu"),
    ("J", "joule"),
    ("W", "watt"),
];

/// Degrees of temperature: the one unit that does not start at zero, and so stands alone.
pub(super) const CELSIUS: &str = "°C";
/// 0 °C \[K\].
pub const ZERO_CELSIUS: f64 = 273.15;

/// Units that a word or its plural may stand for: several for a ton.
pub(super) fn meant(word: &str) -> Vec<&'static str> {
    let word = word.to_lowercase();
    let one = word.strip_suffix('s').unwrap_or(&word);
    let is_one = |names: &str| names.split(' ').any(|name| name == word || name == one);
    OTHER_NAMES.iter().filter(|(_, names)| is_one(names)).map(|(unit, _)| *unit).collect()
}

/// Unit in an error message: a ton with its force, because there are three.
pub(super) fn display_name(name: &str) -> String {
    let tons = [("tonf", "metric"), ("tonf_us", "short"), ("tonf_uk", "long")];
    let of = tons.iter().find(|(ton, _)| *ton == name).zip(find(name));
    of.map_or(format!("`{name}`"), |((_, which), unit)| format!("`{name}` ({which}, {:.3} kN)", 1e-3 * unit.1))
}

/// The unit of that name.
pub(super) fn find(name: &str) -> Option<&'static Unit> {
    UNITS.iter().find(|unit| unit.0 == name)
}

/// Solver units in one of that name: 25.4 for `in`.
pub(crate) fn factor(name: &str) -> Option<f64> {
    find(name).map(|unit| unit.1)
}

#[cfg(test)]
mod tests {
    use super::UNITS;
    use crate::units::parse;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_unit_scales_by_its_factor(x in -1e3..1e3f64, i in 0..UNITS.len()) {
            let unit = &UNITS[i];
            let parsed = parse(&format!("{x} {}", unit.0)).unwrap();
            prop_assert_eq!(parsed.value, x * unit.1);
            prop_assert_eq!(parsed.dimension, unit.2);
        }
    }
}
