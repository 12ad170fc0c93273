//! Sections of tools: distances, corners, offsets, and where they meet.

use crate::common::prelude::*;
use proptest::prelude::*;
use stampflow::geometry::{CavityError, Fold, Nearest, OffsetError, fillet};

/// Chords in place of arcs, so many in 90°.
fn chords(profile: &Profile, per_quarter: f64) -> Profile {
    chain(&profile.polyline(FRAC_PI_2 / per_quarter).into_iter().map(Into::into).collect::<Vec<_>>())
}

fn all() -> Vec<Profile> {
    vec![
        Profile::hemispherical_punch(25.4, 0.9),
        Profile::flat_punch(50.0, 9.0, 1.0),
        Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8),
        Profile::die(51.25, 7.0, 1.0),
        Profile::holder(58.25, 1.0),
        chords(&Profile::flat_punch(50.0, 9.0, 1.0), 7.0),
        chords(&Profile::die(51.25, 7.0, 1.0), 20.0),
    ]
}

/// Trust: brute force: no sampled point is closer than the closest point, and one is as close.
#[test]
fn distance_agrees_with_brute_force_sampling() {
    for profile in all() {
        let dense: Vec<Point> = profile.pieces().iter().flat_map(|p| p.sample(20_000)).collect();
        for i in 0..60 {
            let x = Point::new(((i * 37) % 60) as f64 * 1.3, ((i * 17) % 23) as f64 * 1.9 - 20.0);
            let closest = profile.closest(x);
            let brute = dense.iter().map(|p| (p - x).norm()).fold(f64::INFINITY, f64::min);
            assert!(closest.distance.abs() <= brute + 1e-9);
            // Sampling error: half a spacing (0.03 mm on the longest wall) squared over twice the distance.
            assert!(brute - closest.distance.abs() < 0.3, "{brute} {}", closest.distance);
        }
    }
}

/// Trust: normal and curvature are the distance's derivatives, by central differences of 1e-4 mm (error 1e-9).
#[test]
fn normal_and_curvature_are_derivatives_of_the_distance() {
    let h = 1e-4;
    for profile in all() {
        for i in 0..80 {
            let x = Point::new(0.7 + i as f64 * 0.83, ((i * 7) % 11) as f64 * 0.31 - 1.1);
            let c = profile.closest(x);
            let near = [(h, 0.0), (-h, 0.0), (0.0, h), (0.0, -h)].map(|d| profile.closest(x + Point::new(d.0, d.1)));
            if near.iter().any(|n| (n.normal - c.normal).norm() > 0.01 || n.piece != c.piece) {
                continue; // a kink of the distance field (medial axis) has no derivative
            }
            let gradient =
                Point::new(near[0].distance - near[1].distance, near[2].distance - near[3].distance) / (2.0 * h);
            assert_relative_eq!(gradient, c.normal, epsilon = 1e-6);
            let tangent = Point::new(c.normal.y, -c.normal.x);
            let (a, b) = (profile.closest(x + h * tangent), profile.closest(x - h * tangent));
            if a.piece == c.piece && b.piece == c.piece {
                assert_relative_eq!((a.normal - b.normal) / (2.0 * h), c.curvature * tangent, epsilon = 1e-5);
            }
        }
    }
}

#[test]
fn shapes_touch_the_flat_sheet_and_point_at_it() {
    let t = 1.0;
    for (profile, r, below) in [
        (Profile::hemispherical_punch(25.0, t), 0.0, true),
        (Profile::flat_punch(50.0, 5.0, t), 10.0, true),
        (Profile::crowned_punch(330.0, 2800.0, 10.0, t), 0.0, true),
        (Profile::holder(60.0, t), 80.0, true),
        (Profile::die(51.0, 7.0, t), 80.0, false),
    ] {
        let c = profile.closest(Point::new(r, 0.0));
        assert_relative_eq!(c.distance, 0.5 * t, epsilon = 1e-9);
        assert_relative_eq!(c.normal.y, if below { 1.0 } else { -1.0 }, epsilon = 1e-9);
    }
}

/// Trust: a mirror keeps distances, turning round changes their sign (1e-9: rounded sums up to 1e3).
#[test]
fn distances_follow_the_moves() {
    for profile in [Profile::flat_punch(50.0, 9.0, 1.0), Profile::die(51.0, 7.0, 1.0), Profile::holder(60.0, 1.0)] {
        for i in 0..200 {
            let x = Point::new(f64::from(i) * 0.4, f64::from((i * 7) % 31) - 15.3);
            let d = profile.closest(x).distance;
            assert!((profile.mirrored().closest(Point::new(x.x, -x.y)).distance - d).abs() < 1e-9);
            assert!((profile.reversed().closest(x).distance + d).abs() < 1e-9);
            let across = Profile::new(profile.pieces().iter().map(Piece::across_axis).collect()).unwrap().reversed();
            assert!((across.closest(Point::new(-x.x, x.y)).distance - d).abs() < 1e-9);
            assert!((profile.shifted(3.0).closest(x + Point::new(0.0, 3.0)).distance - d).abs() < 1e-9);
        }
    }
}

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

