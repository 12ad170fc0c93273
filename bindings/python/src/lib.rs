//! The program's library for Python: what [`stampflow`](../stampflow/__init__.py) is made on. Its classes hold a case and a
//! solution; names, types and documentation for users are in Python.
//!
//! Arrays are handed over without a copy, other results as the JSON that the command line prints.

#![forbid(unsafe_code)]

mod attend;
mod case;
mod column;
mod compare;
mod designs;
mod drawing;
mod error;
mod fit;
mod picture;
mod rows;
mod scatter;
mod search;
mod solution;
mod stage;
mod study;
mod sweep;
mod template;
mod words;

use pyo3::prelude::*;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::case::Case;
    #[pymodule_export]
    use super::compare::compare;
    #[pymodule_export]
    use super::designs::merge;
    #[pymodule_export]
    use super::drawing::from_drawing;
    #[pymodule_export]
    use super::fit::{fit_case, fit_law};
    #[pymodule_export]
    use super::scatter::scatter;
    #[pymodule_export]
    use super::search::{optimise, search};
    #[pymodule_export]
    use super::solution::Solution;
    #[pymodule_export]
    use super::sweep::sweep;
    #[pymodule_export]
    use super::template::{fill, templates};

    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
