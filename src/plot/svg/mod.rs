//! SVG by plotters: the only source of every picture.
//!
//! Lengths are in px of a picture 800 px wide, from the upper left corner, y down, unless they are in backend [`units`].

mod annotations;
mod page;
mod panel;
mod shapes;
pub(crate) mod text;
mod ticks;

use super::*;
use plotters::drawing::{DrawingArea, IntoDrawingArea};
use plotters::style::{self, RGBColor};
use plotters::{backend::SVGBackend, coord::Shift};
use text::FONT;

/// Width of a picture \[px\], unless another one is asked for.
pub const WIDTH: f64 = 800.0;

/// Backend units per px: plotters rounds to whole units, which shows as steps in curves at 1.
const FINE: f64 = 8.0;
/// Height of the canvas until its content is drawn \[units\].
const TALL: u32 = 1_999_999_999;
const IN_MEMORY: &str = "drawing into memory does not fail";

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Standalone SVG of a picture, 800 px wide.
pub fn svg(chart: &Chart) -> String {
    sized(chart, WIDTH, None)
}

pub(super) fn sized(chart: &Chart, width: f64, paper: Option<f64>) -> String {
    text::register();
    let chart = &chart.clone().displayed();
    let wide = units(width) as u32;
    let mut svg = String::new();
    let height = {
        let canvas = SVGBackend::with_string(&mut svg, (wide, TALL)).into_drawing_area();
        canvas.fill(&style::WHITE).expect(IN_MEMORY);
        let height = page::draw(chart, width, &canvas);
        canvas.present().expect(IN_MEMORY);
        height
    };
    let outer = match paper {
        Some(mm) => format!("<svg width=\"{mm}mm\" height=\"{:.2}mm\"", height * mm / width),
        None => format!("<svg width=\"{width}\" height=\"{height}\""),
    };
    let inner = format!("<svg width=\"{wide}\" height=\"{TALL}\"");
    let family = format!(" font-family=\"{FONT}\"");
    let svg = svg.replace(" opacity=\"1\"", "").replace(&family, "").replacen(&inner, &outer, 1);
    let svg = svg.replace(&TALL.to_string(), &units(height).to_string());
    svg.replacen("<svg", &format!("<svg{family} stroke-linejoin=\"round\""), 1)
}

fn units(px: f64) -> i32 {
    (px * FINE).round() as i32
}

fn rgb(color: Color) -> RGBColor {
    RGBColor(color.0, color.1, color.2)
}
