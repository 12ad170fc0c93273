//! Fields of a record: name, unit and number of a column.

use super::{Axis, Column, Unit};
use crate::model::{Extent, Geometry};

/// Field of a record `R`, such as a step or an element at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Field<R> {
    /// Name in file headers and JSON, without the unit.
    pub key: &'static str,
    /// Names on axes in an axisymmetric and in a plane-strain section.
    labels: [&'static str; 2],
    /// Unit; newtons and joules stand for force and work in the units of an [`Extent`].
    unit: Unit,
    /// Number of a record, in the unit.
    pub value: fn(&R) -> f64,
}

impl<R> Field<R> {
    /// Field with one label; a force is in newtons, work in joules (see [`JOULES`](super::JOULES)), both of any [`Extent`].
    pub const fn new(key: &'static str, label: &'static str, unit: Unit, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], unit, value }
    }

    /// Field with labels of an axisymmetric and of a plane-strain section.
    pub const fn worded(key: &'static str, labels: [&'static str; 2], unit: Unit, value: fn(&R) -> f64) -> Self {
        Self { key, labels, unit, value }
    }

    /// Name on axes and in legends.
    pub fn label(&self, extent: Extent) -> &'static str {
        worded(extent.geometry(), self.labels[0], self.labels[1])
    }

    /// Column of records.
    pub fn column<'a>(&self, extent: Extent, records: impl IntoIterator<Item = &'a R>) -> Column
    where
        R: 'a,
    {
        self.filled(extent, records.into_iter().map(self.value).collect())
    }

    /// Column with values of another origin.
    pub fn filled(&self, extent: Extent, values: Vec<f64>) -> Column {
        let unit = match self.unit {
            Unit::N => extent.force_unit(),
            Unit::Joule => extent.energy_unit(),
            unit => unit,
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

/// Word for a geometry: a body of revolution has an axis and hoops, a plane section a symmetry plane and a width.
pub fn worded(geometry: Geometry, axisymmetric: &'static str, plane_strain: &'static str) -> &'static str {
    if geometry == Geometry::Axisymmetric { axisymmetric } else { plane_strain }
}
