//! Case files that the program writes, from a few sizes or around tools that were drawn, the laws that they can name, and the reference
//! of all their keys.

#[cfg(feature = "schema")]
mod case_reference;
mod from_drawing;
#[cfg(feature = "schema")]
mod laws;
mod page;
pub mod templates;

#[cfg(feature = "schema")]
pub use case_reference::case_reference;
pub use from_drawing::{Draft, Drawn};
#[cfg(feature = "import")]
pub use from_drawing::{Import, ImportFailure, Imported};
#[cfg(feature = "schema")]
pub use laws::{Law, law_list, laws};
