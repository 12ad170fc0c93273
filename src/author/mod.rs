//! Case files that the program writes, from a few sizes or around tools that were drawn, and the laws that they can name.

mod from_drawing;
#[cfg(feature = "schema")]
mod laws;
mod page;
pub mod templates;

pub use from_drawing::{Draft, Drawn};
#[cfg(feature = "import")]
pub use from_drawing::{Import, ImportFailure, Imported};
#[cfg(feature = "schema")]
pub use laws::{Law, law_list, laws};
