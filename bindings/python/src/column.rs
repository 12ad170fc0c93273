//! Tables as numpy arrays, which take over the memory of their columns.

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::Table;

/// Header with its unit, label, unit as it is printed, and values.
pub type Column<'py> = (String, &'static str, &'static str, Bound<'py, PyArray1<f64>>);

/// The columns of a table from left to right.
pub fn columns(py: Python<'_>, table: Table) -> Vec<Column<'_>> {
    let column = |column: stampflow::table::Column| {
        (column.header(), column.label, column.unit.symbol(), column.values.into_pyarray(py))
    };
    table.columns.into_iter().map(column).collect()
}
