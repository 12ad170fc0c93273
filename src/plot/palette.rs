//! Colours and dashes that colour-blind readers and grey prints tell apart.

use super::chart::{Color, Style};
use plotters::style::Color as _;
use plotters::style::colors::colormaps::{ColorMap, ViridisRGB};

/// White.
pub const WHITE: Color = (255, 255, 255);
/// Text and axes.
pub const BLACK: Color = (0, 0, 0);
/// Background lines.
pub const GREY: Color = (120, 120, 120);
/// Tool bodies.
pub const PALE: Color = (222, 222, 222);

/// Number of distinct colours.
pub const COLORS: usize = PALETTE.len();

/// Colours that stay apart for colour-blind readers.
///
/// Source: M. Okabe, K. Ito, Color Universal Design (2008); yellow is left out, it is lost on white.
const PALETTE: [Color; 7] =
    [(0, 114, 178), (213, 94, 0), (0, 158, 115), (204, 121, 167), (230, 159, 0), (86, 180, 233), BLACK];

const DASHES: [&[f64]; 5] = [&[], &[9.0, 4.0], &[2.5, 3.0], &[12.0, 3.5, 2.5, 3.5], &[18.0, 5.0]];

/// Colour of the `i`-th curve.
pub fn color(i: usize) -> Color {
    PALETTE[i % PALETTE.len()]
}

/// Mixes the colour with two parts of white.
pub fn pale(color: Color) -> Color {
    let pale = |c: u8| 255 - (255 - c) / 3;
    (pale(color.0), pale(color.1), pale(color.2))
}

/// Colour of the viridis map, from 0 (dark) to 1 (light): even steps are seen as even, in grey print too.
pub fn viridis(share: f64) -> Color {
    ViridisRGB.get_color(share).rgb()
}

impl Style {
    /// Line of the `i`-th curve; colour and dashes differ from those of its neighbours.
    pub fn curve(i: usize) -> Self {
        Self::Line { color: color(i), width: 2.4, dash: DASHES[i % DASHES.len()] }
    }

    /// Solid line.
    pub fn solid(color: Color, width: f64) -> Self {
        Self::Line { color, width, dash: &[] }
    }

    /// Filled polygon without an outline.
    pub fn area(fill: Color) -> Self {
        Self::Area { fill, edge: None }
    }

    /// Thin pale line of the same colour and dashes, for the background.
    pub fn faint(self) -> Self {
        let Self::Line { color, dash, .. } = self else { return self };
        Self::Line { color: pale(color), width: 1.2, dash }
    }
}
