//! The program that writes reports, and the mark by which it knows them again.

/// What a file that is one of our reports contains.
pub const MARKER: &str = crate::output::REPORT_MARKER;
/// Program and version.
pub(super) const PROGRAM: &str = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));
