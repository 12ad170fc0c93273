//! Library of the program for Python, on which the package `stampflow` is built: cases and solutions as classes, tables as arrays,
//! everything else as the JSON that the command line prints.

#![forbid(unsafe_code)]

mod case;
mod drawing;
mod error;
mod interruptible;
mod solution;
mod study;
mod table;
mod trace;

use pyo3::prelude::*;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::case::{Case, fill, materials, schema, templates, toml};
    #[pymodule_export]
    use super::drawing::from_drawing;
    #[pymodule_export]
    use super::solution::Solution;
    #[pymodule_export]
    use super::study::{compare, fit_law, study};
    #[pymodule_export]
    use super::trace::trace;

    #[pymodule_export]
    #[allow(non_upper_case_globals)]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
