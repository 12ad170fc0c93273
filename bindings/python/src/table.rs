//! Tables as read-only numpy arrays, which take over the memory of their columns; charts as SVG and JSON.

use numpy::{IntoPyArray, PyArray1, PyArrayMethods};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;
use stampflow::Table;
use stampflow::plot::{Chart, svg};
use stampflow::table::{Column as NamedColumn, Unit};
use std::borrow::Cow;

/// Header with its unit, label, printed unit, and values.
pub type Column<'py> = (String, Cow<'static, str>, &'static str, Bound<'py, PyArray1<f64>>);

/// Column of a quantity of records.
pub fn field<R>(
    key: &'static str, label: &'static str, unit: Unit, records: &[R], value: impl Fn(&R) -> f64,
) -> NamedColumn {
    NamedColumn::new(key, label, unit, records.iter().map(value).collect())
}

/// Columns of a table from left to right.
pub fn columns(py: Python<'_>, table: Table) -> Vec<Column<'_>> {
    let column = |column: NamedColumn| {
        (column.header(), column.label, column.unit.symbol(), read_only(column.values.into_pyarray(py)))
    };
    table.columns.into_iter().map(column).collect()
}

fn read_only(array: Bound<'_, PyArray1<f64>>) -> Bound<'_, PyArray1<f64>> {
    // The only owner of a new array: nobody else borrows it.
    if let Ok(borrowed) = array.try_readwrite() {
        borrowed.make_nonwriteable();
    }
    array
}

/// SVG of a chart, and the chart as JSON.
pub type Picture = (String, String);

/// Draws a chart.
pub fn picture(chart: &Chart) -> PyResult<Picture> {
    Ok((svg(chart), json(chart)?))
}

/// JSON of a value.
pub fn json(value: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(value).map_err(|error| PyValueError::new_err(error.to_string()))
}
