//! Lines of text as plotters draws them.

use super::backend::units;
use super::canvas::{Canvas, NEVER, rgb};
use super::mark::Point;
use crate::plot::chart::Color;
use crate::plot::font::FAMILY;
use plotters::style::{FontDesc, FontFamily, FontStyle, TextStyle};

/// A line of text by its upper left corner.
pub(super) fn text(canvas: &Canvas, text: &str, size: f64, color: Color, (x, top): Point) {
    canvas.draw_text(text, &style(size, color), (units(x), units(top))).expect(NEVER);
}

/// Its size is in px: only the recorder reads it.
pub(super) fn style(size: f64, color: Color) -> TextStyle<'static> {
    FontDesc::new(FontFamily::Name(FAMILY), size, FontStyle::Normal).color(&rgb(color))
}
