//! Tool sections: exact segments and arcs joined into oriented chains.
//!
//! # Frame and sign
//! Points are `[r, z]` in mm; z is positive in the direction of punch travel. Going along a chain, **the
//! sheet lies on the left**: the outward normal is the tangent turned by +90°, and the signed distance is
//! positive on the sheet's side, negative inside the tool.

mod crossing;
mod fillet;
mod offset;
mod piece;
mod profile;
mod queries;
mod rounding;
mod shapes;

pub use crossing::Fold;
pub use fillet::{FilletTooLarge, fillet, with_radius};
pub use offset::{CavityError, OffsetError};
pub(crate) use piece::Bounds;
pub use piece::{Arc, Piece, Segment};
pub use profile::{Closest, Nearest, Profile, ProfileError};
pub use queries::Vertex;
pub use rounding::{CORNER, biarc};
pub use shapes::{Entry, Opening, OpeningError};

/// A point or vector `[r, z]` in mm.
pub type Point = nalgebra::Vector2<f64>;

pub(crate) fn turned(v: Point) -> Point {
    Point::new(-v.y, v.x)
}

/// Angle from one direction to another \[rad\], positive counter-clockwise, within ±π.
pub(crate) fn turn(from: Point, to: Point) -> f64 {
    from.perp(&to).atan2(from.dot(&to))
}

pub(crate) fn on_axis(point: &Point) -> bool {
    point.x.abs() < 1e-9
}

/// Turn between a chain and its mirror image on the axis \[rad\].
pub(crate) fn turn_on_axis(tangent: Point) -> f64 {
    let image = Point::new(tangent.x, -tangent.y);
    // Towards the axis the image comes after, from the axis before.
    if tangent.x < 0.0 { turn(tangent, image) } else { turn(image, tangent) }
}
