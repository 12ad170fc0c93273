//! Colours and dashes that colour-blind readers and grey prints tell apart.

use super::chart::{Color, Style};

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
/// # References
/// M. Okabe, K. Ito, Color Universal Design (2008); yellow is left out, it is lost on white.
const PALETTE: [Color; 7] =
    [(0, 114, 178), (213, 94, 0), (0, 158, 115), (204, 121, 167), (230, 159, 0), (86, 180, 233), BLACK];

/// Dash patterns that keep curves apart in black and white.
const DASHES: [&[f64]; 5] = [&[], &[9.0, 4.0], &[2.5, 3.0], &[12.0, 3.5, 2.5, 3.5], &[18.0, 5.0]];

/// viridis in nine equal parts from dark to light: even steps are seen as even, in grey print too.
///
/// # References
/// N. J. Smith, S. van der Walt, viridis, colour map of matplotlib 2.0 (2015), public domain (CC0).
const VIRIDIS: [Color; 10] = [
    (68, 1, 84),
    (72, 40, 120),
    (62, 74, 137),
    (49, 104, 142),
    (38, 130, 142),
    (31, 158, 137),
    (53, 183, 121),
    (109, 205, 89),
    (180, 222, 44),
    (253, 231, 37),
];

/// Colour of the `i`-th curve.
pub fn color(i: usize) -> Color {
    PALETTE[i % PALETTE.len()]
}

/// Mixes the colour with two parts of white.
pub fn pale(color: Color) -> Color {
    let pale = |c: u8| 255 - (255 - c) / 3;
    (pale(color.0), pale(color.1), pale(color.2))
}

/// Colour of the viridis map, from 0 (dark) to 1 (light).
pub fn viridis(share: f64) -> Color {
    let at = share.clamp(0.0, 1.0) * (VIRIDIS.len() - 1) as f64;
    let (below, above) = (VIRIDIS[at as usize], VIRIDIS[(at as usize + 1).min(VIRIDIS.len() - 1)]);
    let mix = |a: u8, b: u8| (f64::from(a) + at.fract() * (f64::from(b) - f64::from(a))).round() as u8;
    (mix(below.0, above.0), mix(below.1, above.1), mix(below.2, above.2))
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

    /// Dashed line.
    pub fn dashed(color: Color, width: f64, dash: &'static [f64]) -> Self {
        Self::Line { color, width, dash }
    }

    /// Filled polygon without an outline.
    pub fn area(fill: Color) -> Self {
        Self::Area { fill, edge: None }
    }

    /// Thin pale line of the same colour and dashes, for the background.
    pub fn faint(self) -> Self {
        match self {
            Self::Line { color, dash, .. } => Self::Line { color: pale(color), width: 1.2, dash },
            other => other,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_differ_in_colour_or_dashes() {
        let styles: Vec<Style> = (0..DASHES.len() * PALETTE.len()).map(Style::curve).collect();
        assert!((0..styles.len()).all(|i| !styles[..i].contains(&styles[i])));
    }
}
