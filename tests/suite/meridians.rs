//! Meridians made of known lines and arcs, and profiles of stress whose moment is known.

use crate::common::prelude::*;
use stampflow::measure::moment_error;

/// A piece of a meridian: length \[mm\], turn \[°\], elements, and the last element's length over the first's.
#[derive(Clone, Copy)]
struct Piece {
    length: f64,
    turn: f64,
    elements: usize,
    growth: f64,
}

fn line(length: f64) -> Piece {
    Piece { length, turn: 0.0, elements: 40, growth: 1.0 }
}

fn arc(radius: f64, turn: f64) -> Piece {
    Piece { length: radius * turn.to_radians().abs(), turn, elements: 20, growth: 1.0 }
}

impl Piece {
    fn graded(self, elements: usize, growth: f64) -> Self {
        Self { elements, growth, ..self }
    }
}

/// A sheet of 1 mm whose nodes lie on the pieces exactly; from the pole at `height` \[mm\], level, outward.
fn sheet(height: f64, pieces: &[Piece]) -> Frame {
    let (mut r, mut z, mut slope) = (0.0_f64, height, 0.0_f64);
    let mut points = vec![(r, z)];
    for piece in pieces {
        let turn = piece.turn.to_radians();
        let steps = (0..piece.elements).map(|i| piece.growth.powf(i as f64 / piece.elements as f64));
        let total: f64 = steps.clone().sum();
        let (from_r, from_z) = (r, z);
        let mut done = 0.0;
        for step in steps {
            done += step / total;
            let half = 0.5 * turn * done;
            // A chord over the angle 2 half, at half of it to the tangent.
            let chord = piece.length * done * if half == 0.0 { 1.0 } else { half.sin() / half };
            (r, z) = (from_r + chord * (slope + half).cos(), from_z + chord * (slope + half).sin());
            points.push((r, z));
        }
        slope += turn;
    }
    of_points(&points)
}

fn of_points(points: &[(f64, f64)]) -> Frame {
    let nodes: Vec<NodeRecord> = points.iter().map(|&(r, z)| NodeRecord { r, z, theta: 0.0, thickness: 1.0 }).collect();
    let elements = nodes.windows(2).map(|pair| element(0.5 * (pair[0].r + pair[1].r))).collect();
    let (through, tool_displacement) = (ThroughThickness::default(), vec![]);
    Frame { time: 1.0, travel: 1.0, elements, nodes, through, tool_displacement }
}

fn element(s0: f64) -> ElementRecord {
    ElementRecord { s0, r: s0, z: 0.0, thickness: 1.0, temperature: 293.15, ..ElementRecord::default() }
}

/// The other way up, as of a sheet that is pressed against the direction of travel.
fn turned(frame: &Frame) -> Frame {
    of_points(&frame.nodes.iter().map(|n| (n.r, -n.z)).collect::<Vec<_>>())
}

fn close(found: Option<f64>, exact: f64, within: f64) {
    let found = found.unwrap_or_else(|| panic!("{exact} was not found"));
    assert!((found - exact).abs() < within, "{found} for {exact}");
}

/// A hat: flat bottom, punch radius, straight wall, die radius and flange, opened by `wall` and its flange tilted by
/// `flange` [°], on a mesh graded by `growth`.
fn hat(wall: f64, flange: f64, growth: f64) -> Frame {
    let down = 90.0 - wall;
    let pieces = [line(30.0), arc(5.5, -down), line(40.0), arc(5.5, down + flange), line(35.0)];
    let elements = [12, 9, 31, 9, 23];
    let pieces: Vec<Piece> = pieces.iter().zip(elements).map(|(piece, n)| piece.graded(n, growth)).collect();
    sheet(40.0, &pieces)
}

