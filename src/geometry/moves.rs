//! Pieces and profiles moved along z, reversed, mirrored.

use super::{Arc, Piece, Point, Profile, Segment};
use std::f64::consts::PI;

impl Piece {
    /// Piece walked the other way.
    pub fn reversed(&self) -> Self {
        match self {
            Piece::Segment(s) => Piece::Segment(Segment::new(s.to, s.from)),
            Piece::Arc(a) => Piece::Arc(Arc::new(a.center, a.radius, a.start + a.sweep, -a.sweep)),
        }
    }

    /// Mirror image in the axis r = 0.
    pub fn across_axis(&self) -> Self {
        let image = |p: Point| Point::new(-p.x, p.y);
        match self {
            Piece::Segment(s) => Piece::Segment(Segment::new(image(s.from), image(s.to))),
            Piece::Arc(a) => Piece::Arc(Arc::new(image(a.center), a.radius, PI - a.start, -a.sweep)),
        }
    }

    /// Mirror image in the plane z = 0.
    pub fn upside_down(&self) -> Self {
        let image = |p: Point| Point::new(p.x, -p.y);
        match self {
            Piece::Segment(s) => Piece::Segment(Segment::new(image(s.from), image(s.to))),
            Piece::Arc(a) => Piece::Arc(Arc::new(image(a.center), a.radius, -a.start, -a.sweep)),
        }
    }
}

impl Profile {
    /// Profile moved by `dz` \[mm\] along z.
    pub fn shifted(&self, dz: f64) -> Self {
        let up = Point::new(0.0, dz);
        self.each(|piece| match piece {
            Piece::Segment(s) => Piece::Segment(Segment::new(s.from + up, s.to + up)),
            Piece::Arc(a) => Piece::Arc(Arc::new(a.center + up, a.radius, a.start, a.sweep)),
        })
    }

    /// Line walked the other way: the sheet's side becomes the tool's.
    pub fn reversed(&self) -> Self {
        let pieces = self.pieces().iter().rev().map(Piece::reversed);
        Self::new(pieces.collect()).expect("a reversed chain stays connected")
    }

    /// Mirror image in the plane z = 0, the sheet on the left again: a punch becomes a die.
    pub fn mirrored(&self) -> Self {
        self.each(Piece::upside_down).reversed()
    }

    fn each(&self, change: impl Fn(&Piece) -> Piece) -> Self {
        Self::new(self.pieces().iter().map(change).collect())
            .expect("rigid motions and mirroring keep chains connected")
    }
}
