//! The cavity of a die around a punch.

use approx::assert_relative_eq;
use stampflow::geometry::{CavityError, Piece, Point, Profile, Segment};

/// Trust: the standard die, where the cavity has a straight wall.
#[test]
fn a_wall_and_a_shoulder_are_the_standard_die() {
    let cavity = Profile::flat_punch(31.25, 7.0, 1.0).shifted(25.5);
    let die = cavity.cavity(0.5, 6.0, 500.0).unwrap();
    let standard = Profile::die(31.25, 6.0, 1.0);
    for i in 0..100 {
        let x = Point::new(25.0 + 0.3 * f64::from(i), 10.0 - 0.1 * f64::from(i));
        assert_relative_eq!(die.closest(x).distance, standard.closest(x).distance, epsilon = 1e-9);
    }
    // Its bottom: 25 mm above the face.
    assert_relative_eq!(die.closest(Point::new(0.0, 5.0)).distance, 20.5 - 0.5, epsilon = 1e-9);
    assert_eq!(die.fold(), None);
    assert!(die.vertices().all(|v| v.turn.abs() < 1e-9));
}

/// Trust: a shallow bowl is left on its arc: the shoulder touches the sphere from outside.
#[test]
fn a_shoulder_may_run_into_an_arc() {
    let bowl = Profile::hemispherical_punch(50.0, 0.0).shifted(20.0);
    let die = bowl.cavity(0.0, 8.0, 500.0).unwrap();
    let corner = die.corners().next().unwrap();
    assert_relative_eq!((corner.center - Point::new(0.0, -30.0)).norm(), 58.0, epsilon = 1e-9);
    assert_relative_eq!(corner.center.y, 8.0, epsilon = 1e-9);
    assert!(die.vertices().all(|v| v.turn.abs() < 1e-9));
}

#[test]
fn lines_that_are_no_cavity_are_refused() {
    let short = Profile::new(vec![Piece::Segment(Segment::new(Point::new(0.0, 9.0), Point::new(20.0, 2.0)))]).unwrap();
    assert_eq!(short.cavity(0.5, 6.0, 500.0), Err(CavityError::Above { above: 1.5 }));
    assert_eq!(short.cavity(10.0, 6.0, 500.0), Err(CavityError::Below { below: 1.0 }));
    assert!(matches!(short.cavity(4.0, 200.0, 500.0), Err(CavityError::Shoulder { .. })));
}
