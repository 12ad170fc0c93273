//! Compression of pictures as GIF files have it: a code for every row of pixels that came before and one more.
//!
//! Pictures of a moving section are few colours in long rows; the table that is looked up for each pixel is a plain one, and
//! only what was filled of it is cleared, which takes a tenth of what an encoder for all purposes does.
//!
//! # References
//! T. A. Welch, A technique for high-performance data compression, IEEE Computer 17(6) (1984) 8–19; CompuServe, Graphics
//! Interchange Format 89a, appendix F. As commonly described, not read.

/// Bits of a pixel, and of the codes that end a table or all data.
const PIXEL: u8 = 8;
const COLORS: usize = 1 << PIXEL;
const CLEAR: u16 = COLORS as u16;
const END: u16 = CLEAR + 1;
/// The first code of several pixels, and the first that is too large.
const FIRST: u16 = END + 1;
const MOST: u16 = 1 << 12;

/// Codes and the pixels that follow them, kept from picture to picture.
pub(crate) struct Lzw {
    /// The code of a code and a pixel behind it; 0 where there is none.
    next: Vec<u16>,
    /// Where that is not 0.
    filled: Vec<usize>,
}

/// Codes as bits, the lowest first.
#[derive(Default)]
struct Bits {
    bytes: Vec<u8>,
    /// What does not fill a byte yet, and how many bits that is.
    rest: u32,
    count: u32,
}

impl Bits {
    fn push(&mut self, code: u16, width: u32) {
        self.rest |= u32::from(code) << self.count;
        self.count += width;
        while self.count >= 8 {
            self.bytes.push(self.rest as u8);
            self.rest >>= 8;
            self.count -= 8;
        }
    }
}

impl Default for Lzw {
    fn default() -> Self {
        Self { next: vec![0; usize::from(MOST) * COLORS], filled: Vec::with_capacity(MOST.into()) }
    }
}

impl Lzw {
    /// The compressed pixels behind the bits of one, as the data of a GIF frame begin.
    pub fn compressed(&mut self, pixels: &[u8]) -> Vec<u8> {
        let mut bits = Bits { bytes: vec![PIXEL], ..Bits::default() };
        let first_width = u32::from(PIXEL) + 1;
        let (mut width, mut free) = (first_width, FIRST);
        bits.push(CLEAR, width);
        let mut pixels = pixels.iter();
        if let Some(&first) = pixels.next() {
            let mut code = u16::from(first);
            for &pixel in pixels {
                let place = usize::from(code) * COLORS + usize::from(pixel);
                let known = self.next[place];
                if known != 0 {
                    code = known;
                    continue;
                }
                bits.push(code, width);
                if free < MOST {
                    // Readers know this code one later.
                    width += u32::from(free == 1 << width);
                    self.next[place] = free;
                    self.filled.push(place);
                    free += 1;
                } else {
                    bits.push(CLEAR, width);
                    self.clear();
                    (width, free) = (first_width, FIRST);
                }
                code = pixel.into();
            }
            bits.push(code, width);
            width += u32::from(free < MOST && free == 1 << width);
        }
        bits.push(END, width);
        bits.push(0, 7);
        self.clear();
        bits.bytes
    }

    fn clear(&mut self) {
        self.filled.drain(..).for_each(|place| self.next[place] = 0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use gif::{DecodeOptions, Encoder, Frame};

    /// Trust: read by the decoder of another maker. Noise needs every width of code and clears the table; one colour makes
    /// codes as long as they come; a single pixel has none.
    #[test]
    fn pixels_come_back() {
        let mut state = 7_u32;
        let mut noise = |colors: u32| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((state >> 16) % colors) as u8
        };
        let noisy: Vec<u8> = (0..200 * 150).map(|_| noise(256)).collect();
        let striped: Vec<u8> = (0..200 * 150).map(|i| if (i / 37) % 3 == 0 { 5 } else { noise(3) }).collect();
        let mut lzw = Lzw::default();
        for (pixels, width) in
            [(noisy, 200), (striped, 200), (vec![9; 200 * 150], 200), (vec![3], 1), (vec![4; 511], 7)]
        {
            let mut bytes = Vec::new();
            let (columns, rows) = (width as u16, (pixels.len() / width) as u16);
            let palette: Vec<u8> = (0..=255_u8).flat_map(|i| [i, i, i]).collect();
            let mut encoder = Encoder::new(&mut bytes, columns, rows, &palette).unwrap();
            let buffer = lzw.compressed(&pixels).into();
            encoder
                .write_lzw_pre_encoded_frame(&Frame { width: columns, height: rows, buffer, ..Frame::default() })
                .unwrap();
            drop(encoder);
            let mut reader = DecodeOptions::new().read_info(&bytes[..]).unwrap();
            assert_eq!(reader.read_next_frame().unwrap().unwrap().buffer, pixels, "{} pixels", pixels.len());
        }
    }
}
