//! Marks on a page of a PDF file.

use super::drawing::Drawing;
use super::mark::{Mark, WIDTH};
use super::stroke::circle;
use crate::output::chart::WHITE;
use crate::output::font::width as width_of;
use crate::output::pdf::{Letters, Page};
use plotters::style::text_anchor::HPos;

/// The drawing on a page of its own, this wide \[pt\].
pub(super) fn page(drawing: &Drawing, width: f64) -> Page {
    let mut page = Page::new(width, drawing.height * width / WIDTH);
    drawing.onto(&mut page, (0.0, 0.0), width);
    page
}

impl Drawing {
    /// Draws on a page with the upper left corner at a point, in this width \[pt\].
    pub(crate) fn onto(&self, page: &mut Page, at: (f64, f64), width: f64) {
        page.within(at, width / WIDTH, |page| self.marks.iter().for_each(|mark| draw(mark, page)));
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
            let before = match anchor {
                HPos::Left => 0.0,
                HPos::Center => 0.5,
                HPos::Right => 1.0,
            } * size
                * width_of(text);
            let at = if *turned { (at.0, at.1 + before) } else { (at.0 - before, at.1) };
            page.text(text, at, Letters { size: *size, color: *color, bold: false, turned: *turned });
        }
    }
}
