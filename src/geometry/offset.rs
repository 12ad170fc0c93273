//! Counter-tools: the offset of a profile on the sheet's side, and the die around a cavity.

use super::{Fold, Piece, Point, Profile, crossing::common, fillet::parallel_arc, on_axis, turn, turn_on_axis, turned};
use std::f64::consts::PI;

/// Largest turn of a hollow vertex that counts as rounding of a drawing \[rad\].
const KINK: f64 = 5.0 * PI / 180.0;

/// Reason why a profile has no offset.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum OffsetError {
    /// A hollow has no room for the offset.
    #[error("the hollow of radius {radius:.4} mm at r = {:.4} mm, z = {:.4} mm is smaller than the offset", at.x, at.y)]
    TooTight {
        /// Radius of the hollow \[mm\], 0 at a sharp vertex.
        radius: f64,
        /// Position \[mm\].
        at: Point,
    },
    /// The offset meets itself.
    #[error("its walls are too close to each other: the offset runs into itself at r = {:.4} mm, z = {:.4} mm", at.x, at.y)]
    Crosses {
        /// Position \[mm\].
        at: Point,
    },
}

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
    /// Line at `by` > 0 \[mm\] on the left; sharp corners become arcs. Fails when a hollow is narrower than `by`.
    pub fn offset(&self, by: f64) -> Result<Self, OffsetError> {
        let mut moved = Vec::new();
        for piece in self.pieces() {
            match (piece.parallel(by), piece) {
                (Some(beside), _) if beside.length() > super::profile::GAP => moved.push(beside),
                (_, Piece::Arc(a)) if a.radius < by * (1.0 - 1e-9) => {
                    return Err(OffsetError::TooTight { radius: a.radius, at: piece.sample(2)[1] });
                }
                // shrunk to a point
                _ => {}
            }
        }
        let tips = self.end_tangents().into_iter().filter(|(p, _)| on_axis(p)).map(|(p, t)| (p, turn_on_axis(t)));
        if let Some((at, _)) = self.vertices().map(|v| (v.point, v.turn)).chain(tips).find(|(_, turn)| *turn > KINK) {
            return Err(OffsetError::TooTight { radius: 0.0, at });
        }
        let mut line = self.corner_on_axis(by, true).into_iter().collect::<Vec<_>>();
        moved.into_iter().chain(self.corner_on_axis(by, false)).for_each(|piece| join(&mut line, piece, by));
        let offset = Self::new(line).map_err(|_| OffsetError::TooTight { radius: 0.0, at: self.first() })?;
        match offset.fold() {
            Some(Fold::Back { at, .. } | Fold::Crossing { at, .. }) => Err(OffsetError::Crosses { at }),
            None => Ok(offset),
        }
    }

    /// Die with this line as its cavity, drawn from the axis outward: down to the height `face`, a corner of the radius `shoulder`
    /// and the face out to `reach` \[mm\]; the result is drawn inward.
    /// Fails when the line does not cross the face, or the shoulder has no room.
    pub fn cavity(&self, face: f64, shoulder: f64, reach: f64) -> Result<Self, CavityError> {
        if self.first().y <= face {
            return Err(CavityError::Below(face - self.first().y));
        }
        let plane = Piece::line(Point::new(reach, face), Point::new(0.0, face));
        let crossed = self.pieces().iter().position(|piece| !common(piece, &plane).is_empty());
        let crossed = crossed.ok_or(CavityError::Above(self.last().y - face))?;
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

    pub(super) fn end_tangents(&self) -> [(Point, Point); 2] {
        let [first, last] = [self.pieces[0], self.pieces[self.pieces.len() - 1]];
        [(first.first(), first.tangent(false)), (last.last(), last.tangent(true))]
    }

    fn corner_on_axis(&self, by: f64, at_first: bool) -> Option<Piece> {
        let (tip, tangent) = self.end_tangents()[usize::from(!at_first)];
        let turn = turn_on_axis(tangent);
        if !on_axis(&tip) || -turn * by < super::profile::GAP {
            return None;
        }
        let normal = turned(tangent);
        let at_tangent = normal.y.atan2(normal.x);
        Some(Piece::arc(tip, by, if at_first { at_tangent - 0.5 * turn } else { at_tangent }, 0.5 * turn))
    }
}

fn join(line: &mut Vec<Piece>, piece: Piece, by: f64) {
    let Some(last) = line.last().copied() else { return line.push(piece) };
    let (a, b) = (last.tangent(true), piece.tangent(false));
    let turn = turn(a, b);
    if (piece.first() - last.last()).norm() < super::profile::GAP {
        return line.push(piece);
    }
    if turn < 0.0 {
        let normal = turned(a);
        line.push(Piece::arc(last.last() - by * normal, by, normal.y.atan2(normal.x), turn));
        return line.push(piece);
    }
    let near = |p: &Point| (p - last.last()).norm_squared();
    if let Some(cut) = common(&last, &piece).into_iter().min_by(|p, q| near(p).total_cmp(&near(q))) {
        line.pop();
        line.extend(last.split(cut)[0]);
        line.extend(piece.split(cut)[1]);
    } else {
        line.push(piece);
    }
}