/// Trust: radii, lengths and faces add up; where the flange is turned back its bend is the far end, not its edge.
#[test]
fn a_parts_height_is_that_over_all() {
    let turned_back = [line(30.0), arc(5.0, -90.0), line(20.0), arc(5.0, 120.0), line(10.0)];
    for (frame, height) in [
        (sheet(40.0, &turned_back[..3]), 5.0 + 20.0 + 0.5),
        (sheet(40.0, &turned_back), 0.5 + 5.0 + 20.0 + 5.0 + 0.5),
        (hat(0.0, 0.0, 1.0), 0.5 + 5.5 + 40.0 + 5.5 + 0.5),
        (sheet(0.0, &[line(30.0)]), 1.0),
    ] {
        for frame in [turned(&frame), frame] {
            close(part_height(&frame), height, 1e-9);
        }
    }
    assert_eq!(part_height(&of_points(&[])), None);
}

#[test]
fn a_hats_angles_are_exact_on_graded_meshes_and_either_way_up() {
    for (wall, flange) in [(0.0, 0.0), (12.5, 7.0), (25.0, -6.0), (-4.0, 3.0), (40.0, 20.0)] {
        for growth in [0.2, 1.0, 3.0] {
            let frame = hat(wall, flange, growth);
            for frame in [turned(&frame), frame] {
                let shape = Shape::of(&frame);
                close(shape.wall_angle(), wall, 1e-6);
                close(shape.opening_angle(), 2.0 * wall, 1e-6);
                close(shape.bottom_to_wall(), 90.0 + wall, 1e-6);
                close(shape.flange_angle(), flange, 1e-6);
                close(shape.wall_to_flange(), 90.0 + wall - flange, 1e-6);
                assert_eq!(shape.curl_radius(), Some(f64::INFINITY));
                close(shape.edge, frame.nodes[frame.nodes.len() - 1].r, 1e-12);
            }
        }
    }
}

/// Closed forms of a circular wall: chord at half the curl, θ₁ and θ₂ from its tangents a tenth inside its ends. Trust: those ends lie half a thickness inside the arc's. Every degree, so that nothing jumps.
#[test]
fn a_walls_measures_are_those_of_its_circle_however_much_it_curls() {
    let outward = (3..=80).map(f64::from);
    for (curl, growth) in outward.map(|curl| (curl, 1.0)).chain([(-40.0, 1.0), (-3.0, 0.5), (35.0, 0.5), (80.0, 2.0)]) {
        let radius = 50.0 / f64::to_radians(curl);
        let wall = arc(radius.abs(), curl).graded(60, growth);
        let frame = sheet(60.0, &[line(30.0), arc(5.5, -75.0), wall, arc(5.5, 78.0), line(50.0)]);
        for frame in [turned(&frame), frame] {
            let shape = Shape::of(&frame);
            let within = 0.02 * curl.abs() + 0.01;
            close(shape.curl_radius(), radius, 1e-3 * radius.abs());
            close(shape.wall_angle(), 15.0 + 0.5 * curl, within);
            close(shape.bottom_to_wall(), 105.0 + 0.1 * curl, within);
            close(shape.wall_to_flange(), 102.0 - 0.1 * curl, within);
            close(shape.flange_angle(), 3.0 + curl, 1e-6);
        }
    }
}

#[test]
fn a_bent_strip_has_a_wall_and_no_flange() {
    for opening in [21.88, 48.4, 90.0, 130.0] {
        let bend = arc(24.0, -(90.0 - 0.5 * opening)).graded(40, 1.0);
        let shape = Shape::of(&sheet(28.5, &[bend, line(27.0).graded(30, 2.0)]));
        close(shape.opening_angle(), opening, 1e-6);
        assert!(shape.flange.is_none() && shape.wall_to_flange().is_none());
        assert_eq!(shape.curl_radius(), Some(f64::INFINITY));
    }
}

