//! Up to 256 colours, and what becomes of one where another covers it in part.

use super::cover::FULL;
use crate::plot::chart::{Color, WHITE};

/// Levels of cover.
const LEVELS: usize = FULL as usize + 1;

/// Blends that differ by no more than this take the same colour: the sum of squares over red, green and blue.
const ALIKE: i32 = 32;

/// Blends in a cell of so many steps of red, green and blue take the same colour too, that of the first.
const CELL: usize = 8;
const CELLS: usize = 256 / CELL;

/// Colours that a byte tells apart.
const MOST: usize = 256;

const UNKNOWN: u16 = u16::MAX;

/// The colours of a picture, in the order in which they came; the first is white.
///
/// Once there are as many as a byte can tell apart, new blends take the nearest of them.
pub struct Palette {
    colors: Vec<[u8; 3]>,
    /// What was blended before, by the colour on top, the one below and the level, or [`UNKNOWN`].
    known: Vec<u16>,
    /// What was taken for a blend in each cell of [`CELL`] by [`CELL`] by [`CELL`] colours, or [`UNKNOWN`].
    cells: Vec<u16>,
}

impl Default for Palette {
    fn default() -> Self {
        Self { colors: vec![WHITE.into()], known: Vec::new(), cells: vec![UNKNOWN; CELLS.pow(3)] }
    }
}

impl Palette {
    pub fn colors(&self) -> &[[u8; 3]] {
        &self.colors
    }

    /// Takes in flat colours ahead of their blends, so that they are kept exactly.
    pub(super) fn reserve(&mut self, colors: impl Iterator<Item = Color>) {
        colors.for_each(|color| {
            self.number(color);
        });
    }

    /// The number of a colour, or of the nearest where there is no room for it.
    pub(super) fn number(&mut self, color: Color) -> u8 {
        let color = color.into();
        // Flat colours come first.
        let found = self.colors.iter().position(|known| *known == color);
        found.map_or_else(|| self.nearest(color, 0), |number| number as u8)
    }

    /// Lays a colour over pixels, all of which it covers to this level.
    pub(super) fn paint(&mut self, pixels: &mut [u8], over: u8, level: u8) {
        match pixels {
            [pixel] => *pixel = self.blended(over, *pixel, level),
            _ if level == FULL => pixels.fill(over),
            _ => pixels.iter_mut().for_each(|pixel| *pixel = self.blended(over, *pixel, level)),
        }
    }

    /// The number of a colour of which `level` out of [`FULL`] parts lie on another.
    fn blended(&mut self, over: u8, below: u8, level: u8) -> u8 {
        let key = (usize::from(over) * MOST + usize::from(below)) * LEVELS + usize::from(level);
        match self.known.get(key) {
            Some(&known) if known != UNKNOWN => known as u8,
            _ => self.blend(over, below, level, key),
        }
    }

    /// The same for the first time.
    #[cold]
    fn blend(&mut self, over: u8, below: u8, level: u8, key: usize) -> u8 {
        let [over, below, level, full] = [over, below, level, FULL].map(usize::from);
        if key >= self.known.len() {
            self.known.resize((over + 1) * MOST * LEVELS, UNKNOWN);
        }
        let (top, base) = (self.colors[over], self.colors[below]);
        let mix = |i: usize| {
            let (top, base) = (usize::from(top[i]), usize::from(base[i]));
            ((top * level + base * (full - level) + full / 2) / full) as u8
        };
        let color = [mix(0), mix(1), mix(2)];
        let cell = color.iter().fold(0, |cell, part| cell * CELLS + usize::from(*part) / CELL);
        let found = match self.cells[cell] {
            _ if level == full => over as u8,
            UNKNOWN => self.nearest(color, ALIKE),
            found => found as u8,
        };
        if level < full {
            self.cells[cell] = found.into();
        }
        self.known[key] = found.into();
        found
    }

    /// A colour that there is where one is `alike` enough or there is no room, or else the colour itself, which is added.
    fn nearest(&mut self, color: [u8; 3], alike: i32) -> u8 {
        let apart = |other: &[u8; 3]| (0..3).map(|i| i32::from(color[i].abs_diff(other[i])).pow(2)).sum::<i32>();
        let found = self.colors.iter().map(apart).enumerate().min_by_key(|(_, apart)| *apart);
        match found {
            Some((number, apart)) if apart <= alike || self.colors.len() == MOST => number as u8,
            _ => {
                self.colors.push(color);
                (self.colors.len() - 1) as u8
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: half of black on white is grey by hand; a full palette still finds what is nearest.
    #[test]
    fn blends_are_between_their_colours_and_a_full_palette_takes_the_nearest() {
        let mut palette = Palette::default();
        let black = palette.number((0, 0, 0));
        assert_eq!((palette.blended(black, 0, 0), palette.blended(black, 0, FULL)), (0, black));
        let third = palette.blended(black, 0, 5);
        assert_eq!(palette.colors()[usize::from(third)], [170; 3]);
        for red in 0..=255 {
            palette.number((red, 10, 0));
        }
        assert_eq!(palette.colors().len(), MOST);
        let near = palette.number((90, 14, 2));
        assert_eq!(palette.colors()[usize::from(near)], [90, 10, 0]);
    }
}
