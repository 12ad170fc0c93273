//! Pictures and tables of studies.

pub mod study;
