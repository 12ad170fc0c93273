//! Units that text may be written in, with their factors and dimensions.

use super::types::KINDS;
use super::{closest, parse};

/// Exponents of length, force, time, angle and temperature. An angle is a dimension, so that degrees are no plain number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension([i32; 5]);

pub(super) const NONE: Dimension = Dimension([0; 5]);
pub(super) const LENGTH: Dimension = Dimension([1, 0, 0, 0, 0]);
pub(super) const TEMPERATURE: Dimension = Dimension([0, 0, 0, 0, 1]);
const FORCE: Dimension = Dimension([0, 1, 0, 0, 0]);
const TIME: Dimension = Dimension([0, 0, 1, 0, 0]);
const ANGLE: Dimension = Dimension([0, 0, 0, 1, 0]);
const MASS: Dimension = Dimension([-1, 1, 2, 0, 0]);
const ENERGY: Dimension = Dimension([1, 1, 0, 0, 0]);
const POWER: Dimension = Dimension([1, 1, -1, 0, 0]);
const STRESS: Dimension = Dimension([-2, 1, 0, 0, 0]);

impl Dimension {
    /// Dimension of a unit's text, such as `N/mm`.
    pub(super) fn of_unit(unit: &str) -> Self {
        parse(format!("1 {unit}").trim_end()).map_or(NONE, |parsed| parsed.dimension)
    }

    /// Dimension of `self` times `other` to a power; saturates far beyond anything physical.
    pub(super) fn times(self, other: Self, power: i32) -> Self {
        Self(std::array::from_fn(|i| self.0[i].saturating_add(other.0[i].saturating_mul(power))))
    }

    /// Name such as "a length".
    pub fn describe(self) -> &'static str {
        let others = [("", "a plain number"), ("mm^2", "an area"), ("N mm", "a moment or an energy"), ("W", "a power")];
        let mut named = others.into_iter().chain(KINDS.iter().map(|kind| (kind.unit, kind.name)));
        named.find(|(unit, _)| Self::of_unit(unit) == self).map_or("a quantity of another kind", |(_, name)| name)
    }
}

/// Names of a unit, factor to solver units, dimension, and words in lower case, without a plural's s, that may mean it.
pub(super) struct NamedUnit(&'static str, pub f64, pub Dimension, &'static str);

/// Pound-force [N]: 0.453 592 37 kg × 9.806 65 m/s².
pub(super) const LBF: f64 = 4.448_221_615_260_5;
pub(super) const INCH: f64 = 25.4;

const UNITS: [NamedUnit; 39] = [
    NamedUnit("mm", 1.0, LENGTH, "mm millimetre millimeter"),
    NamedUnit("cm", 10.0, LENGTH, "centimetre centimeter"),
    NamedUnit("m", 1000.0, LENGTH, "metre meter"),
    NamedUnit("um", 1e-3, LENGTH, "micron µm μm"),
    NamedUnit("in inch inches \" ″", INCH, LENGTH, "in inch inche"),
    NamedUnit("mil", 1e-3 * INCH, LENGTH, ""),
    NamedUnit("ft", 304.8, LENGTH, ""),
    NamedUnit("N", 1.0, FORCE, "newton"),
    NamedUnit("kN", 1e3, FORCE, "kilonewton"),
    NamedUnit("MN", 1e6, FORCE, ""),
    NamedUnit("lbf", LBF, FORCE, "lb"),
    NamedUnit("kgf", 9.806_65, FORCE, ""),
    NamedUnit("kp", 9.806_65, FORCE, ""),
    // The ratings of presses mostly are metric.
    NamedUnit("tonf", 9_806.65, FORCE, "ton tonne t_f tf tonf_metric"),
    NamedUnit("tonf_us", 2000.0 * LBF, FORCE, "ton tonf_short"),
    NamedUnit("tonf_uk", 2240.0 * LBF, FORCE, "ton tonf_long"),
    NamedUnit("Pa", 1e-6, STRESS, "pascal"),
    NamedUnit("kPa", 1e-3, STRESS, ""),
    NamedUnit("bar", 0.1, STRESS, ""),
    NamedUnit("MPa", 1.0, STRESS, ""),
    NamedUnit("GPa", 1e3, STRESS, ""),
    NamedUnit("psi", LBF / (INCH * INCH), STRESS, ""),
    NamedUnit("ksi", 1e3 * LBF / (INCH * INCH), STRESS, ""),
    NamedUnit("s", 1.0, TIME, "sec second"),
    NamedUnit("ms", 1e-3, TIME, ""),
    NamedUnit("min", 60.0, TIME, ""),
    NamedUnit("h", 3600.0, TIME, ""),
    NamedUnit("rad", 1.0, ANGLE, ""),
    NamedUnit("deg", std::f64::consts::PI / 180.0, ANGLE, "degree °"),
    NamedUnit("K", 1.0, TEMPERATURE, "kelvin"),
    // 1 kg = 1 N s²/m
    NamedUnit("kg", 1e-3, MASS, ""),
    NamedUnit("g", 1e-6, MASS, ""),
    NamedUnit("mJ", 1.0, ENERGY, ""),
    NamedUnit("J", 1e3, ENERGY, "joule"),
    NamedUnit("kJ", 1e6, ENERGY, ""),
    NamedUnit("W", 1e3, POWER, "watt"),
    NamedUnit("kW", 1e6, POWER, ""),
    NamedUnit("mol", 1.0, NONE, ""),
    NamedUnit("%", 0.01, NONE, ""),
];

/// Degrees of temperature, the only unit that does not start at zero, are read by themselves.
pub(super) const CELSIUS: &str = "°C";
/// 0 °C \[K\].
pub const ZERO_CELSIUS: f64 = 273.15;

impl NamedUnit {
    fn names(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.0.split(' ')
    }

    /// Name in an error message: a ton with its force, because there are three.
    fn suggestion(&self) -> String {
        let name = self.names().next().unwrap_or_default();
        match self.3.rsplit_once("tonf_") {
            Some((_, which)) => format!("`{name}` ({which}, {:.3} kN)", 1e-3 * self.1),
            None => format!("`{name}`"),
        }
    }
}

/// Unit of that name.
pub(super) fn find(name: &str) -> Option<&'static NamedUnit> {
    UNITS.iter().find(|unit| unit.names().any(|own| own == name))
}

/// Remedy for a word that is no unit: those that it or its singular may mean, then those spelled alike, then all.
pub(super) fn did_you_mean(word: &str) -> String {
    let lower = word.to_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    let is_meant = |words: &str| words.split(' ').any(|word| word == lower || word == singular);
    let mut likely: Vec<String> = UNITS.iter().filter(|unit| is_meant(unit.3)).map(NamedUnit::suggestion).collect();
    if is_meant("c ºc celsiu") {
        likely.push(format!("`{CELSIUS}`"));
    }
    if likely.is_empty() {
        let alike = closest(word, UNITS.iter().flat_map(NamedUnit::names));
        likely = alike.into_iter().filter_map(find).map(NamedUnit::suggestion).collect();
    }
    match likely.is_empty() {
        true => format!(
            "known units: {}",
            UNITS.iter().filter_map(|unit| unit.names().next()).collect::<Vec<_>>().join(", ")
        ),
        false => format!("did you mean {}?", likely.join(" or ")),
    }
}
