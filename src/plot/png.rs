//! Charts as PNG with a palette, antialiased, with the built-in font only.

use super::chart::Chart;
use super::draw::{Drawing, Palette, WIDTH};
use miniz_oxide::deflate::compress_to_vec_zlib;

/// Pixels per px of the picture: 1600 pixels wide.
const DENSITY: f64 = 2.0;

/// An inch \[m\].
const INCH: f64 = 0.0254;

/// Flat drawings compress well at the fastest level that looks for repeated rows (1 to 9).
const LEVEL: u8 = 1;

/// The picture as a PNG file, 1600 pixels wide: unfiltered rows of one byte per pixel.
///
/// # References
/// W3C, Portable Network Graphics (PNG) Specification, third edition, sections 5 and 11.
pub fn png(chart: &Chart) -> Vec<u8> {
    drawn(&Drawing::of(chart, WIDTH), DENSITY, None)
}

/// A drawing as a PNG file of so many pixels per px, which says how many there are to an inch on paper.
pub(crate) fn drawn(drawing: &Drawing, density: f64, dpi: Option<f64>) -> Vec<u8> {
    let mut palette = Palette::default();
    let picture = drawing.pixels(density, &mut palette);
    let size = [picture.width as u32, picture.height as u32].map(u32::to_be_bytes);
    // Eight bits per pixel, a palette, and the only ways there are to compress, filter and order rows.
    let header = [size.as_flattened(), &[8, 3, 0, 0, 0]].concat();
    let mut rows = Vec::with_capacity(picture.pixels.len() + picture.height);
    for row in picture.rows() {
        rows.push(0);
        rows.extend_from_slice(row);
    }
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    chunk(&mut bytes, b"IHDR", &header);
    if let Some(dpi) = dpi {
        // Along x and along y, per metre.
        let density = ((dpi / INCH).round() as u32).to_be_bytes();
        chunk(&mut bytes, b"pHYs", &[&density[..], &density, &[1]].concat());
    }
    chunk(&mut bytes, b"PLTE", palette.colors().as_flattened());
    chunk(&mut bytes, b"IDAT", &compress_to_vec_zlib(&rows, LEVEL));
    chunk(&mut bytes, b"IEND", &[]);
    bytes
}

/// Length, name, data and checksum of name and data.
fn chunk(bytes: &mut Vec<u8>, name: &[u8; 4], data: &[u8]) {
    bytes.extend((data.len() as u32).to_be_bytes());
    let start = bytes.len();
    bytes.extend(name);
    bytes.extend(data);
    let crc = !bytes[start..].iter().fold(!0, |crc, byte| CRC[usize::from(crc as u8 ^ byte)] ^ (crc >> 8));
    bytes.extend(crc.to_be_bytes());
}

/// What each byte adds to the cyclic redundancy check of a chunk.
const CRC: [u32; 256] = {
    let mut table = [0; 256];
    let mut i = 0;
    while i < 256 {
        let (mut crc, mut bit) = (i as u32, 0);
        while bit < 8 {
            crc = (crc >> 1) ^ (0xedb8_8320 * (crc & 1));
            bit += 1;
        }
        table[i] = crc;
        i += 1;
    }
    table
};

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: read by another program's decoder, which checks sizes and checksums. Only the built-in font is known, so a text
    /// that leaves dark pixels was drawn with it; Polish, Greek and mathematical letters are asked for beside plain ones.
    #[test]
    fn text_is_drawn_without_system_fonts() {
        for text in ["Force", "ąłż", "σε̄ ∂", "≈ ≤ −", "s₀²"] {
            let chart = Chart { title: text.to_owned(), legend: String::new(), panels: Vec::new(), notes: Vec::new() };
            let bytes = png(&chart);
            let mut decoder = png::Decoder::new(std::io::Cursor::new(bytes));
            decoder.set_transformations(png::Transformations::EXPAND);
            let mut reader = decoder.read_info().unwrap();
            let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
            let info = reader.next_frame(&mut pixels).unwrap();
            assert_eq!((info.width, info.color_type), (1600, png::ColorType::Rgb));
            let dark = pixels.chunks(3).filter(|rgb| rgb[0] < 64).count();
            assert!(dark > 150, "{text}: {dark} dark pixels");
        }
    }
}
