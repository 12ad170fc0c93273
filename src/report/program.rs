//! The program that writes reports, and the mark by which it knows them again.

/// What a file that is one of our reports contains.
pub const MARKER: &str = crate::results::REPORT_MARKER;
/// Program and version.
pub(super) const PROGRAM: &str = concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION"));

/// Below the text.
pub(super) fn written() -> String {
    format!("Written by {program}.", program = PROGRAM)
}

/// The number of a page, of how many.
pub(super) fn page_of(n: String, all: String) -> String {
    format!("{n} of {all}")
}
