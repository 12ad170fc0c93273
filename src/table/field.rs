//! Quantities of a record: what a column is called, in which unit, and which number of the record it holds.

use super::{Axis, Column, Unit};
use crate::model::{Extent, Geometry};

/// A quantity of a record `R`, such as a step or an element at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Field<R> {
    /// Name in file headers and JSON, without the unit.
    pub key: &'static str,
    /// Labels of an axisymmetric and of a plane-strain section.
    labels: [&'static str; 2],
    measure: Measure,
    /// The number in that unit.
    pub value: fn(&R) -> f64,
}

/// What decides the unit of a quantity.
#[derive(Clone, Copy, Debug)]
enum Measure {
    In(Unit),
    Force,
    Energy,
}

impl<R> Field<R> {
    /// A quantity that is called the same in every section.
    pub const fn new(key: &'static str, label: &'static str, unit: Unit, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], measure: Measure::In(unit), value }
    }

    /// A force, in the unit of the [`Extent`] that it is of.
    pub const fn force(key: &'static str, label: &'static str, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], measure: Measure::Force, value }
    }

    /// Work or heat, whose values are converted with [`JOULES`](super::JOULES), in the unit of the [`Extent`] that it is of.
    pub const fn energy(key: &'static str, label: &'static str, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], measure: Measure::Energy, value }
    }

    /// A quantity that a plane section calls otherwise: the second label is its.
    pub const fn worded(key: &'static str, labels: [&'static str; 2], unit: Unit, value: fn(&R) -> f64) -> Self {
        Self { key, labels, measure: Measure::In(unit), value }
    }

    /// Name on axes and in legends.
    pub fn label(&self, extent: Extent) -> &'static str {
        worded(extent.geometry(), self.labels[0], self.labels[1])
    }

    /// Its values over some records.
    pub fn column<'a>(&self, extent: Extent, records: impl IntoIterator<Item = &'a R>) -> Column
    where
        R: 'a,
    {
        self.filled(extent, records.into_iter().map(self.value).collect())
    }

    /// A column of that name with values of another origin.
    pub fn filled(&self, extent: Extent, values: Vec<f64>) -> Column {
        let unit = match self.measure {
            Measure::In(unit) => unit,
            Measure::Force => extent.force_unit(),
            Measure::Energy => extent.energy_unit(),
        };
        Column::new(self.key, self.label(extent), unit, values)
    }

    /// Label and unit.
    pub fn axis(&self, extent: Extent) -> Axis {
        self.filled(extent, Vec::new()).axis()
    }

    /// One axis for several fields, as [`Axis::shared`].
    pub fn shared_axis(fields: &[Self], extent: Extent) -> Axis {
        let columns: Vec<Column> = fields.iter().map(|field| field.filled(extent, Vec::new())).collect();
        Axis::shared(&columns.iter().collect::<Vec<_>>())
    }

    /// Points of a curve: `y` over this quantity.
    pub fn against(&self, y: &Self, records: &[R]) -> Vec<(f64, f64)> {
        records.iter().map(|record| ((self.value)(record), (y.value)(record))).collect()
    }
}

/// The word for a geometry: a body of revolution has an axis and hoops, a plane section a symmetry plane and a width.
pub fn worded(geometry: Geometry, axisymmetric: &'static str, plane_strain: &'static str) -> &'static str {
    match geometry {
        Geometry::Axisymmetric => axisymmetric,
        Geometry::PlaneStrain => plane_strain,
    }
}
