//! Marks as pixels, antialiased by the area that they cover.

use super::mark::{Mark, Point};
use super::palette::Palette;
use super::stroke::{circle, outline};
use crate::output::chart::{Color, WHITE};
use crate::output::font;
use plotters::style::text_anchor::HPos;

/// Chords of letters leave their curves by about so much \[pixels\].
const SAGITTA: f64 = 0.15;

/// What lies further away is drawn as if it lay there \[pixels\].
const FAR: f64 = 1e7;

/// Pixels as numbers of a palette, row by row.
pub struct Picture {
    pub width: usize,
    pub pixels: Vec<u8>,
}

impl Picture {
    pub fn height(&self) -> usize {
        self.pixels.len() / self.width
    }

    pub fn rows(&self) -> impl Iterator<Item = &[u8]> {
        self.pixels.chunks(self.width)
    }
}

/// By how much the cover of a row rises where an edge crosses a pixel: there, and from the next one on.
#[derive(Clone, Copy)]
struct Crossing {
    pixel: u32,
    here: f32,
    later: f32,
}

/// A picture while it is drawn.
///
/// # References
/// Coverage is summed up along each row from what every edge adds to it, as FreeType and font-rs do it: D. Turner, The
/// FreeType smooth rasterizer; R. Levien, Inside the fastest font renderer in the world (2016). As commonly described, not
/// read.
pub struct Raster<'a> {
    density: f64,
    picture: Picture,
    palette: &'a mut Palette,
    /// Where edges cross each row; empty between marks.
    crossings: Vec<Vec<Crossing>>,
    /// Rows with crossings: from the first to before the last.
    touched: (usize, usize),
}

impl<'a> Raster<'a> {
    /// White paper.
    pub fn new(width: f64, height: f64, density: f64, palette: &'a mut Palette) -> Self {
        let (width, height) = ((density * width).ceil() as usize, (density * height).ceil() as usize);
        let white = palette.number(WHITE);
        let picture = Picture { width, pixels: vec![white; width * height] };
        Self { density, picture, palette, crossings: vec![Vec::new(); height], touched: (height, 0) }
    }

    pub fn picture(self) -> Picture {
        self.picture
    }

    pub fn draw(&mut self, mark: &Mark) {
        match mark {
            Mark::Area { outline, fill } => {
                self.polygon(outline);
                self.fill(*fill);
            }
            Mark::Line { pieces, color, width } => {
                pieces.iter().for_each(|piece| self.polygon(&outline(piece, 0.5 * width)));
                self.fill(*color);
            }
            Mark::Circle { at, radius, color, width } => {
                self.polygon(&circle(*at, *radius));
                self.fill(WHITE);
                self.polygon(&circle(*at, radius + 0.5 * width));
                let mut inner = circle(*at, radius - 0.5 * width);
                inner.reverse();
                self.polygon(&inner);
                self.fill(*color);
            }
            Mark::Text { text, size, color, at, anchor, turned } => {
                let mut along = match anchor {
                    HPos::Left => 0.0,
                    HPos::Center => -0.5 * font::width(text),
                    HPos::Right => -font::width(text),
                };
                let sagitta = SAGITTA / (size * self.density);
                for letter in text.chars() {
                    let place = |(x, y): Point| {
                        let (x, y) = (size * (along + x), size * y);
                        if *turned { (at.0 + y, at.1 - x) } else { (at.0 + x, at.1 + y) }
                    };
                    along += font::outline(letter, sagitta, &mut |from, to| self.edge(place(from), place(to)));
                    self.fill(*color);
                }
            }
        }
    }

