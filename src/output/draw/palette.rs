//! Up to 256 colours, and what becomes of one where another covers it in part.

use crate::output::chart::{Color, WHITE};

/// Steps in which a pixel is covered, from nothing to all of it; finer ones are not seen at an edge.
pub(super) const LEVELS: usize = 16;

/// Colours that a byte tells apart.
const MOST: usize = 256;

/// The colours of a picture, in the order in which they came; the first is white.
///
/// Once there are as many as a byte can tell apart, new blends take the nearest of them.
pub struct Palette {
    colors: Vec<[u8; 3]>,
    /// What was blended before, by the colour on top, the one below and the level.
    known: Vec<Option<Box<[Option<u8>; MOST * LEVELS]>>>,
}

impl Default for Palette {
    fn default() -> Self {
        Self { colors: vec![WHITE.into()], known: Vec::new() }
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
        self.nearest(color.into())
    }

    /// The number of a colour of which `level` out of `LEVELS − 1` parts lie on another.
    pub(super) fn blended(&mut self, over: u8, below: u8, level: usize) -> u8 {
        let (over, below) = (usize::from(over), usize::from(below));
        if self.known.len() <= over {
            self.known.resize(over + 1, None);
        }
        let known = self.known[over].get_or_insert_with(|| Box::new([None; MOST * LEVELS]));
        if let Some(known) = known[below * LEVELS + level] {
            return known;
        }
        let (top, base) = (self.colors[over], self.colors[below]);
        let full = LEVELS - 1;
        let mix = |i: usize| {
            let (top, base) = (usize::from(top[i]), usize::from(base[i]));
            ((top * level + base * (full - level) + full / 2) / full) as u8
        };
        let found = self.nearest([mix(0), mix(1), mix(2)]);
        if let Some(known) = &mut self.known[over] {
            known[below * LEVELS + level] = Some(found);
        }
        found
    }

    /// The colour itself, which is added while there is room, or else the nearest.
    fn nearest(&mut self, color: [u8; 3]) -> u8 {
        let apart = |other: &[u8; 3]| (0..3).map(|i| i32::from(color[i].abs_diff(other[i])).pow(2)).sum::<i32>();
        let found = self.colors.iter().map(apart).enumerate().min_by_key(|(_, apart)| *apart);
        match found {
            Some((number, apart)) if apart == 0 || self.colors.len() == MOST => number as u8,
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
        assert_eq!((palette.blended(black, 0, 0), palette.blended(black, 0, LEVELS - 1)), (0, black));
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
