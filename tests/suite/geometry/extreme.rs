//! The highest and lowest place of a section.

use approx::assert_relative_eq;
use stampflow::geometry::{Piece, Point, Profile, Segment};

/// Trust: dense sampling finds nothing beyond the extreme, and comes near it (1e-4 mm: chords of 1e-3 rad on
/// radii up to 330 mm).
#[test]
fn no_sampled_point_lies_beyond() {
    let tilted = Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8).shifted(4.0);
    for profile in [tilted.clone(), tilted.mirrored(), Profile::die(51.25, 7.0, 1.0), Profile::holder(60.0, 1.0)] {
        for within in [70.0, 325.0, 400.0] {
            for (highest, sign) in [(true, 1.0), (false, -1.0)] {
                let sampled = profile.pieces().iter().flat_map(|p| p.sample(20_000)).filter(|p| p.x <= within);
                let brute = sampled.map(|p| sign * p.y).fold(f64::NEG_INFINITY, f64::max);
                let found = sign * profile.extreme(highest, within).unwrap().y;
                assert!(found >= brute - 1e-9, "{found} {brute}");
                // A long wall that is cut by `within` is sampled every 0.7 mm only; all of them are vertical or flat.
                assert_relative_eq!(found, brute, epsilon = 0.02);
            }
        }
    }
}

#[test]
fn a_slope_is_cut_at_the_edge_of_the_sheet() {
    let slope = Profile::new(vec![Piece::Segment(Segment::new(Point::new(100.0, 0.0), Point::new(20.0, 40.0)))]);
    let slope = slope.unwrap();
    assert_relative_eq!(slope.extreme(false, 60.0).unwrap(), Point::new(60.0, 20.0), epsilon = 1e-9);
    assert_eq!(slope.extreme(false, 10.0), None);
}
