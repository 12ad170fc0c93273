//! Sizes read off the section of a tool.

use approx::assert_relative_eq;
use stampflow::geometry::{Arc, Piece, Profile, Segment};
use stampflow::model::tool_sizes::{mouth, widens};
use stampflow::model::{Motion, Role, Tool};
use std::f64::consts::FRAC_PI_2;

fn punch(pieces: Vec<Piece>) -> Tool {
    let profile = Profile::new(pieces).unwrap();
    Tool { role: Role::Punch, profile, friction: 0.0.into(), motion: Motion::Fixed }
}

fn line(from: [f64; 2], to: [f64; 2]) -> Piece {
    Piece::Segment(Segment::new(from.into(), to.into()))
}

/// Trust: by hand: 20 mm and 0.4 mm more per mm of depth, up to the straight wall at 32 mm.
#[test]
fn the_mouth_of_a_cone_grows_with_the_travel() {
    let cone = punch(vec![
        line([0.0, 5.0], [20.0, 5.0]),
        line([20.0, 5.0], [32.0, -25.0]),
        line([32.0, -25.0], [32.0, -90.0]),
    ]);
    for (depth, radius) in [(0.0, 20.0), (10.0, 24.0), (25.0, 30.0), (30.0, 32.0), (60.0, 32.0)] {
        assert_relative_eq!(mouth(&cone, depth), radius, epsilon = 1e-9);
        assert_eq!(widens(&cone, depth), radius < 32.0, "{depth}");
    }
}

/// Trust: a wall of 30 mm, however little of the rounding before it has passed.
#[test]
fn a_straight_wall_is_the_mouth_from_the_start() {
    let nose = Piece::Arc(Arc::new([24.0, -6.0].into(), 6.0, FRAC_PI_2, -FRAC_PI_2));
    let dome = Piece::Arc(Arc::new([0.0, -30.0].into(), 30.0, FRAC_PI_2, -FRAC_PI_2));
    let wall = |z: f64| line([30.0, z], [30.0, -80.0]);
    for punch in [punch(vec![line([0.0, 0.0], [24.0, 0.0]), nose, wall(-6.0)]), punch(vec![dome, wall(-30.0)])] {
        for depth in [0.0, 1.0, 6.0, 20.0, 200.0] {
            assert_relative_eq!(mouth(&punch, depth), 30.0, epsilon = 1e-9);
            assert!(!widens(&punch, depth));
        }
    }
}

/// Trust: a face that is hollow about the axis by more than the travel has the mouth of its rim.
#[test]
fn a_hollow_face_has_its_rims_mouth() {
    let hollow = punch(vec![
        line([0.0, -20.0], [10.0, -20.0]),
        line([10.0, -20.0], [15.0, 0.0]),
        line([15.0, 0.0], [25.0, 0.0]),
        line([25.0, 0.0], [45.0, -40.0]),
    ]);
    assert_relative_eq!(mouth(&hollow, 10.0), 30.0, epsilon = 1e-9);
}