/// Trust: dense sampling finds nothing beyond the extreme, and comes within 1e-4 mm: chords of 1e-3 rad.
#[test]
fn no_sampled_point_lies_beyond() {
    let tilted = Profile::crowned_punch(330.0, 2800.0, 10.0, 0.8).shifted(4.0);
    for profile in [tilted.clone(), tilted.mirrored(), Profile::die(51.25, 7.0, 1.0), Profile::holder(60.0, 1.0)] {
        for within in [70.0, 325.0, 400.0] {
            for (highest, sign) in [(true, 1.0), (false, -1.0)] {
                let sampled = profile.pieces().iter().flat_map(|p| p.sample(20_000)).filter(|p| p.x <= within);
                let brute = sampled.map(|p| sign * p.y).fold(f64::NEG_INFINITY, f64::max);
                let found = sign * profile.extreme(highest, [0.0, within]).unwrap().y;
                assert!(found >= brute - 1e-9, "{found} {brute}");
                // A long wall that is cut by `within` is sampled every 0.7 mm only; all of them are vertical or flat.
                assert_relative_eq!(found, brute, epsilon = 0.02);
            }
        }
    }
}

#[test]
fn a_slope_is_cut_at_the_edge_of_the_sheet() {
    let slope = chain(&[[100.0, 0.0], [20.0, 40.0]]);
    assert_relative_eq!(slope.extreme(false, [0.0, 60.0]).unwrap(), Point::new(60.0, 20.0), epsilon = 1e-9);
    assert_eq!(slope.extreme(false, [0.0, 10.0]), None);
}

fn chain(points: &[[f64; 2]]) -> Profile {
    Profile::new(points.windows(2).map(|ends| Piece::line(ends[0].into(), ends[1].into())).collect()).unwrap()
}

#[test]
fn folds_are_found_with_their_place() {
    let loops = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 5.0], [5.0, -5.0]]);
    assert_eq!(loops.fold(), Some(Fold::Crossing { at: Point::new(5.0, 0.0), pieces: [0, 3] }));
    let touches = chain(&[[0.0, 0.0], [10.0, 0.0], [10.0, 5.0], [5.0, 0.0], [5.0, 9.0]]);
    assert!(matches!(touches.fold(), Some(Fold::Crossing { pieces: [0, 2], .. })));
    let spur = chain(&[[0.0, 0.0], [10.0, 0.0], [4.0, 0.1], [4.0, -9.0]]);
    assert!(matches!(spur.fold(), Some(Fold::Back { after: 0, .. })));
    assert_eq!(chain(&[[0.0, 0.0], [10.0, 0.0], [4.0, 1.0], [4.0, 9.0]]).fold(), None);
}

