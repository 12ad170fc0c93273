//! Standard tool shapes, placed so that they touch a flat sheet of thickness t whose mid-surface is z = 0:
//! punch and holder below (their faces at z = −t/2), the die above (its face at z = +t/2).

use super::{Piece, Point, Profile};
use std::f64::consts::FRAC_PI_2;

/// Straight walls go on for this multiple of the tool's largest radius [–]: past any travel that makes sense.
const REACH: f64 = 20.0;

fn line(from: (f64, f64), to: (f64, f64)) -> Piece {
    Piece::line(Point::new(from.0, from.1), Point::new(to.0, to.1))
}

fn arc(center: (f64, f64), radius: f64, start: f64, sweep: f64) -> Piece {
    Piece::arc(Point::new(center.0, center.1), radius, start, sweep)
}

impl Profile {
    /// Punch with a spherical (plane strain: cylindrical) nose of `radius` \[mm\] and a straight wall.
    pub fn hemispherical_punch(radius: f64, sheet_thickness: f64) -> Self {
        Self::flat_punch(radius, radius, sheet_thickness)
    }

    /// Flat punch of `radius` (plane strain: half-width) with a corner of `nose` radius \[mm\].
    pub fn flat_punch(radius: f64, nose: f64, sheet_thickness: f64) -> Self {
        let top = -0.5 * sheet_thickness;
        let flat = radius - nose;
        let face = (flat > 1e-9 * radius).then(|| line((0.0, top), (flat, top)));
        let corner = arc((flat, top - nose), nose, FRAC_PI_2, -FRAC_PI_2);
        let wall = line((radius, top - nose), (radius, top - nose - REACH * radius));
        Self::connected(face.into_iter().chain([corner, wall]))
    }

    /// Crowned punch: a face of large `face` radius blended by a corner of `nose` radius into a straight wall
    /// at `radius` \[mm\] (plane strain: half-width).
    pub fn crowned_punch(radius: f64, face: f64, nose: f64, sheet_thickness: f64) -> Self {
        let top = -0.5 * sheet_thickness;
        // The corner circle touches the wall and, from inside, the face circle.
        let corner_r = radius - nose;
        let between = face - nose;
        let corner_z = top - face + (between * between - corner_r * corner_r).sqrt();
        let angle = (corner_r / between).asin(); // from the axis to the tangent point
        Self::connected([
            arc((0.0, top - face), face, FRAC_PI_2, -angle),
            arc((corner_r, corner_z), nose, FRAC_PI_2 - angle, angle - FRAC_PI_2),
            line((radius, corner_z), (radius, corner_z - REACH * radius)),
        ])
    }

    /// Die with a throat of `throat` radius (plane strain: half-width) and a `shoulder` radius \[mm\].
    pub fn die(throat: f64, shoulder: f64, sheet_thickness: f64) -> Self {
        let face = 0.5 * sheet_thickness;
        let end = throat + shoulder;
        Self::connected([
            line((end + REACH * end, face), (end, face)),
            arc((end, face + shoulder), shoulder, -FRAC_PI_2, -FRAC_PI_2),
            line((throat, face + shoulder), (throat, face + shoulder + REACH * end)),
        ])
    }

    /// Flat blank holder from `inner` radius \[mm\] outward.
    pub fn holder(inner: f64, sheet_thickness: f64) -> Self {
        let face = -0.5 * sheet_thickness;
        Self::connected([
            line((inner, face - REACH * inner), (inner, face)),
            line((inner, face), (inner + REACH * inner, face)),
        ])
    }
}
