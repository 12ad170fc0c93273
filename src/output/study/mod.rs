//! Pictures of studies: one file each.

mod curves;
mod kept;
mod loads;
pub mod search;
mod sweep;
mod tornado;
mod window;
mod zones;

pub use kept::{keep, kept_loads, load_file, thickness_file};
pub use loads::loads;
pub use sweep::pictures;
