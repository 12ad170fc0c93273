//! Kinds of quantities: name, unit, range.

use super::unit::Dimension;

/// Name, dimension, unit and range of a type of quantity.
#[derive(Debug, PartialEq)]
pub struct Kind {
    /// With its article, as in "a length".
    pub name: &'static str,
    /// Dimension.
    pub dimension: Dimension,
    /// The solver's unit; empty for a plain number.
    pub unit: &'static str,
    /// Examples of texts.
    pub examples: &'static [&'static str],
    /// Largest magnitude that makes sense, in `unit`; beyond it a unit is wrong.
    pub largest: f64,
}

impl Kind {
    /// Name and unit: `length, mm`.
    pub(crate) fn measured(&self) -> String {
        let name = self.name.split_once(' ').map_or(self.name, |(_, name)| name);
        format!("{name}, {}", self.unit)
    }

    /// Likely meaning of a bare number: the solver's unit, degrees, or a share that is to be a percentage.
    pub(super) fn with_unit(&self, found: &str) -> String {
        let unusual = self.unit == "rad" || self.unit.contains('K') || self.unit.contains("s^2");
        let usual = self.examples[0].split_once(' ').filter(|_| unusual).map_or(self.unit, |(_, unit)| unit);
        match found.parse::<f64>() {
            Ok(share) if self.unit == "%" && share < 1.0 => format!("{} %", (1e6 * share).round() / 1e4),
            _ => format!("{found} {usual}"),
        }
    }

    /// The examples, quoted where the case file wants quotes.
    pub(super) fn written(&self) -> String {
        let quoted = |text: &&str| if self.unit.is_empty() { (*text).into() } else { format!("{text:?}") };
        self.examples.iter().map(quoted).collect::<Vec<_>>().join(" or ")
    }
}
