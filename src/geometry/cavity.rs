//! Die around a cavity: a line cut off at the die's face, with a shoulder.

use super::crossing::common;
use super::fillet::parallel_arc;
use super::{Piece, Point, Profile};

/// Reason why a line does not become a die.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CavityError {
    /// Depth of the line's first point below the face \[mm\].
    #[error("the cavity begins {0:.4} mm below the die's face")]
    Below(f64),
    /// Height of the line's last point above the face \[mm\].
    #[error("the cavity ends {0:.4} mm above the die's face")]
    Above(f64),
    /// Radius of a shoulder that does not fit \[mm\].
    #[error("a shoulder of {0:.4} mm finds no room between the face and the wall of the cavity")]
    Shoulder(f64),
}

impl Profile {
    /// Die with this line as its cavity, drawn from the axis outward: down to the height `face`, a corner of the radius `shoulder`
    /// and the face out to `reach` \[mm\]; the result is drawn inward.
    ///
    /// # Errors
    /// When the line does not cross the face, or the shoulder has no room.
    pub fn cavity(&self, face: f64, shoulder: f64, reach: f64) -> Result<Self, CavityError> {
        if self.first().y <= face {
            return Err(CavityError::Below(face - self.first().y));
        }
        let plane = Piece::line(Point::new(reach, face), Point::new(0.0, face));
        let crossing = self.pieces().iter().position(|piece| !common(piece, &plane).is_empty());
        let Some(crossed) = crossing else {
            return Err(CavityError::Above(self.last().y - face));
        };
        // The shoulder may use up the pieces next to the face.
        let corner = self.pieces()[..=crossed].iter().rev().enumerate().find_map(|(back, piece)| {
            let corner = parallel_arc(&plane, &piece.reversed(), -shoulder)?;
            (corner.sweep < 0.0).then_some((crossed - back, corner))
        });
        let Some((last, corner)) = corner else { return Err(CavityError::Shoulder(shoulder)) };
        let mut pieces = vec![Piece::line(Point::new(reach, face), corner.at(0.0)), Piece::Arc(corner)];
        pieces.extend(self.pieces()[last].reversed().split(corner.at(1.0))[1]);
        pieces.extend(self.pieces()[..last].iter().rev().map(Piece::reversed));
        Self::new(pieces).map_err(|_| CavityError::Shoulder(shoulder))
    }
}
