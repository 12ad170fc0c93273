//! A chart laid out.

use super::backend::Recorder;
use super::mark::{Mark, WIDTH};
use super::page::Page;
use super::palette::Palette;
use super::raster::{Picture, Raster};
use crate::output::chart::Chart;
use plotters::drawing::IntoDrawingArea;

/// A chart laid out: what is drawn on white, one mark over the other.
pub(crate) struct Drawing {
    pub height: f64,
    pub marks: Vec<Mark>,
}

impl Drawing {
    pub fn of(chart: &Chart) -> Self {
        let page = Page::of(chart);
        let mut marks = Vec::new();
        page.draw(chart, &Recorder { height: page.height, marks: &mut marks }.into_drawing_area());
        Self { height: page.height, marks }
    }

    /// The drawing with so many pixels per px.
    pub fn pixels(&self, density: f64, palette: &mut Palette) -> Picture {
        palette.reserve(self.marks.iter().map(Mark::color));
        let mut raster = Raster::new(WIDTH, self.height, density, palette);
        self.marks.iter().for_each(|mark| raster.draw(mark));
        raster.picture()
    }
}
