//! What is measured and drawn of single frames: legs of solved sheets, stress through the thickness, spring-back.

use crate::common::prelude::*;
use stampflow::measure::{Band, Stretch, bands};

/// The last frame of a shipped case.
fn end(name: &str) -> &'static Frame {
    solved(name).stages[0].frames.last().expect("a frame")
}

/// Trust: what a frame says of an element is the mean of what it says of the element's layers, by the layers' rule.
#[test]
fn a_frame_keeps_its_layers() {
    let frame = end("quickstart");
    let layers = &frame.through.layers;
    assert_eq!(layers.len(), solved("quickstart").case.model().blank.layers);
    assert_eq!(frame.through.elements().len(), frame.elements.len());
    for (element, points) in frame.elements.iter().zip(frame.through.elements()) {
        let mean = |of: &dyn Fn(usize) -> f64| (0..layers.len()).map(|i| layers[i].weight * of(i)).sum::<f64>();
        assert_eq!(element.stress_meridional, mean(&|i| points[i].stress_meridional));
        assert_eq!(element.stress_hoop, mean(&|i| points[i].stress_hoop));
        assert_eq!(element.strain_equivalent, mean(&|i| points[i].strain_equivalent));
    }
}

/// Trust: where the cup's sheet was stretched around the punch's nose its outer face, the die's, is strained more: ξ = −1.
#[test]
fn the_first_layer_is_the_dies_face() {
    let frame = end("quickstart");
    let nose = frame.elements.iter().position(|element| element.s0 > 20.0).expect("an element on the nose");
    let points = frame.through.elements().nth(nose).expect("points");
    assert!(points[0].strain_equivalent > points[points.len() - 1].strain_equivalent);
    // The first fifth of the thickness stands for its own middle.
    assert_eq!(frame.through.layers[0].xi, -0.8);
}

/// Trust: the common tangent of punch nose and die shoulder, the sheet's middle half a thickness away from each; contact
/// and bending stiffness leave the wall within a degree of it.
#[test]
fn a_drawn_wall_is_the_common_tangent_of_the_tools() {
    let frame = end("quickstart");
    let (nose, shoulder, travel) = (6.5_f64, 6.5, 25.0);
    let (dr, dz) = (31.25 + 6.0 - 24.0, travel - nose - shoulder);
    let tangent = 90.0 - (dz.atan2(dr) + ((nose + shoulder) / dr.hypot(dz)).asin()).to_degrees();
    let shape = Shape::of(frame);
    let angle = shape.wall_angle().expect("a wall");
    assert!((angle - tangent).abs() < 1.0, "{angle}° for {tangent}°");
    assert!((shape.height.expect("a height") - travel - 1.0).abs() < 0.5);
}

/// Trust: holder and die are flat, and the sheet lies between them.
#[test]
fn a_held_flange_is_level() {
    let flange = Shape::of(end("brite_cylindrical")).flange_angle().expect("a flange");
    assert!(flange.abs() < 0.01, "{flange}°");
}

fn names(bands: &[Stretch]) -> Vec<Band> {
    bands.iter().map(|stretch| stretch.band).collect()
}

/// Trust: the cup's bottom ends at the centre of the punch's nose (r = 24 mm), and the sheet's middle, half a thickness off
/// nose and shoulder, wraps round both by what the wall's tangent leaves of 90°. A border is half-way between two nodes,
/// and contact ends a node early or late: within two elements of 0.7 mm.
#[test]
fn the_bands_of_a_cup_are_where_its_tools_are() {
    let stage = &shipped::solved("quickstart").stages[0];
    let cup = bands(stage);
    assert_eq!(names(&cup), [Band::Bottom, Band::PunchRadius, Band::Wall, Band::DieRadius, Band::Flange]);
    let wall = Shape::of(stage.frames.last().expect("a frame")).wall_angle().expect("a wall");
    let wrapped = 6.5 * (90.0 - wall).to_radians();
    assert!((cup[0].along[1] - 24.0).abs() < 1.4, "{cup:?}");
    for radius in [&cup[1], &cup[3]] {
        let length = radius.along[1] - radius.along[0];
        assert!((length - wrapped).abs() < 1.4, "{radius:?} for {wrapped} mm");
    }
    // They follow each other and hold every element once.
    assert_eq!((cup[0].along[0], cup[0].elements.start), (0.0, 0));
    assert!(cup.windows(2).all(|pair| pair[0].along[1] == pair[1].along[0]));
    assert!(cup.windows(2).all(|pair| pair[0].elements.end == pair[1].elements.start));
    assert_eq!(cup[4].elements.end, stage.model.blank.elements);
}

/// Trust: by hand: a punch round from the axis on, a free bulge, a box of superplastic sheet, a strip.
#[test]
fn bands_are_named_by_the_tools_that_made_them() {
    for (case, expected) in [
        ("osu_stretch", &[Band::Dome, Band::Unsupported, Band::DieRadius][..]),
        ("bulge", &[Band::Dome, Band::DieRadius]),
        ("superplastic_box", &[Band::Bottom, Band::DieCorner, Band::Wall, Band::DieRadius, Band::Flange]),
        ("strip_draw", &[Band::Bottom, Band::PunchRadius, Band::Wall, Band::DieRadius, Band::Flange]),
    ] {
        assert_eq!(names(&bands(&shipped::solved(case).stages[0])), expected, "{case}");
    }
    let boss = solved_once(&made("emboss", &[], &[]));
    assert_eq!(names(&bands(&boss.stages[0])), [Band::Boss, Band::PunchRadius, Band::DieRadius, Band::Flange]);
}

#[test]
fn a_part_keeps_its_bands_when_its_tools_are_gone() {
    for case in ["hat_springback", "stages_cup"] {
        let [formed, freed] = [0, 1].map(|stage| bands(&shipped::solved(case).stages[stage]));
        assert_eq!(names(&formed), names(&freed), "{case}");
        assert!(formed.iter().zip(&freed).all(|(a, b)| a.elements == b.elements), "{case}");
    }
}