/// Trust: by hand. The circle about (8, 1) through (9, 0) comes down again at (7, 0), after three quarters.
#[test]
fn an_arc_that_swings_round_through_its_neighbour_is_found() {
    let with_sweep = |sweep: f64| {
        let round = Piece::arc(Point::new(8.0, 1.0), 2.0_f64.sqrt(), -FRAC_PI_4, sweep);
        Profile::new(vec![Piece::line(Point::zeros(), Point::new(9.0, 0.0)), round]).unwrap().fold()
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
    let crossing: Vec<[f64; 2]> = points.into_iter().chain([[100.0, 8.0], [50.0, 8.0], [50.000_05, -8.0]]).collect();
    assert!(matches!(chain(&crossing).fold(), Some(Fold::Crossing { pieces: [500_000, 1_000_002], .. })));
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

fn falling(x: f64, y: f64) -> impl Iterator<Item = Point> {
    (0..200).map(f64::from).map(move |i| Point::new(x + 0.3 * i, y - 0.1 * i))
}

fn points(list: &[[f64; 2]]) -> Vec<Point> {
    list.iter().map(|p| Point::from(*p)).collect()
}

/// Trust: by hand. A right angle takes its radius from each side.
#[test]
fn the_largest_radius_is_named_and_fits() {
    let step = points(&[[0.0, 0.0], [10.0, 0.0], [10.0, -6.0], [30.0, -6.0]]);
    let refused = |radii: [f64; 2]| fillet(&step, &[0.0, radii[0], radii[1], 0.0]).unwrap_err();
    for (radii, vertex, largest) in [([4.0, 4.0], 1, 3.0), ([1.0, 8.0], 2, 5.0)] {
        assert_eq!(refused(radii).vertex, vertex);
        assert_relative_eq!(refused(radii).largest, largest, epsilon = 1e-12);
    }
    let error = refused([1.0, 8.0]);
    assert!(fillet(&step, &[0.0, 1.0, error.largest, 0.0]).is_ok());
    assert!(error.to_string().contains("r = 10.0000 mm, z = -6.0000 mm: at most 5.0000 mm"), "{error}");
}

/// Corners of a chain from the origin: each piece's length, and the turn after it.
fn chain_of(steps: &[(f64, f64)]) -> Vec<Point> {
    let (mut here, mut heading) = (Point::new(0.0, 0.0), 0.0_f64);
    let mut corners = vec![here];
    for (length, turn) in steps {
        here += *length * Point::new(heading.cos(), heading.sin());
        corners.push(here);
        heading += turn;
    }
    corners
}

proptest! {
    /// Trust: the definition. Radii that fit leave no corner: every vertex is smooth (1e-7 rad: the centre is
    /// found to round-off, and its error is seen over the radius), every arc has its radius.
    #[test]
    fn fillets_touch(steps in prop::collection::vec((5.0..20.0_f64, -1.4..1.4_f64), 2..7), share in 0.05..0.95_f64) {
        let chain = chain_of(&steps);
        let largest = match fillet(&chain, &vec![1e9; chain.len()]) {
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

/// Trust: around a tip on the axis the offset is an arc of radius `by`, its top above the tip.
#[test]
fn a_tip_on_the_axis_is_a_corner() {
    let cone = chain(&[[0.0, 0.0], [10.0, -10.0], [10.0, -40.0]]);
    assert_relative_eq!(cone.offset(2.0).unwrap().first(), Point::new(0.0, 2.0), epsilon = 1e-12);
    let dish = chain(&[[0.0, -10.0], [10.0, 0.0]]);
    assert!(matches!(dish.offset(2.0), Err(OffsetError::TooTight { radius: 0.0, .. })));
    assert_relative_eq!(cone.mirrored().offset(2.0).unwrap().last(), Point::new(0.0, -2.0), epsilon = 1e-12);
}

#[test]
fn narrow_hollows_are_refused_with_their_place() {
    let slot = [[0.0, 0.0], [10.0, 0.0], [10.0, -8.0], [13.0, -8.0], [13.0, 0.0], [40.0, 0.0]];
    let rounded = Profile::new(fillet(&points(&slot), &[0.0, 1.0, 1.0, 1.0, 1.0, 0.0]).unwrap()).unwrap();
    let error = rounded.offset(1.2).unwrap_err();
    let OffsetError::TooTight { radius, at } = error else { panic!("{error}") };
    assert!((radius - 1.0).abs() < 1e-9, "{error}");
    assert!((at - Point::new(10.3, -7.7)).norm() < 0.1, "{error}");
    let soft = Profile::new(fillet(&points(&slot), &[0.0, 1.0, 1.5, 1.5, 1.0, 0.0]).unwrap()).unwrap();
    assert!(soft.offset(1.2).is_ok());
    let sharp = chain(&slot).offset(1.2).unwrap_err();
    assert!(matches!(sharp, OffsetError::TooTight { radius: 0.0, .. }), "{sharp}");
    // Two hollow bends of 4 mm with walls that come within 3 mm of each other further out.
    let neck = [[0.0, 0.0], [10.0, 0.0], [8.0, -30.0], [30.0, -30.0], [12.5, 0.5], [40.0, 0.5]];
    let bottle = Profile::new(fillet(&points(&neck), &[0.0, 0.1, 4.0, 4.0, 0.1, 0.0]).unwrap()).unwrap();
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
        let points = chain_of(&steps);
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

/// Trust: the standard die, where the cavity has a straight wall.
#[test]
fn a_wall_and_a_shoulder_are_the_standard_die() {
    let die = Profile::flat_punch(31.25, 7.0, 1.0).shifted(25.5).cavity(0.5, 6.0, 500.0).unwrap();
    assert!(are_alike(&die, &Profile::die(31.25, 6.0, 1.0), 1e-9, falling(25.0, 10.0).take(100)));
    // Its bottom: 25 mm above the face.
    assert_relative_eq!(die.closest(Point::new(0.0, 5.0)).distance, 20.5 - 0.5, epsilon = 1e-9);
    assert_eq!(die.fold(), None);
    assert!(die.vertices().all(|v| v.turn.abs() < 1e-9));
}

/// Trust: a shallow bowl is left on its arc: the shoulder touches the sphere from outside.
#[test]
fn a_shoulder_may_run_into_an_arc() {
    let die = Profile::hemispherical_punch(50.0, 0.0).shifted(20.0).cavity(0.0, 8.0, 500.0).unwrap();
    let corner = die.corners().next().unwrap();
    assert_relative_eq!((corner.center - Point::new(0.0, -30.0)).norm(), 58.0, epsilon = 1e-9);
    assert_relative_eq!(corner.center.y, 8.0, epsilon = 1e-9);
    assert!(die.vertices().all(|v| v.turn.abs() < 1e-9));
}

#[test]
fn lines_that_are_no_cavity_are_refused() {
    let short = chain(&[[0.0, 9.0], [20.0, 2.0]]);
    assert_eq!(short.cavity(0.5, 6.0, 500.0), Err(CavityError::Above(1.5)));
    assert_eq!(short.cavity(10.0, 6.0, 500.0), Err(CavityError::Below(1.0)));
    assert!(matches!(short.cavity(4.0, 200.0, 500.0), Err(CavityError::Shoulder { .. })));
}

/// Trust: rounded chords of a circle lie on it again, to round-off beside a wall longer than four chords.
#[test]
fn chords_of_an_arc_give_the_arc_back() {
    for exact in
        [Profile::flat_punch(50.0, 9.0, 1.0), Profile::die(51.25, 7.0, 1.0), Profile::hemispherical_punch(25.4, 0.9)]
    {
        for n in [8.0, 20.0, 45.0, 90.0] {
            let rounded = chords(&exact, n).rounded();
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
    for chain in [chords(&exact, 20.0), chords(&exact, 20.0).mirrored()] {
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
            (exact.corners().collect(), chords(&exact, 45.0).rounded().corners().collect());
        assert_eq!(found.len(), corners.len());
        for (a, b) in corners.iter().zip(&found) {
            assert!((a.radius / b.radius - 1.0).abs() < 1e-6 && (a.sweep / b.sweep - 1.0).abs() < 1e-6, "{a:?} {b:?}");
        }
    }
}

/// A plate from the axis to r = 10 mm at z = 0, the sheet above, nothing else drawn.
fn plate() -> Profile {
    chain(&[[0.0, 0.0], [10.0, 0.0]])
}

/// Trust: to the bit, along ways of small steps and of jumps past a plate, a nose and a die's shoulder.
#[test]
fn what_is_known_of_a_point_before_it_moved_changes_nothing() {
    let shoulder = Profile::new(vec![
        Piece::line(Point::new(0.0, -9.0), Point::new(0.0, -2.0)),
        Piece::arc(Point::new(2.0, -2.0), 2.0, PI, -FRAC_PI_2),
        Piece::line(Point::new(2.0, 0.0), Point::new(9.0, 0.0)),
    ])
    .expect("a chain");
    for (profile, step) in [plate(), shoulder].iter().flat_map(|p| [1e-3, 0.05, 0.7].map(|step| (p, step))) {
        let (mut known, mut last) = (Nearest::default(), Point::zeros());
        for t in (0..4000).map(|i| step * f64::from(i)) {
            let x = Point::new(4.0 + 6.0 * (0.31 * t).sin(), -1.0 + 4.0 * (0.53 * t).cos());
            assert_eq!(profile.closest_after(x, (x - last).norm(), &mut known), profile.closest(x));
            last = x;
        }
    }
}

/// Trust: by hand, right triangles of 3, 4 and 5.
#[test]
fn what_has_passed_the_end_is_outside_and_what_is_pressed_in_is_inside() {
    for (x, distance, normal) in [
        (Point::new(5.0, 2.0), 2.0, Point::new(0.0, 1.0)),
        (Point::new(5.0, -2.0), -2.0, Point::new(0.0, 1.0)),
        // Beyond the end, above and below the line drawn on.
        (Point::new(13.0, 4.0), 5.0, Point::new(0.6, 0.8)),
        (Point::new(13.0, -4.0), 5.0, Point::new(0.6, -0.8)),
        // Behind the line: nearer round the end than through it, and the other way about.
        (Point::new(7.0, -4.0), 5.0, Point::new(-0.6, -0.8)),
        (Point::new(6.0, -3.0), -3.0, Point::new(0.0, 1.0)),
        // The line meets its mirror image on the axis: that is no end.
        (Point::new(0.0, -2.0), -2.0, Point::new(0.0, 1.0)),
    ] {
        let closest = plate().closest(x);
        assert_relative_eq!(closest.distance, distance, epsilon = 1e-12);
        assert_relative_eq!(closest.normal, normal, epsilon = 1e-12);
    }
}
