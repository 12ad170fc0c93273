//! A chart laid out.

use super::backend::Recorder;
use super::mark::Mark;
use super::page::Page;
use super::palette::Palette;
use super::raster::{Picture, Raster};
use crate::plot::chart::Chart;
use plotters::drawing::IntoDrawingArea;

/// A chart laid out: what is drawn on white, one mark over the other.
pub(crate) struct Drawing {
    pub width: f64,
    pub height: f64,
    pub marks: Vec<Mark>,
}

impl Drawing {
    /// So wide \[px\]: letters and lines are as large as in any other width.
    pub fn of(chart: &Chart, width: f64) -> Self {
        let page = Page::of(chart, width);
        let mut marks = Vec::new();
        let height = page.height;
        page.draw(chart, &Recorder { size: [width, height], marks: &mut marks }.into_drawing_area());
        Self { width, height, marks }
    }

    /// The drawing with so many pixels per px.
    pub fn pixels(&self, density: f64, palette: &mut Palette) -> Picture {
        palette.reserve(self.marks.iter().map(Mark::color));
        let mut raster = Raster::new(self.width, self.height, density, palette);
        self.marks.iter().for_each(|mark| raster.draw(mark));
        raster.picture()
    }
}
