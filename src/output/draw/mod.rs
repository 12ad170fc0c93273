//! Draws a [`Chart`] as SVG; the only place that knows plotters.
//!
//! plotters rounds to whole units, so the canvas is [`FINE`] times larger than the picture, and the SVG's size is
//! then written back with a view box. Lengths in this folder are in px of the picture unless they say "units".

mod page;
mod panel;
mod shape;
mod text;
mod ticks;

use super::chart::Chart;
use super::font::FAMILY;
use page::Page;
use plotters::coord::Shift;
use plotters::prelude::*;

/// Canvas units per px.
const FINE: f64 = 8.0;
/// Width of every picture; its height follows from what it holds.
const WIDTH: f64 = 800.0;
/// Around every picture.
const MARGIN: f64 = 14.0;

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Nothing fails on the way into a string with a font that is built in.
const NEVER: &str = "drawing into memory with a built-in font";

/// The picture as a standalone SVG, 800 px wide.
pub fn svg(chart: &Chart) -> String {
    text::register();
    let page = Page::of(chart);
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, (units(WIDTH) as u32, units(page.height) as u32));
        let canvas = canvas.into_drawing_area();
        canvas.fill(&WHITE).expect(NEVER);
        page.draw(chart, &canvas);
        canvas.present().expect(NEVER);
    }
    // The first tag states the size in units: state it in px, and let lines join and fonts fall back smoothly.
    let body = svg.split_once('>').map_or("", |(_, body)| body);
    let family = format!("font-family=\"{FAMILY}\"");
    format!(
        "<svg width=\"{WIDTH}\" height=\"{}\" viewBox=\"0 0 {} {}\" stroke-linejoin=\"round\" \
         xmlns=\"http://www.w3.org/2000/svg\">{}",
        page.height,
        units(WIDTH),
        units(page.height),
        body.replace(&family, &format!("font-family=\"{FAMILY}, Verdana, sans-serif\""))
    )
}

fn units(px: f64) -> i32 {
    (px * FINE).round() as i32
}
