//! Case files that the program writes: from templates and from drawings.

mod from_drawing;
pub mod templates;

pub use from_drawing::{Import, Imported};
