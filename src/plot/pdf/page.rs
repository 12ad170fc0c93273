//! A page as it is drawn.

use super::font::show;
use super::stream::FONT;
use crate::plot::chart::Color;
use pdf_writer::Content;
use pdf_writer::types::{LineJoinStyle, TextRenderingMode};

/// Strokes of bold letters are so much wider \[em\].
const BOLD: f64 = 0.035;

/// A place on the page \[pt\].
type Point = (f64, f64);

/// How letters look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Letters {
    /// Of the font \[pt\].
    pub size: f64,
    /// Of the ink.
    pub color: Color,
    /// With wider strokes: the built-in font has one weight.
    pub bold: bool,
    /// Up the page instead of along it.
    pub turned: bool,
}

/// A page in the making.
pub struct Page {
    size: (f64, f64),
    content: Content,
}

impl std::fmt::Debug for Page {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Page").field("size", &self.size).finish_non_exhaustive()
    }
}

impl Page {
    /// An empty page of this width and height \[pt\].
    pub fn new(width: f64, height: f64) -> Self {
        let mut content = Content::new();
        content.transform([1.0, 0.0, 0.0, -1.0, 0.0, height as f32]);
        content.set_line_join(LineJoinStyle::RoundJoin);
        Self { size: (width, height), content }
    }

    /// Width and height \[pt\].
    pub fn size(&self) -> (f64, f64) {
        self.size
    }

    /// Height \[pt\].
    pub fn height(&self) -> f64 {
        self.size.1
    }

    /// A line of text whose baseline begins at a point.
    pub fn text(&mut self, text: &str, at: Point, letters: Letters) {
        let Letters { size, color, bold, turned } = letters;
        self.fill(color);
        if bold {
            self.stroke(color, BOLD * size);
        }
        let [x, y] = [at.0, at.1].map(rounded);
        let mode = if bold { TextRenderingMode::FillStroke } else { TextRenderingMode::Fill };
        let matrix = if turned { [0.0, -1.0, -1.0, 0.0, x, y] } else { [1.0, 0.0, 0.0, -1.0, x, y] };
        self.content.begin_text().set_font(FONT, size as f32).set_text_rendering_mode(mode).set_text_matrix(matrix);
        show(text, &mut self.content);
        self.content.end_text();
    }

    /// The inside of an outline; nothing where it has none: a path without points cannot be closed.
    pub fn area(&mut self, outline: &[Point], fill: Color) {
        if outline.len() < 3 {
            return;
        }
        self.fill(fill);
        self.path(outline);
        self.content.close_path().fill_nonzero();
    }

    /// Lines, each through its points; nothing where there are none: a path without points cannot be drawn.
    pub fn lines<'a>(&mut self, pieces: impl IntoIterator<Item = &'a [Point]>, color: Color, width: f64) {
        let mut pieces = pieces.into_iter().filter(|piece| piece.len() > 1).peekable();
        if pieces.peek().is_some() {
            self.stroke(color, width);
            pieces.for_each(|piece| self.path(piece));
            self.content.stroke();
        }
    }

    /// What `draw` draws, in a plane whose origin lies at a point and that is `scale` times as large.
    pub fn within(&mut self, at: Point, scale: f64, draw: impl FnOnce(&mut Self)) {
        let [x, y, scale] = [at.0, at.1, scale].map(|v| v as f32);
        self.content.save_state().transform([scale, 0.0, 0.0, scale, x, y]);
        draw(self);
        self.content.restore_state();
    }

    /// The page's commands.
    pub(super) fn finish(self) -> Vec<u8> {
        self.content.finish().into_vec()
    }

    fn path(&mut self, points: &[Point]) {
        for (i, point) in points.iter().enumerate() {
            let [x, y] = [point.0, point.1].map(rounded);
            _ = if i == 0 { self.content.move_to(x, y) } else { self.content.line_to(x, y) };
        }
    }

    fn fill(&mut self, color: Color) {
        let [red, green, blue] = parts(color);
        self.content.set_fill_rgb(red, green, blue);
    }

    fn stroke(&mut self, color: Color, width: f64) {
        let [red, green, blue] = parts(color);
        self.content.set_stroke_rgb(red, green, blue).set_line_width(width as f32);
    }
}

fn parts((red, green, blue): Color) -> [f32; 3] {
    [red, green, blue].map(|part| (f32::from(part) / 0.255).round() / 1000.0)
}

/// A hundredth of a point is not seen; what is no number or lies far away is no reason to break the file.
fn rounded(length: f64) -> f32 {
    let near = if length.is_finite() { length.clamp(-1e5, 1e5) } else { 0.0 };
    ((100.0 * near).round() / 100.0) as f32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether every operator that closes, fills or strokes a path comes after one that begins it.
    fn is_sound(commands: &[u8]) -> bool {
        let mut begun = false;
        String::from_utf8_lossy(commands).split_whitespace().all(|word| {
            match word {
                "m" => begun = true,
                "h" => return begun,
                "f" | "S" => return std::mem::take(&mut begun),
                _ => {}
            }
            true
        })
    }

    #[test]
    fn no_path_is_closed_filled_or_drawn_without_a_point() {
        let (black, corners) = ((0, 0, 0), [(0.0, 0.0), (5.0, 0.0), (5.0, 5.0)]);
        let mut page = Page::new(10.0, 10.0);
        for outline in [&[], &corners[..1], &corners[..2], &corners[..]] {
            page.area(outline, black);
            page.lines([outline], black, 1.0);
        }
        page.lines(std::iter::empty(), black, 1.0);
        let commands = page.finish();
        assert!(is_sound(&commands), "{}", String::from_utf8_lossy(&commands));
        let count = |operator: &str| {
            String::from_utf8_lossy(&commands).split_whitespace().filter(|word| *word == operator).count()
        };
        // The triangle is the one area; it and the line between two points are the lines.
        assert_eq!([count("f"), count("S")], [1, 2]);
        assert!(!is_sound(b"1 0 0 rg\nh\nf\n"));
    }
}
