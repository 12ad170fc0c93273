//! Pictures and tables of studies: one file each.

pub mod versus;
