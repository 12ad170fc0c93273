//! Draws a [`Chart`]: plotters lays it out once as [`Mark`]s, and these become SVG or pixels.
//!
//! Lengths in this folder are in px of a picture 800 wide, from its upper left corner, y down, unless they say "units".

mod backend;
mod page;
mod palette;
mod panel;
mod raster;
mod shape;
mod stroke;
mod svg;
mod text;
mod ticks;

use super::chart::{Chart, Color};
use backend::Recorder;
use page::Page;
pub(super) use palette::Palette;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::style::text_anchor::HPos;
use raster::{Picture, Raster};

/// Width of every picture; its height follows from what it holds.
const WIDTH: f64 = 800.0;
/// Around every picture.
const MARGIN: f64 = 14.0;

type Point = (f64, f64);
type Canvas<'a> = DrawingArea<Recorder<'a>, Shift>;

const NEVER: &str = "nothing fails on the way into memory";

/// A chart laid out: what is drawn on white, one mark over the other.
pub(super) struct Drawing {
    pub height: f64,
    pub marks: Vec<Mark>,
}

/// What is drawn with one pen.
pub(super) enum Mark {
    Area {
        outline: Vec<Point>,
        fill: Color,
    },
    /// The pieces of one line; joins are round, ends are not.
    Line {
        pieces: Vec<Vec<Point>>,
        color: Color,
        width: f64,
    },
    /// White inside.
    Circle {
        at: Point,
        radius: f64,
        color: Color,
        width: f64,
    },
    /// A line of text; `at` is on its baseline, and it goes up the page where it is turned.
    Text {
        text: String,
        size: f64,
        color: Color,
        at: Point,
        anchor: HPos,
        turned: bool,
    },
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

impl Mark {
    fn color(&self) -> Color {
        match self {
            Self::Area { fill, .. } => *fill,
            Self::Line { color, .. } | Self::Circle { color, .. } | Self::Text { color, .. } => *color,
        }
    }
}

/// The picture as a standalone SVG, 800 px wide.
pub fn svg(chart: &Chart) -> String {
    svg::svg(&Drawing::of(chart))
}
