//! Quantities of a record: what a column is called, in which unit, and which number of the record it holds.

use super::{Axis, Column, Unit};
use crate::model::Geometry;

/// A quantity of a record `R`, such as a step or an element at an instant.
#[derive(Clone, Copy, Debug)]
pub struct Field<R> {
    /// Name in file headers and JSON, without the unit.
    pub key: &'static str,
    /// Labels and units of an axisymmetric and of a plane-strain section.
    labels: [&'static str; 2],
    units: [Unit; 2],
    /// The number in that unit.
    pub value: fn(&R) -> f64,
}

impl<R> Field<R> {
    /// A quantity that is called the same in every section.
    pub const fn new(key: &'static str, label: &'static str, unit: Unit, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], units: [unit; 2], value }
    }

    /// A force: of the whole ring, or per mm of depth.
    pub const fn force(key: &'static str, label: &'static str, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], units: [Unit::N, Unit::NPerMm], value }
    }

    /// Work or heat, whose values are converted with [`JOULES`](super::JOULES): of the whole ring, or per mm of depth.
    pub const fn energy(key: &'static str, label: &'static str, value: fn(&R) -> f64) -> Self {
        Self { key, labels: [label; 2], units: [Unit::Joule, Unit::JoulePerMm], value }
    }

    /// A quantity that a plane section calls otherwise: the second label is its.
    pub const fn worded(key: &'static str, labels: [&'static str; 2], unit: Unit, value: fn(&R) -> f64) -> Self {
        Self { key, labels, units: [unit; 2], value }
    }

    /// Name on axes and in legends.
    pub fn label(&self, geometry: Geometry) -> &'static str {
        worded(geometry, self.labels[0], self.labels[1])
    }

    /// Its values over some records.
    pub fn column<'a>(&self, geometry: Geometry, records: impl IntoIterator<Item = &'a R>) -> Column
    where
        R: 'a,
    {
        self.filled(geometry, records.into_iter().map(self.value).collect())
    }

    /// A column of that name with values of another origin.
    pub fn filled(&self, geometry: Geometry, values: Vec<f64>) -> Column {
        let unit = match geometry {
            Geometry::Axisymmetric => self.units[0],
            Geometry::PlaneStrain => self.units[1],
        };
        Column::new(self.key, self.label(geometry), unit, values)
    }

    /// Label and unit.
    pub fn axis(&self, geometry: Geometry) -> Axis {
        self.filled(geometry, Vec::new()).axis()
    }

    /// One axis for several fields, as [`Axis::shared`].
    pub fn shared_axis(fields: &[Self], geometry: Geometry) -> Axis {
        let columns: Vec<Column> = fields.iter().map(|field| field.filled(geometry, Vec::new())).collect();
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
