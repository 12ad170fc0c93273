//! Tables as numpy arrays, which take over the memory of their columns; charts as SVG and JSON.

use numpy::{IntoPyArray, PyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use serde::Serialize;
use stampflow::Table;
use stampflow::plot::{Chart, svg};

/// Header with its unit, label, printed unit, and values.
pub type Column<'py> = (String, &'static str, &'static str, Bound<'py, PyArray1<f64>>);

/// Columns of a table from left to right.
pub fn columns(py: Python<'_>, table: Table) -> Vec<Column<'_>> {
    let column = |column: stampflow::table::Column| {
        (column.header(), column.label, column.unit.symbol(), column.values.into_pyarray(py))
    };
    table.columns.into_iter().map(column).collect()
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
