//! Pictures and tables of studies: one file each.

mod curves;
mod fit_case;
mod fit_law;
pub mod json;
mod kept;
mod loads;
mod scatter;
mod scatter_bands;
mod scatter_indices;
mod scatter_tables;
pub mod search;
mod sweep;
mod tornado;
pub mod versus;
mod window;
mod zones;

pub use fit_case::fit_case;
pub use fit_law::fit_law;
pub use kept::{keep, kept_loads, load_file, thickness_file};
pub use loads::loads;
pub use scatter::pictures as scatter_pictures;
pub use scatter_tables::tables as scatter_tables;
pub use sweep::pictures;
