//! Rules of die design and sizes of tools, each with its source.

pub(crate) mod bead;
pub mod design;
pub mod estimate;
pub mod r_values;
pub mod size;
pub mod thickness_tolerance;
