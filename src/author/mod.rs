//! Case files that the program writes: from a few sizes, or around tools that were drawn.

mod from_drawing;
mod page;
pub mod templates;

pub use from_drawing::Draft;
