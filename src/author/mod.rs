//! Case files that the program writes, from a few sizes or around tools that were drawn, the laws that they can name, and the reference
//! of all their keys.

mod case_reference;
mod from_drawing;
mod laws;
mod page;
pub mod templates;

pub use case_reference::case_reference;
pub use from_drawing::{Draft, Drawn};
pub use from_drawing::{Import, ImportFailure, Imported};
pub use laws::{Law, law_list, laws};
