//! Marks as pixels, antialiased by the area that they cover.

use super::cover::{Cover, Span};
use super::glyphs;
use super::letters::start;
use super::mark::{Mark, Point};
use super::palette::Palette;
use super::stroke::{circle, outline};
use crate::plot::chart::{Color, WHITE};
use crate::plot::font;

/// Pixels as numbers of a palette, row by row.
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<u8>,
}

impl Picture {
    pub fn rows(&self) -> impl Iterator<Item = &[u8]> {
        self.pixels.chunks(self.width)
    }

    /// Lays a colour over pixels, as far as they are of the picture.
    fn paint(&mut self, span: Span, over: u8, palette: &mut Palette) {
        let row = usize::try_from(span.row).ok().filter(|row| *row < self.height);
        let [from, to] = [span.from, span.to].map(|column| (column.max(0) as usize).min(self.width));
        if let Some(start) = row.map(|row| row * self.width) {
            palette.paint(&mut self.pixels[start + from..start + to], over, span.level);
        }
    }
}

/// A picture while it is drawn.
pub struct Raster<'a> {
    density: f64,
    picture: Picture,
    palette: &'a mut Palette,
    /// Empty between marks.
    cover: Cover,
}

impl<'a> Raster<'a> {
    /// White paper.
    pub fn new(width: f64, height: f64, density: f64, palette: &'a mut Palette) -> Self {
        let (width, height) = ((density * width).ceil() as usize, (density * height).ceil() as usize);
        // White is the first colour of every palette.
        let picture = Picture { width, height, pixels: vec![0; width * height] };
        Self { density, picture, palette, cover: Cover::new(width, height) }
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
                let start = start(text, *anchor);
                let ink = self.palette.number(*color);
                for (_, glyph, along) in font::placed(text) {
                    let along = start + along;
                    let (x, y) = if *turned { (at.0, at.1 - size * along) } else { (at.0 + size * along, at.1) };
                    let at = (self.density * x, self.density * y);
                    glyphs::spans(glyph, size * self.density, *turned, at, |span| {
                        self.picture.paint(span, ink, self.palette);
                    });
                }
            }
        }
    }

    fn polygon(&mut self, points: &[Point]) {
        let place = |p: &Point| (p.0 * self.density, p.1 * self.density);
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).for_each(|(from, to)| self.cover.edge(place(from), place(to)));
    }

    /// Fills what was outlined since the last call.
    fn fill(&mut self, color: Color) {
        let ink = self.palette.number(color);
        self.cover.spans(|span| self.picture.paint(span, ink, self.palette));
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
        assert_eq!((picture.width, picture.height), (20, 12));
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
        let inside = crate::plot::outline::clipped(&triangle, (0.0, 20.0), (0.0, 12.0));
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
