//! Draws a [`Chart`]: plotters lays it out once as [`Mark`]s, and these become SVG or pixels.
//!
//! Lengths in this folder are in px of a picture 800 wide, from its upper left corner, y down, unless they say "units".

mod backend;
mod canvas;
mod cover;
mod drawing;
mod flags;
mod glyphs;
mod letters;
mod mark;
mod page;
mod palette;
mod panel;
mod pdf;
mod raster;
mod shape;
mod stroke;
mod svg;
mod text;
mod ticks;

use super::chart::Chart;
use super::pdf::Pdf;
pub(crate) use drawing::Drawing;
#[cfg(test)]
pub(super) use mark::Mark;
pub(crate) use mark::WIDTH;
pub(super) use palette::Palette;

/// The picture as a standalone SVG, 800 px wide.
pub fn svg(chart: &Chart) -> String {
    Drawing::of(chart, WIDTH).svg(None)
}

impl Drawing {
    /// A standalone SVG, so wide on paper \[mm\], or as wide as it is laid out \[px\].
    pub(super) fn svg(&self, paper: Option<f64>) -> String {
        svg::svg(self, paper)
    }

    /// A PDF file with a page of this width \[pt\], which the drawing fills.
    pub(super) fn pdf(&self, title: &str, width: f64) -> Vec<u8> {
        Pdf { title: title.to_owned(), pages: vec![pdf::page(self, width)], ..Pdf::default() }.bytes()
    }
}
