//! One map of colours for whatever rises evenly.

use super::chart::Color;

/// viridis in nine equal parts, from dark to light: even steps are seen as even, by colour-blind readers too, and stay in
/// order where only the lightness is printed.
///
/// # References
/// N. J. Smith, S. van der Walt, viridis, colour map of matplotlib 2.0 (2015), given to the public domain (CC0).
const MAP: [Color; 10] = [
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

/// The colour at a share of the way up, from 0, dark, to 1, light.
pub(crate) fn viridis(share: f64) -> Color {
    let at = share.clamp(0.0, 1.0) * (MAP.len() - 1) as f64;
    let (below, above) = (MAP[at as usize], MAP[(at as usize + 1).min(MAP.len() - 1)]);
    let mix = |a: u8, b: u8| (f64::from(a) + at.fract() * (f64::from(b) - f64::from(a))).round() as u8;
    (mix(below.0, above.0), mix(below.1, above.1), mix(below.2, above.2))
}
