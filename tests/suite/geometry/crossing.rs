//! Where pieces of a section meet, and where a section folds.

use proptest::prelude::*;
use stampflow::geometry::{Arc, Fold, Piece, Point, Profile, Segment};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

fn line(x: [f64; 4]) -> Piece {
    Piece::Segment(Segment::new(Point::new(x[0], x[1]), Point::new(x[2], x[3])))
}

fn arc(center: [f64; 2], radius: f64, start: f64, sweep: f64) -> Piece {
    Piece::Arc(Arc::new(Point::new(center[0], center[1]), radius, start, sweep))
}

fn chain(points: &[[f64; 2]]) -> Profile {
    let lines = points.windows(2).map(|w| line([w[0][0], w[0][1], w[1][0], w[1][1]]));
    Profile::new(lines.collect()).unwrap()
}

#[test]
fn folds_are_found_with_their_place() {
    let loops = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 5.0], [5.0, -5.0]]);
    assert_eq!(loops.fold(), Some(Fold::Crossing { at: Point::new(5.0, 0.0), pieces: [0, 3] }));
    let touches = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 0.0], [5.0, 9.0]]);
    assert!(matches!(touches.fold(), Some(Fold::Crossing { pieces: [0, 2], .. })));
    let spur = chain(&[[0.0, 0.0], [10.0, 0.0], [4.0, 0.1], [4.0, -9.0]]);
    assert!(matches!(spur.fold(), Some(Fold::Back { after: 0, .. })));
    let narrow = chain(&[[0.0, 0.0], [10.0, 0.0], [4.0, 1.0], [4.0, 9.0]]);
    assert_eq!(narrow.fold(), None);
}

/// Trust: by hand. The circle about (8, 1) through (9, 0) comes down again at (7, 0), after three quarters.
#[test]
fn an_arc_that_swings_round_through_its_neighbour_is_found() {
    let with_sweep = |sweep: f64| {
        let round = arc([8.0, 1.0], 2.0_f64.sqrt(), -FRAC_PI_4, sweep);
        Profile::new(vec![line([0.0, 0.0, 9.0, 0.0]), round]).unwrap().fold()
    };
    assert_eq!(with_sweep(3.0 * FRAC_PI_2 - 0.1), None);
    let Some(Fold::Crossing { at, pieces: [0, 1] }) = with_sweep(3.0 * FRAC_PI_2 + 0.1) else {
        panic!("the crossing is missed");
    };
    assert!((at - Point::new(7.0, 0.0)).norm() < 1e-9);
}

/// A million million pairs of pieces would take hours.
#[test]
fn a_long_chain_is_gone_through_piece_by_piece() {
    let at = |i: u32, n: u32| f64::from(i) * f64::from(n).recip();
    let wave = |n: u32| (0..=n).map(move |i| [100.0 * at(i, n), (40.0 * at(i, n)).sin()]);
    let points: Vec<[f64; 2]> = wave(1_000_000).collect();
    assert_eq!(chain(&points).fold(), None);
    // A wall is gone through along its height.
    let wall: Vec<[f64; 2]> = points.iter().map(|[x, y]| [*y, *x]).collect();
    assert_eq!(chain(&wall).fold(), None);
    let back = [[100.0, 8.0], [50.0, 8.0], [50.000_05, -8.0]];
    let crossing: Vec<[f64; 2]> = points.into_iter().chain(back).collect();
    assert!(matches!(chain(&crossing).fold(), Some(Fold::Crossing { pieces: [500_000, 1_000_002], .. })));
}

#[test]
fn standard_shapes_do_not_fold() {
    for profile in [
        Profile::hemispherical_punch(25.4, 0.9),
        Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8),
        Profile::die(51.25, 7.0, 1.0),
        Profile::holder(58.25, 1.0),
        Profile::die(51.25, 7.0, 1.0).faceted(45).rounded(),
    ] {
        assert_eq!(profile.fold(), None);
    }
}

proptest! {
    /// Trust: brute force. Polylines cross where the signs of four areas say so.
    #[test]
    fn crossing_chains_are_those_of_the_orientation_test(
        points in prop::collection::vec((0.0..50.0_f64, -20.0..20.0_f64), 3..9),
    ) {
        let points: Vec<[f64; 2]> = points.iter().map(|p| [p.0, p.1]).collect();
        let area = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let lines: Vec<_> = points.windows(2).collect();
        let crosses = (0..lines.len()).any(|i| (i + 2..lines.len()).any(|j| {
            let (a, b, c, d) = (lines[i][0], lines[i][1], lines[j][0], lines[j][1]);
            area(a, b, c) * area(a, b, d) < 0.0 && area(c, d, a) * area(c, d, b) < 0.0
        }));
        let fold = chain(&points).fold();
        prop_assume!(!matches!(fold, Some(Fold::Back { .. })));
        prop_assert_eq!(fold.is_some(), crosses);
    }
}
