//! Pieces and profiles moved along z, reversed, mirrored.

use super::{Piece, Point, Profile};
use std::f64::consts::PI;

impl Piece {
    /// Image of the piece, by those of points and of angles; `turn` is −1 for a mirror image.
    fn image(&self, point: impl Fn(Point) -> Point, angle: impl Fn(f64) -> f64, turn: f64) -> Self {
        match self {
            Piece::Segment(s) => Piece::line(point(s.from), point(s.to)),
            Piece::Arc(a) => Piece::arc(point(a.center), a.radius, angle(a.start), turn * a.sweep),
        }
    }

    /// Piece walked the other way.
    pub fn reversed(&self) -> Self {
        match self {
            Piece::Segment(s) => Piece::line(s.to, s.from),
            Piece::Arc(a) => Piece::arc(a.center, a.radius, a.start + a.sweep, -a.sweep),
        }
    }

    /// Mirror image in the axis r = 0.
    pub fn across_axis(&self) -> Self {
        self.image(|p| Point::new(-p.x, p.y), |angle| PI - angle, -1.0)
    }

    /// Mirror image in the plane z = 0.
    pub fn upside_down(&self) -> Self {
        self.image(|p| Point::new(p.x, -p.y), |angle| -angle, -1.0)
    }
}

impl Profile {
    /// Profile moved by `dz` \[mm\] along z.
    pub fn shifted(&self, dz: f64) -> Self {
        let up = Point::new(0.0, dz);
        Self::connected(self.pieces().iter().map(|piece| piece.image(|p| p + up, |angle| angle, 1.0)))
    }

    /// Line walked the other way: the sheet's side becomes the tool's.
    pub fn reversed(&self) -> Self {
        Self::connected(self.pieces().iter().rev().map(Piece::reversed))
    }

    /// Mirror image in the plane z = 0, the sheet on the left again: a punch becomes a die.
    pub fn mirrored(&self) -> Self {
        Self::connected(self.pieces().iter().rev().map(|piece| piece.upside_down().reversed()))
    }
}
