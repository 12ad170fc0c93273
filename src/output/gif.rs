//! Pictures one after another as an animated GIF; the only place that knows the GIF encoder.

use super::png::{pixels, render, tree};
use gif::{Encoder, Frame, Repeat};
use rayon::prelude::*;
use resvg::tiny_skia::Pixmap;
use std::collections::HashMap;

/// Pixels per px of the picture: 800 pixels wide.
const DENSITY: f32 = 1.0;

/// Colours that a GIF can have.
const MOST_COLORS: usize = 256;
/// Pictures that the colours are counted in.
const COUNTED: usize = 5;

type Rgb = [u8; 3];

/// One picture for each SVG, all of the size of the first, shown for so long \[hundredths of a second\], over and over.
///
/// The colours are those that cover the most, so that flat areas keep theirs exactly; others, which are blends at edges,
/// take the nearest (P. S. Heckbert, Color image quantization for frame buffer display, Computer Graphics 16 (1982)
/// 297–307, section 3.1, "popularity algorithm"; as commonly described, not read).
///
/// # Panics
/// When there is no picture, or a text is no SVG: mistakes of the caller.
pub fn gif(svgs: &[String], hundredths: &[u16]) -> Vec<u8> {
    let (width, height) = pixels(&tree(&svgs[0]), DENSITY);
    let drawn = |svg: &String| {
        let mut picture = Pixmap::new(width, height).expect("the picture has a size");
        render(&tree(svg), DENSITY, 0, &mut picture);
        picture.pixels().iter().map(|p| [p.red(), p.green(), p.blue()]).collect::<Vec<Rgb>>()
    };
    let palette = palette(svgs.iter().step_by(svgs.len().div_ceil(COUNTED)).map(drawn));
    let indexed: Vec<Vec<u8>> = svgs.par_iter().map(|svg| nearest(&palette, &drawn(svg))).collect();

    let mut bytes = Vec::new();
    let never = "encoding into memory";
    let (width, height) = (width as u16, height as u16);
    let mut encoder = Encoder::new(&mut bytes, width, height, palette.as_flattened()).expect(never);
    encoder.set_repeat(Repeat::Infinite).expect(never);
    for (i, (picture, &delay)) in indexed.iter().zip(hundredths).enumerate() {
        let before = i.checked_sub(1).map(|before| &indexed[before][..]);
        let rows = changed(before, picture, width.into());
        let frame = Frame {
            delay,
            top: rows.start as u16,
            width,
            height: rows.len() as u16,
            buffer: picture[rows.start * usize::from(width)..rows.end * usize::from(width)].into(),
            ..Frame::default()
        };
        encoder.write_frame(&frame).expect(never);
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

/// The colours that the most pixels have.
fn palette(pictures: impl Iterator<Item = Vec<Rgb>>) -> Vec<Rgb> {
    let mut counts: HashMap<Rgb, usize> = HashMap::new();
    for color in pictures.flatten() {
        *counts.entry(color).or_default() += 1;
    }
    let mut colors: Vec<(Rgb, usize)> = counts.into_iter().collect();
    // Those that are as frequent in the order of their numbers, so that the same run makes the same file.
    colors.sort_by_key(|(color, count)| (std::cmp::Reverse(*count), *color));
    colors.into_iter().take(MOST_COLORS).map(|(color, _)| color).collect()
}

/// The number of each pixel's nearest colour.
fn nearest(palette: &[Rgb], pixels: &[Rgb]) -> Vec<u8> {
    let mut known: HashMap<Rgb, u8> = HashMap::new();
    let apart = |a: &Rgb, b: &Rgb| a.iter().zip(b).map(|(a, b)| (i32::from(*a) - i32::from(*b)).pow(2)).sum::<i32>();
    let find = |color: &Rgb| (0..palette.len()).min_by_key(|&i| apart(&palette[i], color)).unwrap_or(0) as u8;
    pixels.iter().map(|color| *known.entry(*color).or_insert_with(|| find(color))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use gif::{ColorOutput, DecodeOptions};

    /// Trust: read back by the decoder of the same crate and put together as a viewer does, against the pictures
    /// themselves: flat colours must come back exactly, in every picture.
    #[test]
    fn pictures_come_back_with_their_colours_and_delays() {
        let svg = |x: u32| {
            format!(
                "<svg width=\"60\" height=\"40\" xmlns=\"http://www.w3.org/2000/svg\"><rect x=\"{x}\" y=\"10\" width=\"10\" \
                 height=\"10\" fill=\"#0072b2\"/></svg>"
            )
        };
        let svgs: Vec<String> = [0, 20, 20, 40].map(svg).into();
        let bytes = gif(&svgs, &[5, 6, 7, 8]);
        let mut options = DecodeOptions::new();
        options.set_color_output(ColorOutput::RGBA);
        let mut decoder = options.read_info(&bytes[..]).unwrap();
        let mut canvas = vec![0; 60 * 40 * 4];
        for (x, delay) in [(0, 5), (20, 6), (20, 7), (40, 8)] {
            let frame = decoder.read_next_frame().unwrap().unwrap();
            assert_eq!(frame.delay, delay);
            let top = usize::from(frame.top) * 60 * 4;
            canvas[top..top + frame.buffer.len()].copy_from_slice(&frame.buffer);
            for (row, pixels) in canvas.chunks(60 * 4).enumerate() {
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
