//! Rounded corners.

use approx::assert_relative_eq;
use proptest::prelude::*;
use stampflow::geometry::{Point, Profile, fillet};

fn points(list: &[[f64; 2]]) -> Vec<Point> {
    list.iter().map(|p| Point::new(p[0], p[1])).collect()
}

/// Trust: the flat punch is three points and one fillet.
#[test]
fn a_filleted_rectangle_is_the_flat_punch() {
    let exact = Profile::flat_punch(50.0, 9.0, 1.0);
    let bottom = exact.last().y;
    let corner = points(&[[0.0, -0.5], [50.0, -0.5], [50.0, bottom]]);
    let pieces = fillet(&corner, &[0.0, 9.0, 0.0]).unwrap();
    let profile = Profile::new(pieces).unwrap();
    for i in 0..200 {
        let x = Point::new(0.3 * f64::from(i), 4.0 - 0.1 * f64::from(i));
        assert_relative_eq!(profile.closest(x).distance, exact.closest(x).distance, epsilon = 1e-9);
    }
}

/// Trust: by hand. A right angle takes its radius from each side.
#[test]
fn the_largest_radius_is_named_and_fits() {
    let step = points(&[[0.0, 0.0], [10.0, 0.0], [10.0, -6.0], [30.0, -6.0]]);
    let error = fillet(&step, &[0.0, 4.0, 4.0, 0.0]).unwrap_err();
    assert_eq!(error.vertex, 1);
    assert_relative_eq!(error.largest, 3.0, epsilon = 1e-12);
    let error = fillet(&step, &[0.0, 1.0, 8.0, 0.0]).unwrap_err();
    assert_eq!(error.vertex, 2);
    assert_relative_eq!(error.largest, 5.0, epsilon = 1e-12);
    assert!(fillet(&step, &[0.0, 1.0, error.largest, 0.0]).is_ok());
    assert!(error.to_string().contains("r = 10.0000 mm, z = -6.0000 mm: at most 5.0000 mm"), "{error}");
}

proptest! {
    /// Trust: the definition. Radii that fit leave no corner: every vertex is smooth (1e-7 rad: the centre is
    /// found to round-off, and its error is seen over the radius), every arc has its radius.
    #[test]
    fn fillets_are_tangent(
        steps in prop::collection::vec((5.0..20.0_f64, -1.4..1.4_f64), 2..7),
        share in 0.05..0.95_f64,
    ) {
        let (mut here, mut heading) = (Point::new(0.0, 0.0), 0.0_f64);
        let mut chain = vec![here];
        for (length, turn) in steps {
            here += length * Point::new(heading.cos(), heading.sin());
            chain.push(here);
            heading += turn;
        }
        let huge = vec![1e9; chain.len()];
        let largest = match fillet(&chain, &huge) {
            Err(error) => error.largest,
            Ok(_) => return Ok(()), // straight
        };
        // The first failing vertex speaks for its own sides only.
        let mut radius = largest;
        while let Err(error) = fillet(&chain, &vec![radius; chain.len()]) {
            prop_assert!(error.largest < radius);
            radius = error.largest;
        }
        radius *= share;
        prop_assume!(radius > 1e-3);
        let profile = Profile::new(fillet(&chain, &vec![radius; chain.len()]).unwrap()).unwrap();
        for vertex in profile.vertices() {
            prop_assert!(vertex.turn.abs() < 1e-7, "{vertex:?}");
        }
        prop_assert_eq!(profile.first(), chain[0]);
        prop_assert_eq!(profile.last(), chain[chain.len() - 1]);
    }
}
