//! Chords rounded off by tangent arcs.

use stampflow::geometry::{Arc, Point, Profile};

/// Trust: chords of a circle, rounded, lie on the circle again, also next to straight walls: to round-off
/// while the wall is longer than four chords.
#[test]
fn chords_of_an_arc_give_the_arc_back() {
    for exact in
        [Profile::flat_punch(50.0, 9.0, 1.0), Profile::die(51.25, 7.0, 1.0), Profile::hemispherical_punch(25.4, 0.9)]
    {
        for n in [8, 20, 45, 90] {
            let rounded = exact.faceted(n).rounded();
            for i in 0..400 {
                let x = Point::new(30.0 + (i as f64) * 0.08, if i % 2 == 0 { -4.0 } else { 3.0 });
                let (a, b) = (exact.closest(x), rounded.closest(x));
                if a.distance.abs() < 2.0 {
                    assert!((a.distance - b.distance).abs() < 1e-9, "{n} {x:?} {} {}", a.distance, b.distance);
                    assert!((a.normal - b.normal).norm() < 1e-9, "{n} {x:?}");
                }
            }
        }
    }
}

/// Trust: a hemisphere is level on the axis, and its chords give it back there too.
#[test]
fn chords_that_meet_the_axis_are_level_there() {
    let exact = Profile::hemispherical_punch(25.4, 0.9);
    for chain in [exact.faceted(20), exact.faceted(20).mirrored()] {
        let rounded = chain.rounded();
        for i in 0..200 {
            let side = if chain.first().x.abs() < 1e-9 { 1.0 } else { -1.0 };
            let x = Point::new(0.1 * f64::from(i), side * (1.0 - 0.05 * f64::from(i)));
            let image = Point::new(x.x, side * x.y);
            assert!((exact.closest(image).distance - rounded.closest(x).distance).abs() < 1e-9, "{x:?}");
        }
    }
}

/// Trust: the corner that was cut into chords is found as one again (1e-6: the angles of 45 arcs added up).
#[test]
fn a_rounded_corner_is_one_corner() {
    for exact in [Profile::flat_punch(50.0, 9.0, 1.0), Profile::die(51.25, 7.0, 1.0)] {
        let (corners, found): (Vec<Arc>, Vec<Arc>) =
            (exact.corners().collect(), exact.faceted(45).rounded().corners().collect());
        assert_eq!(found.len(), corners.len());
        for (a, b) in corners.iter().zip(&found) {
            assert!((a.radius / b.radius - 1.0).abs() < 1e-6 && (a.sweep / b.sweep - 1.0).abs() < 1e-6, "{a:?} {b:?}");
        }
    }
}

#[test]
fn corners_and_arcs_stay() {
    let die = Profile::die(51.25, 7.0, 1.0);
    assert_eq!(die.rounded(), die);
    let holder = Profile::holder(60.0, 1.0);
    assert_eq!(holder.rounded(), holder);
}
