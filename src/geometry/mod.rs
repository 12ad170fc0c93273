//! Tool sections: exact segments and arcs joined into oriented chains.
//!
//! # Frame and sign
//! Points are `[r, z]` in mm; z is positive in the direction of punch travel. Going along a chain, **the
//! sheet lies on the left**: the outward normal is the tangent turned by +90°, and the signed distance is
//! positive on the sheet's side, negative inside the tool.

mod piece;
mod profile;
mod rounding;
mod shapes;

pub use piece::{Arc, Piece, Segment};
pub use profile::{Closest, Profile, ProfileError};

/// A point or vector `[r, z]` in mm.
pub type Point = nalgebra::Vector2<f64>;

/// The vector turned by +90° in the r-z plane.
pub(crate) fn turned(v: Point) -> Point {
    Point::new(-v.y, v.x)
}
