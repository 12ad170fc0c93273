//! Pictures of studies.

pub mod search;
