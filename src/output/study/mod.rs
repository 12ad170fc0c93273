//! Pictures and tables of studies: one file each.

pub mod json;
mod kept;
mod scatter_tables;
pub mod search;
pub mod versus;

pub use kept::{keep, kept_loads, load_file, thickness_file};
pub use scatter_tables::tables as scatter_tables;

use crate::plot::Chart;
use crate::study::Results;
use crate::study::fit::{CaseFit, LawFits};
use crate::study::scatter::{Found, Grids};

/// Pictures of a fit to measured curves.
pub fn fit_case(_: &CaseFit) -> Vec<Chart> {
    Vec::new()
}

/// Picture of a fit to tension tests.
pub fn fit_law(_: &LawFits) -> Chart {
    Chart::default()
}

/// Load curves of a sweep.
pub fn loads(_: &Results, _: &[Vec<(f64, f64)>]) -> Option<Chart> {
    None
}

/// Pictures of a scatter.
pub fn scatter_pictures(_: &Found, _: &Grids, _: &str) -> Vec<(&'static str, Chart)> {
    Vec::new()
}

/// Pictures of a sweep.
pub fn pictures(_: &Results, _: &str) -> Vec<(&'static str, Chart)> {
    Vec::new()
}
