//! Marks on a page of a PDF file.

use super::drawing::Drawing;
use super::letters::start;
use super::mark::Mark;
use super::stroke::circle;
use crate::plot::chart::WHITE;
use crate::plot::pdf::{Letters, Page};

/// The drawing on a page of its own, this wide \[pt\].
pub(super) fn page(drawing: &Drawing, width: f64) -> Page {
    let mut page = Page::new(width, drawing.height * width / drawing.width);
    drawing.onto(&mut page, (0.0, 0.0), width);
    page
}

impl Drawing {
    /// Draws on a page with the upper left corner at a point, in this width \[pt\].
    pub(crate) fn onto(&self, page: &mut Page, at: (f64, f64), width: f64) {
        page.within(at, width / self.width, |page| self.marks.iter().for_each(|mark| draw(mark, page)));
    }
}

fn draw(mark: &Mark, page: &mut Page) {
    match mark {
        Mark::Area { outline, fill } => page.area(outline, *fill),
        Mark::Line { pieces, color, width } => page.lines(pieces.iter().map(Vec::as_slice), *color, *width),
        Mark::Circle { at, radius, color, width } => {
            let mut around = circle(*at, *radius);
            page.area(&around, WHITE);
            around.extend(around.first().copied());
            page.lines([around.as_slice()], *color, *width);
        }
        Mark::Text { text, size, color, at, anchor, turned } => {
            let by = size * start(text, *anchor);
            let at = if *turned { (at.0, at.1 - by) } else { (at.0 + by, at.1) };
            page.text(text, at, Letters { size: *size, color: *color, bold: false, turned: *turned });
        }
    }
}
