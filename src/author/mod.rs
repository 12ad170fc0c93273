//! Case files that the program writes: from templates and from drawings; and the reference of their keys.

mod case_reference;
mod from_drawing;
mod page;
pub mod templates;

pub use case_reference::case_reference;
pub use from_drawing::{Draft, Drawn};
pub use from_drawing::{Import, ImportFailure, Imported};
