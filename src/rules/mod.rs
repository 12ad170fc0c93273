//! Rules of die design and sizes of tools, each with its source.

pub mod estimate;
pub mod limits;
pub mod tool_sizes;
