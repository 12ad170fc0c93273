//! Offsets of sections.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stampflow::geometry::{OffsetError, Piece, Point, Profile, Segment, fillet};

fn lines(list: &[[f64; 2]]) -> Profile {
    let segments = list.windows(2).map(|w| Segment::new(Point::new(w[0][0], w[0][1]), Point::new(w[1][0], w[1][1])));
    Profile::new(segments.map(Piece::Segment).collect()).unwrap()
}

/// Every point of the offset has the distance `by` from the profile (1e-7 mm: tangents agree to 1e-9 only, seen
/// over lengths up to 1e2).
fn assert_distance(profile: &Profile, by: f64) {
    let offset = profile.offset(by).unwrap();
    for p in offset.polyline(0.05) {
        assert_relative_eq!(profile.closest(p).distance, by, epsilon = 1e-7);
    }
}

/// Trust: the standard shapes know their own offsets.
#[test]
fn the_offset_of_a_punch_is_a_larger_punch() {
    let offset = Profile::flat_punch(50.0, 9.0, 1.0).offset(1.2).unwrap();
    let larger = Profile::flat_punch(51.2, 10.2, 1.0).shifted(1.2);
    for i in 0..200 {
        let x = Point::new(0.3 * f64::from(i), 4.0 - 0.1 * f64::from(i));
        assert_relative_eq!(offset.closest(x).distance, larger.closest(x).distance, epsilon = 1e-9);
    }
    assert_distance(&Profile::hemispherical_punch(25.0, 1.0), 2.0);
    assert_distance(&Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8), 1.0);
    assert_distance(&Profile::holder(60.0, 1.0), 1.5);
    assert_distance(&Profile::die(51.0, 7.0, 1.0), 1.5);
}

/// Trust: around a tip on the axis the offset is an arc of radius `by`, its top above the tip.
#[test]
fn a_tip_on_the_axis_is_a_corner() {
    let cone = lines(&[[0.0, 0.0], [10.0, -10.0], [10.0, -40.0]]);
    let offset = cone.offset(2.0).unwrap();
    assert_relative_eq!(offset.first(), Point::new(0.0, 2.0), epsilon = 1e-12);
    assert_distance(&cone, 2.0);
    let dish = lines(&[[0.0, -10.0], [10.0, 0.0]]);
    assert!(matches!(dish.offset(2.0), Err(OffsetError::TooTight { radius: 0.0, .. })));
    let from_outside = cone.mirrored();
    assert_relative_eq!(from_outside.offset(2.0).unwrap().last(), Point::new(0.0, -2.0), epsilon = 1e-12);
}

#[test]
fn narrow_hollows_are_refused_with_their_place() {
    let slot = [[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [13.0, -8.0], [13.0, 0.0], [40.0, 0.0]];
    let points: Vec<Point> = slot.iter().map(|p| Point::new(p[0], p[1])).collect();
    let rounded = Profile::new(fillet(&points, &[0.0, 1.0, 1.0, 1.0, 1.0, 0.0]).unwrap()).unwrap();
    let error = rounded.offset(1.2).unwrap_err();
    assert!(matches!(error, OffsetError::TooTight { radius, .. } if (radius - 1.0).abs() < 1e-9), "{error}");
    assert!((error.at() - Point::new(10.3, -7.7)).norm() < 0.1, "{error}");
    let soft = Profile::new(fillet(&points, &[0.0, 1.0, 1.5, 1.5, 1.0, 0.0]).unwrap()).unwrap();
    assert!(soft.offset(1.2).is_ok());
    let sharp = lines(&slot).offset(1.2).unwrap_err();
    assert!(matches!(sharp, OffsetError::TooTight { radius: 0.0, .. }), "{sharp}");
    // Two hollow bends of 4 mm with walls that come within 3 mm of each other further out.
    let neck = [[0.0, 0.0], [10.0, 0.0], [8.0, -30.0], [30.0, -30.0], [12.5, 0.5], [40.0, 0.5]];
    let points: Vec<Point> = neck.iter().map(|p| Point::new(p[0], p[1])).collect();
    let bottle = Profile::new(fillet(&points, &[0.0, 0.1, 4.0, 4.0, 0.1, 0.0]).unwrap()).unwrap();
    assert!(matches!(bottle.offset(2.0), Err(OffsetError::Crosses { .. })), "{:?}", bottle.offset(2.0));
}

proptest! {
    /// Trust: the definition. Any smooth chain that has an offset has it at the distance `by` everywhere, and the
    /// offset, turned round, has the profile at that distance.
    #[test]
    fn random_chains_have_their_offset_at_its_distance(
        steps in prop::collection::vec((12.0..30.0_f64, -1.2..0.9_f64), 2..6),
        by in 0.2..2.5_f64,
    ) {
        let (mut here, mut heading) = (Point::new(0.0, 0.0), 0.0_f64);
        let mut points = vec![here];
        for (length, turn) in steps {
            here += length * Point::new(heading.cos(), heading.sin());
            points.push(here);
            heading += turn;
        }
        let profile = Profile::new(fillet(&points, &vec![3.0; points.len()]).unwrap()).unwrap();
        let Ok(offset) = profile.offset(by) else { return Ok(()) };
        for p in offset.polyline(0.1) {
            prop_assert!((profile.closest(p).distance - by).abs() < 1e-7, "{p:?}");
        }
        for p in profile.polyline(0.1) {
            prop_assert!((offset.reversed().closest(p).distance - by).abs() < 1e-7, "{p:?}");
        }
    }
}
