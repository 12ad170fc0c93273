//! Pieces cut at the axis.

use stampflow::geometry::{Arc, Piece, Point, Segment};
use std::f64::consts::PI;

/// Trust: by hand. Whole lengths are kept, and parts lie on one side each.
#[test]
fn parts_lie_on_one_side_each_and_add_up() {
    let line = Piece::Segment(Segment::new(Point::new(-3.0, 1.0), Point::new(6.0, 4.0)));
    let dome = Piece::Arc(Arc::new(Point::new(0.0, 0.0), 5.0, 0.0, PI));
    let twice = Piece::Arc(Arc::new(Point::new(1.0, 0.0), 2.0, -0.5 * PI, -PI));
    for (piece, parts) in [(line, 2), (dome, 2), (twice, 3)] {
        let cut = piece.cut_at_axis(1e-6);
        assert_eq!(cut.len(), parts, "{cut:?}");
        assert!((cut.iter().map(Piece::length).sum::<f64>() - piece.length()).abs() < 1e-9);
        for pair in cut.windows(2) {
            assert!((pair[0].last() - pair[1].first()).norm() < 1e-9);
            assert!(pair[0].last().x.abs() < 1e-9);
        }
    }
    assert_eq!(line.across_axis().cut_at_axis(4.0).len(), 1, "a crossing that is an end");
}
