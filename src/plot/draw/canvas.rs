//! What plotters draws on: areas of a recorder of marks.

use super::backend::Recorder;
use crate::plot::chart::Color;
use plotters::coord::Shift;
use plotters::drawing::DrawingArea;
use plotters::style::RGBColor;

/// An area of the page.
pub(super) type Canvas<'a> = DrawingArea<Recorder<'a>, Shift>;

/// Why drawing cannot fail.
pub(super) const NEVER: &str = "nothing fails on the way into memory";

/// A colour as plotters has it.
pub(super) fn rgb(color: Color) -> RGBColor {
    RGBColor(color.0, color.1, color.2)
}
