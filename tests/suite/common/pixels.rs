//! PNG files, read by a decoder that is not ours.

use std::io::Cursor;

/// Red, green and blue of every pixel, row by row.
pub struct Pixels {
    pub width: usize,
    pub rgb: Vec<[u8; 3]>,
}

pub fn pixels(file: &[u8]) -> Pixels {
    let mut decoder = png::Decoder::new(Cursor::new(file));
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().expect("a PNG file");
    let mut bytes = vec![0; reader.output_buffer_size().expect("a size")];
    let info = reader.next_frame(&mut bytes).expect("pixels");
    assert_eq!(info.color_type, png::ColorType::Rgb);
    Pixels { width: info.width as usize, rgb: bytes.chunks(3).map(|p| [p[0], p[1], p[2]]).collect() }
}
