//! Distances from the standard shapes.

use approx::assert_relative_eq;
use stampflow::geometry::{Closest, Point, Profile};

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
            let tangent = Point::new(c.normal.y, -c.normal.x);
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
