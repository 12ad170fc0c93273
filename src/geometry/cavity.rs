//! The die around a cavity: a line cut off at the die's face, with a shoulder between.

use super::crossing::common;
use super::fillet::arc_beside;
use super::{Piece, Point, Profile, Segment};

/// Why a line does not become a die.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CavityError {
    /// The line does not come up to the face.
    #[error("the cavity begins {below:.4} mm below the die's face")]
    Below {
        /// \[mm\]
        below: f64,
    },
    /// The line does not go down below the face.
    #[error("the cavity ends {above:.4} mm above the die's face")]
    Above {
        /// \[mm\]
        above: f64,
    },
    /// The corner does not fit.
    #[error("a shoulder of {shoulder:.4} mm finds no room between the face and the wall of the cavity")]
    Shoulder {
        /// \[mm\]
        shoulder: f64,
    },
}

impl Profile {
    /// The die whose cavity is this line, walked from the axis outward with the die on its left: the line down to the
    /// height `face` \[mm\], a convex corner of `shoulder` radius \[mm\], and the face out to `reach` \[mm\]. The result is
    /// walked from outside inward, the sheet (below) on its left.
    ///
    /// # Errors
    /// When the line does not lead from above the face to below it, or the shoulder finds no place.
    pub fn cavity(&self, face: f64, shoulder: f64, reach: f64) -> Result<Self, CavityError> {
        if self.first().y <= face {
            return Err(CavityError::Below { below: face - self.first().y });
        }
        let plane = Piece::Segment(Segment::new(Point::new(reach, face), Point::new(0.0, face)));
        let crossing = self.pieces().iter().position(|piece| !common(piece, &plane).is_empty());
        let Some(crossed) = crossing else {
            return Err(CavityError::Above { above: self.last().y - face });
        };
        // The shoulder may use up the pieces next to the face.
        let corner = self.pieces()[..=crossed].iter().rev().enumerate().find_map(|(back, piece)| {
            let corner = arc_beside(&plane, &piece.reversed(), -shoulder)?;
            (corner.sweep < 0.0).then_some((crossed - back, corner))
        });
        let Some((last, corner)) = corner else { return Err(CavityError::Shoulder { shoulder }) };
        let mut pieces =
            vec![Piece::Segment(Segment::new(Point::new(reach, face), corner.at(0.0))), Piece::Arc(corner)];
        pieces.extend(self.pieces()[last].reversed().split(corner.at(1.0))[1]);
        pieces.extend(self.pieces()[..last].iter().rev().map(Piece::reversed));
        Self::new(pieces).map_err(|_| CavityError::Shoulder { shoulder })
    }
}