    fn polygon(&mut self, points: &[Point]) {
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).for_each(|(from, to)| self.edge(*from, *to));
    }

    /// One edge of an outline \[px\]: what lies to its right is inside, or outside again.
    fn edge(&mut self, from: Point, to: Point) {
        let (sign, (from, to)) = if from.1 < to.1 { (1.0, (from, to)) } else { (-1.0, (to, from)) };
        let place = |v: f64| (v * self.density).clamp(-FAR, FAR);
        let [(x, top), (end, bottom)] = [from, to].map(|p| (place(p.0), place(p.1)));
        let (first, last) = (top.max(0.0), bottom.min(self.crossings.len() as f64));
        if !(first < last && (x + end).is_finite()) {
            return;
        }
        let slope = (end - x) / (bottom - top);
        let rows = first as usize..last.ceil() as usize;
        self.touched = (self.touched.0.min(rows.start), self.touched.1.max(rows.end));
        let width = self.picture.width as f64;
        for row in rows {
            let (upper, lower) = (first.max(row as f64), last.min(row as f64 + 1.0));
            let [a, b] = [upper, lower].map(|y| (x + (y - top) * slope).clamp(0.0, width));
            self.rise(row, sign * (lower - upper), a.min(b), a.max(b));
        }
    }

    /// Cover that rises by `by` within a row, evenly from x to x \[pixels\].
    fn rise(&mut self, row: usize, by: f64, from: f64, to: f64) {
        let crossings = &mut self.crossings[row];
        let (whole, mut x, mut pixel) = (to - from, from, from as u32);
        loop {
            let end = to.min(f64::from(pixel) + 1.0);
            let share = if end - x < whole { by * (end - x) / whole } else { by };
            // The pixel is covered from the edge on.
            let (here, later) = ((share * (f64::from(pixel) + 1.0 - 0.5 * (x + end))) as f32, share as f32);
            match crossings.last_mut() {
                Some(last) if last.pixel == pixel => (last.here, last.later) = (last.here + here, last.later + later),
                _ => crossings.push(Crossing { pixel, here, later }),
            }
            if end >= to {
                break;
            }
            (x, pixel) = (end, pixel + 1);
        }
    }

    /// Fills what the edges since the last call enclose, where their turns do not cancel.
    fn fill(&mut self, color: Color) {
        let (width, ink) = (self.picture.width, self.palette.number(color));
        let (first, last) = std::mem::replace(&mut self.touched, (self.crossings.len(), 0));
        for row in first..last {
            let pixels = &mut self.picture.pixels[row * width..(row + 1) * width];
            let crossings = &mut self.crossings[row];
            crossings.sort_unstable_by_key(|crossing| crossing.pixel);
            let (mut cover, mut rest) = (0.0, &crossings[..]);
            while let Some(&Crossing { pixel, .. }) = rest.first() {
                let mut here = cover;
                while let Some(crossing) = rest.first().filter(|crossing| crossing.pixel == pixel) {
                    (here, cover) = (here + crossing.here, cover + crossing.later);
                    rest = &rest[1..];
                }
                let (pixel, next) = (pixel as usize, rest.first().map_or(width, |next| width.min(next.pixel as usize)));
                if pixel < width {
                    self.palette.paint(&mut pixels[pixel..=pixel], ink, here);
                    if pixel + 1 < next {
                        self.palette.paint(&mut pixels[pixel + 1..next], ink, cover);
                    }
                }
            }
            crossings.clear();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The darkness of each pixel, white 0 and black 1.
    fn drawn(marks: &[Mark]) -> Vec<f64> {
        let mut palette = Palette::default();
        let mut raster = Raster::new(20.0, 12.0, 1.0, &mut palette);
        marks.iter().for_each(|mark| raster.draw(mark));
        let picture = raster.picture();
        assert_eq!((picture.width, picture.height()), (20, 12));
        picture.pixels.iter().map(|pixel| 1.0 - f64::from(palette.colors()[usize::from(*pixel)][0]) / 255.0).collect()
    }

    const BLACK: Color = (0, 0, 0);

    /// Trust: areas by hand; a level of cover is a fifteenth.
    #[test]
    fn pixels_are_as_dark_as_they_are_covered() {
        let outline = vec![(3.25, 2.0), (9.0, 2.0), (9.0, 6.5), (3.25, 6.5)];
        let pixels = drawn(&[Mark::Area { outline, fill: BLACK }]);
        let at = |x: usize, y: usize| pixels[y * 20 + x];
        assert_eq!((at(2, 3), at(4, 3), at(8, 3), at(9, 3), at(4, 1), at(4, 7)), (0.0, 1.0, 1.0, 0.0, 0.0, 0.0));
        assert!((at(3, 3) - 0.75).abs() < 0.04 && (at(5, 6) - 0.5).abs() < 0.04);

        let triangle = vec![(-8.0, -3.0), (16.0, 5.0), (2.0, 30.0)];
        let pixels = drawn(&[Mark::Area { outline: triangle.clone(), fill: BLACK }]);
        let inside = crate::output::outline::clipped(&triangle, (0.0, 20.0), (0.0, 12.0));
        let next = inside.iter().cycle().skip(1);
        let area = 0.5 * inside.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>();
        assert!((pixels.iter().sum::<f64>() - area).abs() < 0.3, "{} of {area}", pixels.iter().sum::<f64>());
    }

    /// Trust: the areas of a band and of a ring.
    #[test]
    fn lines_and_circles_have_their_widths() {
        let line = |turned: f64| {
            let pieces = vec![vec![(2.0, 2.0), (10.0, 2.0 + 8.0 * turned)], vec![(12.0, 3.0), (14.0, 3.0)]];
            drawn(&[Mark::Line { pieces, color: BLACK, width: 2.0 }]).iter().sum::<f64>()
        };
        assert!((line(0.0) - 20.0).abs() < 1e-9, "{}", line(0.0));
        assert!((line(0.6) - 2.0 * (8.0 * 1.36_f64.sqrt() + 2.0)).abs() < 0.4, "{}", line(0.6));
        let ring = drawn(&[Mark::Circle { at: (10.0, 6.0), radius: 4.0, color: BLACK, width: 2.0 }]);
        let area = std::f64::consts::PI * (25.0 - 9.0);
        let dark = ring.iter().sum::<f64>();
        assert!((dark - area).abs() < 0.8 && ring[6 * 20 + 10] == 0.0, "{dark} of {area}");
    }

    /// Trust: what is not a number or lies far away is no reason to panic or to go on for ever.
    #[test]
    fn what_cannot_be_drawn_is_left_out() {
        let far = vec![(f64::NAN, 1.0), (1e300, 4.0), (5.0, f64::INFINITY), (-1e300, f64::NEG_INFINITY)];
        assert_eq!(drawn(&[Mark::Area { outline: far, fill: BLACK }]).len(), 240);
    }
}
