//! Pictures one after another as an animated GIF; the only place that knows the GIF encoder.

use super::draw::{Drawing, Palette};
use super::lzw::Lzw;
use gif::{Encoder, Frame, Repeat};

/// Pixels per px of the picture: 800 pixels wide.
const DENSITY: f64 = 1.0;

/// One picture for each drawing, all as high as the first, shown for so long \[hundredths of a second\], over and over.
///
/// # Panics
/// When there is no drawing: a mistake of the caller.
pub fn gif(drawings: impl IntoIterator<Item = Drawing>, hundredths: &[u16]) -> Vec<u8> {
    let mut palette = Palette::default();
    let pictures: Vec<_> = drawings.into_iter().map(|drawing| drawing.pixels(DENSITY, &mut palette)).collect();
    let (width, height) = (pictures[0].width, pictures[0].height);
    let mut indexed: Vec<Vec<u8>> = pictures.into_iter().map(|picture| picture.pixels).collect();
    indexed.iter_mut().for_each(|pixels| pixels.resize(width * height, 0));

    let mut bytes = Vec::new();
    let never = "encoding into memory";
    let (columns, rows) = (width as u16, height as u16);
    let mut encoder = Encoder::new(&mut bytes, columns, rows, palette.colors().as_flattened()).expect(never);
    let mut lzw = Lzw::default();
    encoder.set_repeat(Repeat::Infinite).expect(never);
    for (i, (picture, &delay)) in indexed.iter().zip(hundredths).enumerate() {
        let rows = changed(i.checked_sub(1).map(|before| &indexed[before][..]), picture, width);
        let frame = Frame {
            delay,
            top: rows.start as u16,
            width: columns,
            height: rows.len() as u16,
            buffer: lzw.compressed(&picture[rows.start * width..rows.end * width]).into(),
            ..Frame::default()
        };
        encoder.write_lzw_pre_encoded_frame(&frame).expect(never);
    }
    drop(encoder);
    bytes
}

/// The rows in which a picture differs from the one before, which stays where nothing is drawn; one row at least.
fn changed(before: Option<&[u8]>, picture: &[u8], width: usize) -> std::ops::Range<usize> {
    let rows = picture.len() / width;
    let Some(before) = before else { return 0..rows };
    let differs = |row: &usize| before[row * width..(row + 1) * width] != picture[row * width..(row + 1) * width];
    let first = (0..rows).find(differs).unwrap_or(0);
    first..(first..rows).rfind(differs).unwrap_or(first) + 1
}

#[cfg(test)]
mod tests {
    use super::super::draw::Mark;
    use super::*;
    use gif::{ColorOutput, DecodeOptions};

    /// Trust: read back by the decoder of the same crate and put together as a viewer does, against the pictures
    /// themselves: flat colours must come back exactly, in every picture.
    #[test]
    fn pictures_come_back_with_their_colours_and_delays() {
        let drawing = |x: f64| {
            let outline = vec![(x, 10.0), (x + 10.0, 10.0), (x + 10.0, 20.0), (x, 20.0)];
            Drawing { width: 800.0, height: 40.0, marks: vec![Mark::Area { outline, fill: (0, 0x72, 0xb2) }] }
        };
        let bytes = gif([0.0, 20.0, 20.0, 40.0].map(drawing), &[5, 6, 7, 8]);
        let mut options = DecodeOptions::new();
        options.set_color_output(ColorOutput::RGBA);
        let mut decoder = options.read_info(&bytes[..]).unwrap();
        let mut canvas = vec![0; 800 * 40 * 4];
        for (x, delay) in [(0, 5), (20, 6), (20, 7), (40, 8)] {
            let frame = decoder.read_next_frame().unwrap().unwrap();
            assert_eq!(frame.delay, delay);
            let top = usize::from(frame.top) * 800 * 4;
            canvas[top..top + frame.buffer.len()].copy_from_slice(&frame.buffer);
            for (row, pixels) in canvas.chunks(800 * 4).enumerate() {
                for (column, pixel) in pixels.chunks(4).enumerate() {
                    let inside = (10..20).contains(&row) && (x..x + 10).contains(&column);
                    let color = if inside { [0, 0x72, 0xb2, 255] } else { [255; 4] };
                    assert_eq!(pixel, color, "{column} {row}");
                }
            }
        }
        assert!(decoder.read_next_frame().unwrap().is_none());
    }
}
