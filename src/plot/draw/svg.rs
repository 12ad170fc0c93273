//! Marks as SVG.

use super::drawing::Drawing;
use super::mark::{Mark, Point};
use crate::plot::chart::Color;
use crate::plot::font::FAMILY;
use plotters::style::text_anchor::HPos;
use std::fmt::{Display, Write};

/// A standalone SVG, so wide on paper \[mm\] or else as many px as it is laid out in; the font falls back smoothly where it
/// is not installed.
pub(super) fn svg(drawing: &Drawing, paper: Option<f64>) -> String {
    let Drawing { width, height, .. } = drawing;
    let size = match paper {
        Some(mm) => format!("width=\"{mm}mm\" height=\"{}mm\"", rounded(height * mm / width)),
        None => format!("width=\"{width}\" height=\"{height}\""),
    };
    let mut svg = format!(
        "<svg {size} viewBox=\"0 0 {width} {height}\" stroke-linejoin=\"round\" \
         font-family=\"{FAMILY}, Verdana, sans-serif\" xmlns=\"http://www.w3.org/2000/svg\">\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#FFFFFF\"/>\n"
    );
    for mark in &drawing.marks {
        // Nothing fails on the way into a string.
        let _ = writeln!(svg, "{}", Element(mark));
    }
    svg.push_str("</svg>\n");
    svg
}

struct Element<'a>(&'a Mark);

impl Display for Element<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        match self.0 {
            Mark::Area { outline, fill } => write!(f, "<path fill=\"{}\" d=\"{}Z\"/>", hex(*fill), path(outline)),
            Mark::Line { pieces, color, width } => {
                let d: String = pieces.iter().map(|piece| path(piece)).collect();
                write!(f, "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{width}\" d=\"{d}\"/>", hex(*color))
            }
            Mark::Circle { at, radius, color, width } => write!(
                f,
                "<circle cx=\"{}\" cy=\"{}\" r=\"{radius}\" fill=\"#FFFFFF\" stroke=\"{}\" stroke-width=\"{width}\"/>",
                rounded(at.0),
                rounded(at.1),
                hex(*color)
            ),
            Mark::Text { text, size, color, at, anchor, turned } => {
                let (x, y) = (rounded(at.0), rounded(at.1));
                let anchor = match anchor {
                    HPos::Left => "",
                    HPos::Center => " text-anchor=\"middle\"",
                    HPos::Right => " text-anchor=\"end\"",
                };
                write!(f, "<text x=\"{x}\" y=\"{y}\" font-size=\"{size}\" fill=\"{}\"{anchor}", hex(*color))?;
                if *turned {
                    write!(f, " transform=\"rotate(270, {x}, {y})\"")?;
                }
                write!(f, ">{}</text>", text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;"))
            }
        }
    }
}

/// `M1,2L3,4`
fn path(points: &[Point]) -> String {
    let step = |(i, p): (usize, &Point)| format!("{}{},{}", if i == 0 { 'M' } else { 'L' }, rounded(p.0), rounded(p.1));
    points.iter().enumerate().map(step).collect()
}

/// A hundredth of a px is not seen.
fn rounded(px: f64) -> f64 {
    (100.0 * px).round() / 100.0 + 0.0
}

fn hex((red, green, blue): Color) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}
