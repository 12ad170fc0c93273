//! Sections mirrored, shifted and turned round.

use stampflow::geometry::{Piece, Point, Profile};

/// Trust: a mirror keeps distances, and turning round changes only their sign (1e-9: a few rounded sums of
/// coordinates up to 1e3).
#[test]
fn distances_follow_the_moves() {
    for profile in [Profile::flat_punch(50.0, 9.0, 1.0), Profile::die(51.0, 7.0, 1.0), Profile::holder(60.0, 1.0)] {
        for i in 0..200 {
            let x = Point::new(f64::from(i) * 0.4, f64::from((i * 7) % 31) - 15.3);
            let d = profile.closest(x).distance;
            let image = Point::new(x.x, -x.y);
            assert!((profile.mirrored().closest(image).distance - d).abs() < 1e-9);
            assert!((profile.reversed().closest(x).distance + d).abs() < 1e-9);
            let across = Profile::new(profile.pieces().iter().map(Piece::across_axis).collect()).unwrap().reversed();
            assert!((across.closest(Point::new(-x.x, x.y)).distance - d).abs() < 1e-9);
            assert!((profile.shifted(3.0).closest(x + Point::new(0.0, 3.0)).distance - d).abs() < 1e-9);
        }
    }
}
