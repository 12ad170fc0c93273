//! Bounding boxes of pieces.

use super::{Piece, Point};

/// Bounding box \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounds {
    pub low: Point,
    pub high: Point,
}

impl Bounds {
    /// Box around pieces; `None` without pieces.
    pub fn around(pieces: &[Piece]) -> Option<Self> {
        pieces.iter().map(Piece::bounds).reduce(|a, b| Self { low: a.low.inf(&b.low), high: a.high.sup(&b.high) })
    }

    fn with(self, p: Point) -> Self {
        Self { low: self.low.inf(&p), high: self.high.sup(&p) }
    }

    /// True if a point lies farther away than `margin` \[mm\] along an axis.
    pub fn is_beyond(&self, p: Point, margin: f64) -> bool {
        self.is_apart(&Self { low: p, high: p }, margin)
    }

    /// True if two boxes lie farther apart than `margin` \[mm\] along an axis.
    pub fn is_apart(&self, other: &Self, margin: f64) -> bool {
        (self.low - other.high).sup(&(other.low - self.high)).max() > margin
    }
}

impl Piece {
    pub(crate) fn bounds(&self) -> Bounds {
        let ends = Bounds { low: self.first(), high: self.first() }.with(self.last());
        self.poles().fold(ends, Bounds::with)
    }

    /// Points of an arc where it is parallel to an axis.
    pub(crate) fn poles(&self) -> impl Iterator<Item = Point> + use<> {
        let arc = if let Piece::Arc(arc) = *self { Some(arc) } else { None };
        let poles = [Point::x(), Point::y(), -Point::x(), -Point::y()].map(|way| {
            arc.map(|arc| arc.center + arc.radius * way).filter(|pole| arc.is_some_and(|arc| arc.faces(*pole)))
        });
        poles.into_iter().flatten()
    }
}
