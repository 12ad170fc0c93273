//! Named columns of numbers with units: headers of files and labels of axes come from the same [`Column`].

mod csv;

pub use crate::units::Unit;
pub use csv::{Csv, CsvError, Record};
use std::borrow::Cow;

use crate::model::{Extent, Geometry};

/// One N·mm, the solver's unit of work \[J\].
pub const JOULES: f64 = 1e-3;

/// One quantity, in solver units.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Name in file headers and JSON, without the unit: `punch_force`.
    pub key: Cow<'static, str>,
    /// Name on axes and in legends: `Punch force`.
    pub label: Cow<'static, str>,
    /// Unit of the values.
    pub unit: Unit,
    /// The numbers, one a row; NaN or infinite where there is none, which is written as an empty cell.
    pub values: Vec<f64>,
}

impl Column {
    /// A column of values in `unit`.
    pub fn new(
        key: impl Into<Cow<'static, str>>, label: impl Into<Cow<'static, str>>, unit: Unit, values: Vec<f64>,
    ) -> Self {
        Self { key: key.into(), label: label.into(), unit, values }
    }

    /// Key and unit as in a CSV header: `punch_force_N`.
    pub fn header(&self) -> String {
        self.unit.keyed(&self.key)
    }
}

/// Columns of equal length.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// From left to right.
    pub columns: Vec<Column>,
}

impl Table {
    /// Joins columns.
    ///
    /// # Panics
    /// When the columns differ in length or two have the same header: a mistake of the caller.
    pub fn new(columns: Vec<Column>) -> Self {
        for (i, column) in columns.iter().enumerate() {
            assert_eq!(column.values.len(), columns[0].values.len(), "column {} has another length", column.key);
            assert!(columns[..i].iter().all(|c| c.key != column.key), "column {} appears twice", column.key);
        }
        Self { columns }
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.columns.first().map_or(0, |c| c.values.len())
    }

    /// The column of a key.
    ///
    /// # Panics
    /// When there is none: keys are fixed in the program.
    pub fn column(&self, key: &str) -> &Column {
        self.columns.iter().find(|c| c.key == key).unwrap_or_else(|| panic!("the table has no column {key}"))
    }
}

/// Field of a record `R`, such as a step or an element at an instant: name, unit and number of a column.
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
    /// Field with one label; a force is in newtons, work in joules (see [`JOULES`]), both of any [`Extent`].
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

    /// Points of a curve: `y` over this quantity.
    pub fn against(&self, y: &Self, records: &[R]) -> Vec<(f64, f64)> {
        records.iter().map(|record| ((self.value)(record), (y.value)(record))).collect()
    }
}

/// Name of a tool as a part of a key.
pub fn keyed(name: &str) -> String {
    name.to_lowercase().replace(|c: char| !c.is_alphanumeric(), "_")
}

/// Word for a geometry: a body of revolution has an axis and hoops, a plane section a symmetry plane and a width.
pub fn worded<T>(geometry: Geometry, axisymmetric: T, plane_strain: T) -> T {
    if geometry == Geometry::Axisymmetric { axisymmetric } else { plane_strain }
}
