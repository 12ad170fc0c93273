//! Streams of a PDF file, and what their content calls the font.

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::{Filter, Name, Ref};

/// How hard streams are pressed together.
pub(super) const LEVEL: u8 = 6;

/// What the font is called inside of a file.
pub(super) const FONT: Name = Name(b"F");

/// Writes a pressed stream.
pub(super) fn stream_of(file: &mut pdf_writer::Pdf, id: Ref, content: &[u8]) {
    file.stream(id, &compress_to_vec_zlib(content, LEVEL)).filter(Filter::FlateDecode);
}
