//! What studies found, for programs: as the command line prints it and Python reads it.

mod fit;
mod scatter;
mod search;
mod sweep;
mod versus;

pub use fit::{fit_case, fit_law};
pub use scatter::scatter;
pub use search::{best, found};
pub use sweep::sweep;
pub use versus::versus;
