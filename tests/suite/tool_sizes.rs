//! Sizes read off the section of a tool.

use crate::common::prelude::*;
use crate::drawings::line;
use stampflow::model::tool_sizes::{mouth, widens};

fn punch(pieces: Vec<Piece>) -> Tool {
    let profile = Profile::new(pieces).unwrap();
    Tool { role: Role::Punch, profile, friction: 0.0.into(), motion: Motion::Fixed }
}

/// Trust: by hand. A cone of 20 mm and 0.4 mm more per mm of depth, up to its wall; straight walls, however little of the
/// rounding before them has passed; a face that is hollow about the axis by more than the travel has the mouth of its rim.
#[test]
fn the_mouth_of_a_punch_is_where_it_is_widest_at_the_dies_face() {
    let chain = |points: &[[f64; 2]]| points.windows(2).map(|pair| line(pair[0], pair[1])).collect::<Vec<_>>();
    let cone = punch(chain(&[[0.0, 5.0], [20.0, 5.0], [32.0, -25.0], [32.0, -90.0]]));
    let nose = Piece::Arc(Arc::new([24.0, -6.0].into(), 6.0, FRAC_PI_2, -FRAC_PI_2));
    let flat = punch(vec![line([0.0, 0.0], [24.0, 0.0]), nose, line([30.0, -6.0], [30.0, -80.0])]);
    let dome = Piece::Arc(Arc::new([0.0, -30.0].into(), 30.0, FRAC_PI_2, -FRAC_PI_2));
    let dome = punch(vec![dome, line([30.0, -30.0], [30.0, -80.0])]);
    let hollow = punch(chain(&[[0.0, -20.0], [10.0, -20.0], [15.0, 0.0], [25.0, 0.0], [45.0, -40.0]]));
    for (punch, depth, radius, is_widening) in [
        (&cone, 0.0, 20.0, true),
        (&cone, 10.0, 24.0, true),
        (&cone, 25.0, 30.0, true),
        (&cone, 30.0, 32.0, false),
        (&cone, 60.0, 32.0, false),
        (&flat, 0.0, 30.0, false),
        (&flat, 6.0, 30.0, false),
        (&dome, 1.0, 30.0, false),
        (&dome, 200.0, 30.0, false),
        (&hollow, 10.0, 30.0, true),
    ] {
        assert_relative_eq!(mouth(punch, depth), radius, epsilon = 1e-9);
        assert_eq!(widens(punch, depth), is_widening, "{depth} {radius}");
    }
}
