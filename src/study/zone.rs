//! Failure modes of designs.

pub use crate::assess::FailureMode as Zone;
