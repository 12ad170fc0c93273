//! Pictures of studies.

mod fit_case;
mod fit_law;

pub use fit_case::fit_case;
pub use fit_law::fit_law;