#[test]
fn what_has_no_wall_gets_no_number() {
    let dome = sheet(20.0, &[arc(60.0, -45.0).graded(60, 1.0)]);
    let flat = sheet(0.0, &[line(50.0)]);
    let held_dome = sheet(20.0, &[arc(60.0, -45.0).graded(60, 1.0), arc(6.0, 45.0), line(30.0)]);
    let without_leg = sheet(20.0, &[line(30.0), arc(6.0, -80.0), arc(6.0, 80.0), line(30.0)]);
    // Of slowly changing curvature: nowhere straight, though its rim is flatter than its middle.
    let points: Vec<_> = (0..=80).map(|i| 0.5 * f64::from(i)).map(|r| (r, 15.0 - 15.0 * (r / 40.0).powi(2))).collect();
    for frame in [&dome, &flat, &of_points(&points)] {
        let shape = Shape::of(frame);
        assert!(shape.wall.is_none() && shape.wall_angle().is_none() && shape.curl_radius().is_none());
    }
    for frame in [&dome, &flat] {
        assert!(Shape::of(frame).flange.is_none());
    }
    // Bends that meet have the slope of their inflection: half a thickness of 6 mm turns by 4.8°, its chord by half of that.
    for (frame, wall) in [(&held_dome, 45.0), (&without_leg, 10.0)] {
        close(Shape::of(frame).flange_angle(), 0.0, 1e-6);
        close(Shape::of(frame).wall_angle(), wall, 2.4);
    }
}

/// Round-off, contacts that come and go: nodes a thousandth of the thickness beside the lines.
#[test]
fn small_waves_change_little() {
    let mut frame = hat(12.5, 7.0, 1.0);
    for (i, node) in frame.nodes.iter_mut().enumerate() {
        node.r += 1e-3 * (2.1 * i as f64).sin();
        node.z += 1e-3 * (1.7 * i as f64).cos();
    }
    let shape = Shape::of(&frame);
    close(shape.wall_angle(), 12.5, 0.05);
    close(shape.flange_angle(), 7.0, 0.05);
}

#[test]
fn broken_sheets_are_not_measured() {
    for points in [&[][..], &[(0.0, 0.0)], &[(0.0, 0.0), (1.0, 0.0)], &[(1.0, 2.0); 9], &[(f64::NAN, 0.0); 9]] {
        let frame = of_points(points);
        let shape = Shape::of(&frame);
        assert!(shape.wall.is_none() && shape.flange.is_none());
        assert!(moment_error(&frame).is_none());
    }
}

fn section(layers: usize, stress: impl Fn(f64) -> f64) -> Frame {
    let layers = lobatto(layers);
    let point = |xi| PointRecord { stress_meridional: stress(xi), ..PointRecord::default() };
    let points = layers.iter().map(|layer| point(layer.xi)).collect();
    Frame { through: ThroughThickness { layers, points }, ..of_points(&[(10.0, 0.0), (11.0, 0.0)]) }
}

/// Trust: σ = clamp(ξ/c, −1, 1) has the moment ½ ∫ ξ σ dξ = ½ − c²/6. The error depends on where the core's edge c
/// falls between two points, so the root mean square over many c is compared.
#[test]
fn the_moments_error_is_estimated_for_elastic_cores() {
    for n in 5..=51 {
        let cores: Vec<f64> = (1..200).map(|i| 0.1 + 0.004 * f64::from(i)).collect();
        let (mut errors, mut estimates) = (0.0, 0.0);
        for c in &cores {
            let frame = section(n, |xi| (xi / c).clamp(-1.0, 1.0));
            let exact = 0.5 - c * c / 6.0;
            let points = frame.through.layers.iter().zip(&frame.through.points);
            let found: f64 = points.map(|(layer, point)| layer.weight * layer.xi * point.stress_meridional).sum();
            errors += ((found - exact) / found).powi(2);
            estimates += moment_error(&frame).expect("a moment").powi(2);
        }
        let ratio = (estimates / errors).sqrt();
        assert!((0.2..5.0).contains(&ratio), "{n} layers: {ratio}");
    }
}

#[test]
fn an_elastic_section_has_no_error_and_a_membrane_no_moment() {
    assert!(moment_error(&section(5, |xi| 200.0 * xi + 30.0)).expect("a moment") < 1e-14);
    assert_eq!(moment_error(&section(1, |_| 200.0)), None);
    assert_eq!(moment_error(&section(5, |_| 0.0)), None);
}
