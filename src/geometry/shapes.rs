//! Standard tool shapes, placed so that they touch a flat sheet of thickness t whose mid-surface is z = 0:
//! punch and holder below (their faces at z = −t/2), the die above (its face at z = +t/2).

use super::{Arc, Piece, Point, Profile, Segment};
use std::f64::consts::FRAC_PI_2;

/// Straight walls go on for this multiple of the tool's largest radius [–]: past any travel that makes sense.
const REACH: f64 = 20.0;

fn line(from: (f64, f64), to: (f64, f64)) -> Piece {
    Piece::Segment(Segment::new(Point::new(from.0, from.1), Point::new(to.0, to.1)))
}

fn arc(center: (f64, f64), radius: f64, start: f64, sweep: f64) -> Piece {
    Piece::Arc(Arc::new(Point::new(center.0, center.1), radius, start, sweep))
}

fn chain(pieces: Vec<Piece>) -> Profile {
    Profile::new(pieces).expect("standard shapes are connected")
}

impl Profile {
    /// Punch with a spherical (plane strain: cylindrical) nose of `radius` \[mm\] and a straight wall.
    pub fn hemispherical_punch(radius: f64, sheet_thickness: f64) -> Self {
        let top = -0.5 * sheet_thickness;
        chain(vec![
            arc((0.0, top - radius), radius, FRAC_PI_2, -FRAC_PI_2),
            line((radius, top - radius), (radius, top - radius - REACH * radius)),
        ])
    }

    /// Flat punch of `radius` (plane strain: half-width) with a corner of `nose` radius \[mm\].
    pub fn flat_punch(radius: f64, nose: f64, sheet_thickness: f64) -> Self {
        let top = -0.5 * sheet_thickness;
        let flat = radius - nose;
        let mut pieces = Vec::new();
        if flat > 1e-9 * radius {
            pieces.push(line((0.0, top), (flat, top)));
        }
        pieces.push(arc((flat, top - nose), nose, FRAC_PI_2, -FRAC_PI_2));
        pieces.push(line((radius, top - nose), (radius, top - nose - REACH * radius)));
        chain(pieces)
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
        chain(vec![
            arc((0.0, top - face), face, FRAC_PI_2, -angle),
            arc((corner_r, corner_z), nose, FRAC_PI_2 - angle, angle - FRAC_PI_2),
            line((radius, corner_z), (radius, corner_z - REACH * radius)),
        ])
    }

    /// Die with a throat of `throat` radius (plane strain: half-width) and a `shoulder` radius \[mm\].
    pub fn die(throat: f64, shoulder: f64, sheet_thickness: f64) -> Self {
        let face = 0.5 * sheet_thickness;
        let end = throat + shoulder;
        chain(vec![
            line((end + REACH * end, face), (end, face)),
            arc((end, face + shoulder), shoulder, -FRAC_PI_2, -FRAC_PI_2),
            line((throat, face + shoulder), (throat, face + shoulder + REACH * end)),
        ])
    }

    /// Flat blank holder from `inner` radius \[mm\] outward.
    pub fn holder(inner: f64, sheet_thickness: f64) -> Self {
        let face = -0.5 * sheet_thickness;
        chain(vec![
            line((inner, face - REACH * inner), (inner, face)),
            line((inner, face), (inner + REACH * inner, face)),
        ])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Closest;
    use approx::assert_relative_eq;

    fn all() -> Vec<Profile> {
        vec![
            Profile::hemispherical_punch(25.4, 0.9),
            Profile::flat_punch(50.0, 9.0, 1.0),
            Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8),
            Profile::die(51.25, 7.0, 1.0),
            Profile::holder(58.25, 1.0),
            Profile::flat_punch(50.0, 9.0, 1.0).faceted(7),
            Profile::die(51.25, 7.0, 1.0).faceted(20),
        ]
    }

    /// Trust: brute force. No sampled point of the chain may be closer than the closest point, and one must be
    /// as close to within the sampling.
    #[test]
    fn distance_agrees_with_brute_force_sampling() {
        for profile in all() {
            let dense: Vec<Point> = profile.pieces().iter().flat_map(|p| p.sample(20_000)).collect();
            for i in 0..60 {
                let x = Point::new(((i * 37) % 60) as f64 * 1.3, ((i * 17) % 23) as f64 * 1.9 - 20.0);
                let closest = profile.closest(x);
                let brute = dense.iter().map(|p| (p - x).norm()).fold(f64::INFINITY, f64::min);
                assert!(closest.distance.abs() <= brute + 1e-9);
                // Sampling error: half a spacing (0.03 mm on the longest wall) squared over twice the distance.
                assert!(brute - closest.distance.abs() < 0.3, "{brute} {}", closest.distance);
            }
        }
    }

    /// Trust: the normal is the gradient and the curvature the second derivative of the distance, by
    /// central differences (h = 1e-4 mm: truncation near 1e-9).
    #[test]
    fn normal_and_curvature_are_derivatives_of_the_distance() {
        let h = 1e-4;
        for profile in all() {
            for i in 0..80 {
                let x = Point::new(0.7 + i as f64 * 0.83, ((i * 7) % 11) as f64 * 0.31 - 1.1);
                let c = profile.closest(x);
                let near: Vec<Closest> = [(h, 0.0), (-h, 0.0), (0.0, h), (0.0, -h)]
                    .iter()
                    .map(|d| profile.closest(x + Point::new(d.0, d.1)))
                    .collect();
                if near.iter().any(|n| (n.normal - c.normal).norm() > 0.01 || n.piece != c.piece) {
                    continue; // a kink of the distance field (medial axis) has no derivative
                }
                let gradient =
                    Point::new(near[0].distance - near[1].distance, near[2].distance - near[3].distance) / (2.0 * h);
                assert_relative_eq!(gradient, c.normal, epsilon = 1e-6);
                let tangent = -super::super::turned(c.normal);
                let (a, b) = (profile.closest(x + h * tangent), profile.closest(x - h * tangent));
                if a.piece == c.piece && b.piece == c.piece {
                    let dn = (a.normal - b.normal) / (2.0 * h);
                    assert_relative_eq!(dn, c.curvature * tangent, epsilon = 1e-5);
                }
            }
        }
    }

    #[test]
    fn shapes_touch_the_flat_sheet_and_point_at_it() {
        let t = 1.0;
        for (profile, r, below) in [
            (Profile::hemispherical_punch(25.0, t), 0.0, true),
            (Profile::flat_punch(50.0, 5.0, t), 10.0, true),
            (Profile::crowned_punch(330.0, 2800.0, 10.0, t), 0.0, true),
            (Profile::holder(60.0, t), 80.0, true),
            (Profile::die(51.0, 7.0, t), 80.0, false),
        ] {
            let c = profile.closest(Point::new(r, 0.0));
            assert_relative_eq!(c.distance, 0.5 * t, epsilon = 1e-9);
            assert_relative_eq!(c.normal.y, if below { 1.0 } else { -1.0 }, epsilon = 1e-9);
        }
    }
}
