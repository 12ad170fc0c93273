//! Units that text may be written in, with their factors and dimensions.

use super::{closest, parse, types::KINDS};

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

/// Pound-force [N]: 0.453 592 37 kg × 9.806 65 m/s².
pub(super) const LBF: f64 = 4.448_221_615_260_5;
pub(super) const INCH: f64 = 25.4;
const DEGREE: f64 = std::f64::consts::PI / 180.0;

const UNITS: &[(Dimension, &[(&str, f64)])] = &[
    (LENGTH, &[("mm", 1.0), ("cm", 10.0), ("m", 1000.0), ("um", 1e-3)]),
    (LENGTH, &[("in", INCH), ("mil", 1e-3 * INCH), ("ft", 304.8)]),
    (LENGTH, &[("inch", INCH), ("inches", INCH), ("\"", INCH), ("″", INCH)]),
    (FORCE, &[("N", 1.0), ("kN", 1e3), ("MN", 1e6), ("lbf", LBF), ("kgf", 9.806_65), ("kp", 9.806_65)]),
    // The ratings of presses mostly are metric.
    (FORCE, &[("tonf", 9_806.65), ("tonf_us", 2000.0 * LBF), ("tonf_uk", 2240.0 * LBF)]),
    (STRESS, &[("Pa", 1e-6), ("kPa", 1e-3), ("bar", 0.1), ("MPa", 1.0), ("GPa", 1e3)]),
    (STRESS, &[("psi", LBF / (INCH * INCH)), ("ksi", 1e3 * LBF / (INCH * INCH))]),
    (TIME, &[("s", 1.0), ("ms", 1e-3), ("min", 60.0), ("h", 3600.0)]),
    (ANGLE, &[("rad", 1.0), ("deg", DEGREE), ("°", DEGREE)]),
    (TEMPERATURE, &[("K", 1.0)]),
    // 1 kg = 1 N s²/m
    (MASS, &[("kg", 1e-3), ("g", 1e-6)]),
    (ENERGY, &[("mJ", 1.0), ("J", 1e3), ("kJ", 1e6)]),
    (POWER, &[("W", 1e3), ("kW", 1e6)]),
    (NONE, &[("mol", 1.0), ("%", 0.01)]),
];

/// Units with other names of theirs in lower case, without the plural's s.
const OTHER_NAMES: &str = "in inch inche in, mm millimetre millimeter mm, cm centimetre centimeter, m metre meter, \
    um micron µm μm, N newton, kN kilonewton, lbf lb, tonf ton tonne t_f tf tonf_metric, tonf_us ton tonf_short, \
    tonf_uk ton tonf_long, Pa pascal, s sec second, deg degree, K kelvin, °C c ºc celsiu, J joule, W watt";

/// Degrees of temperature, the only unit that does not start at zero, are read by themselves.
pub(super) const CELSIUS: &str = "°C";
/// 0 °C \[K\].
pub const ZERO_CELSIUS: f64 = 273.15;

fn names() -> impl Iterator<Item = &'static str> {
    UNITS.iter().flat_map(|(_, units)| units.iter().map(|(name, _)| *name))
}

pub(super) fn find(name: &str) -> Option<(f64, Dimension)> {
    let factor = |units: &[(&str, f64)]| units.iter().find(|(own, _)| *own == name).map(|(_, factor)| *factor);
    UNITS.iter().find_map(|(dimension, units)| Some((factor(units)?, *dimension)))
}

/// Remedy for a word that is no unit: those that it or its singular may mean, then those spelled alike, then all.
pub(super) fn did_you_mean(word: &str) -> String {
    let lower = word.to_lowercase();
    let singular = lower.strip_suffix('s').unwrap_or(&lower);
    let likely = OTHER_NAMES.split(", ").filter_map(|names| {
        let (name, others) = names.split_once(' ')?;
        others.split(' ').any(|other| other == lower || other == singular).then_some(name)
    });
    let mut likely: Vec<&str> = likely.collect();
    if likely.is_empty() {
        likely = closest(word, names());
    }
    if likely.is_empty() {
        return format!("known units: {}", names().collect::<Vec<_>>().join(", "));
    }
    // A ton with its force, because there are three.
    let tons = [("tonf", "metric"), ("tonf_us", "short"), ("tonf_uk", "long")];
    let suggestion = |name: &&str| match tons.iter().find(|(ton, _)| ton == name).zip(find(name)) {
        Some(((_, which), (newtons, _))) => format!("`{name}` ({which}, {:.3} kN)", 1e-3 * newtons),
        None => format!("`{name}`"),
    };
    format!("did you mean {}?", likely.iter().map(suggestion).collect::<Vec<_>>().join(" or "))
}
