//! Pictures of studies: one file each.

mod scatter;
mod scatter_bands;
mod scatter_indices;
mod scatter_tables;

pub use scatter::pictures as scatter_pictures;
pub use scatter_tables::tables as scatter_tables;
