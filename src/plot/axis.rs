//! Axes: label, unit and spacing.

use super::*;
use crate::table::Column;
use crate::units::DisplaySettings;
pub(crate) use crate::units::capitalised;
use serde::Serialize;

/// Linear or logarithmic spacing of values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Spacing {
    /// Equal differences are equally far apart.
    #[default]
    Even,
    /// Equal ratios are equally far apart, of values above 0.
    Logarithmic,
}

impl Spacing {
    /// True if logarithmic.
    pub fn is_logarithmic(self) -> bool {
        self == Self::Logarithmic
    }

    /// Position of a value on the axis: its logarithm to base 10 if logarithmic.
    pub fn place(self, value: f64) -> f64 {
        if self.is_logarithmic() { value.log10() } else { value }
    }

    /// Value at a position on the axis.
    pub fn value(self, place: f64) -> f64 {
        if self.is_logarithmic() { 10_f64.powf(place) } else { place }
    }

    /// Value at a share of the way between two ends, exact at the ends.
    pub fn between(self, [from, to]: [f64; 2], share: f64) -> f64 {
        if self.is_logarithmic() { from * (to / from).powf(share) } else { from + share * (to - from) }
    }

    /// Share of the way between two ends \[–\].
    pub fn share(self, [from, to]: [f64; 2], value: f64) -> f64 {
        if self.is_logarithmic() { (value / from).ln() / (to / from).ln() } else { (value - from) / (to - from) }
    }
}

/// Axis of a plot.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Axis {
    /// Name of the quantity.
    pub label: String,
    /// Symbol of the unit: `mm`, or `–` for plain numbers.
    pub unit: String,
    /// Names of categories at 0, 1, 2, …; empty for numbers.
    pub names: Vec<String>,
    /// Linear or logarithmic; along a logarithmic axis points are given by their logarithms.
    pub spacing: Spacing,
    /// Unit of the values until they are converted for display.
    #[serde(skip)]
    solver_unit: Option<Unit>,
}

impl Axis {
    /// Axis of numbers in a unit.
    pub fn named(label: impl Into<String>, unit: Unit) -> Self {
        let (label, names, spacing) = (label.into(), Vec::new(), Spacing::Even);
        Self { label, unit: unit.symbol().to_owned(), names, spacing, solver_unit: Some(unit) }
    }

    /// Axis of categories: the first stands at 0, the next at 1.
    pub fn of_names(label: impl Into<String>, names: Vec<String>) -> Self {
        Self { names, ..Self::named(label, Unit::None) }
    }

    /// Same axis, linear or logarithmic.
    pub fn spaced(self, spacing: Spacing) -> Self {
        Self { spacing, ..self }
    }

    /// Changes to the display unit of these places and gives their conversion; it changes nothing the second time.
    pub(super) fn displayed(&mut self, places: &[f64]) -> impl Fn(f64) -> f64 + use<> {
        let spacing = self.spacing;
        let largest = bounds(places.iter().map(|place| spacing.value(*place).abs())).1.max(0.0);
        let to = self.solver_unit.take().map(|unit| DisplaySettings::current().unit(unit, largest));
        if let Some(to) = to.filter(|to| !to.symbol.is_empty()) {
            self.unit = to.symbol.to_owned();
        }
        move |place| to.map_or(place, |to| spacing.place(to.convert(spacing.value(place))))
    }

    /// Label with its unit: `Punch force [N]`.
    pub fn text(&self) -> String {
        if self.names.is_empty() { format!("{} [{}]", self.label, self.unit) } else { self.label.clone() }
    }
}

impl Column {
    /// Label and unit: `Punch force [N]`.
    pub fn axis(&self) -> Axis {
        Axis::named(self.label.clone(), self.unit)
    }
}

impl<R> Field<R> {
    /// Label and unit.
    pub fn axis(&self, extent: Extent) -> Axis {
        self.filled(extent, Vec::new()).axis()
    }
}
