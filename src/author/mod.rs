//! Case files that the program writes: from templates and from drawings; and the reference of their keys.

mod case_reference;
mod from_drawing;
pub mod templates;
mod writer;

pub use case_reference::case_reference;
pub use from_drawing::{Import, Imported};
