//! Draws a [`Chart`]: plotters lays it out once as [`Mark`]s, and these become SVG or pixels.
//!
//! Lengths in this folder are in px of a picture 800 wide, from its upper left corner, y down, unless they say "units".

mod backend;
mod canvas;
mod cover;
mod drawing;
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
pub(super) use drawing::Drawing;
#[cfg(test)]
pub(super) use mark::Mark;
pub(super) use palette::Palette;

/// The picture as a standalone SVG, 800 px wide.
pub fn svg(chart: &Chart) -> String {
    svg::svg(&Drawing::of(chart))
}

/// The picture as a page of its own, in a PDF file, this wide \[pt\].
pub fn pdf(chart: &Chart, width: f64) -> Vec<u8> {
    Pdf { title: chart.title.clone(), pages: vec![pdf::page(&Drawing::of(chart), width)], ..Pdf::default() }.bytes()
}
