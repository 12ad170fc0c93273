//! Small models built in code, for tests against closed forms.

use crate::common::prelude::*;

/// A sheet of 1 mm with no tools, pulled outward by `travel` [mm].
pub fn pulled(geometry: Geometry, theory: Theory, travel: f64) -> Model {
    let material = Material::plain(Hardening::Swift(Swift::new(520.0, 0.22, 1e-3).expect("valid")));
    let blank = Blank {
        elements: 8,
        grading: Grading::Uniform,
        theory,
        layers: if theory == Theory::Membrane { 1 } else { 5 },
        rule: ThicknessRule::Lobatto,
        edge: Edge::Pulled { speed: 1.0 },
        ..Blank::new(40.0, 1.0)
    };
    Model { geometry, timed: true, ..Model::new(blank, material, vec![], travel) }
}

/// A sheet of 50 mm clamped at its edge, with no die, under a pressure on its lower face for 10 s.
pub fn bulged(geometry: Geometry, theory: Theory, elements: usize, pressure: Pressure) -> Model {
    let pulled = pulled(geometry, theory, 1.0);
    let blank = Blank { length: 50.0, elements, edge: Edge::Clamped, ..pulled.blank.clone() };
    let gas = vec![Gas { face: Face::Lower, pressure, within: 50.0 }];
    Model { blank, gas, travel: 0.0, speed: 5.0, duration: 10.0, frames: vec![10.0], ..pulled }
}

/// Lets the punch of a model travel so far [mm] at its speed.
pub fn drive_to(model: &mut Model, travel: f64) {
    (model.travel, model.duration) = (travel, travel / model.speed);
    model.frames = vec![model.duration];
}

/// Whether two profiles have one distance from all of these points within a tolerance \[mm\].
pub fn are_alike(a: &Profile, b: &Profile, within: f64, mut points: impl Iterator<Item = Point>) -> bool {
    points.all(|x| (a.closest(x).distance - b.closest(x).distance).abs() < within)
}

/// A strip too strong to yield, drawn by a flat punch over a die shoulder of 10 mm with friction `mu` there:
/// a rope over a bollard on either side. The holder's own friction holds them back with `2 · 0.1 · holder` together [N/mm].
pub fn capstan(mu: f64, holder: f64, per_quarter: usize) -> Model {
    let t = 1.0;
    let shoulder = 10.0;
    let size = std::f64::consts::FRAC_PI_2 * (shoulder + 0.5 * t) / per_quarter as f64;
    let length = 120.0;
    let tool = |role, profile, friction, motion| Tool { role, profile, friction: Friction::from(friction), motion };
    let plain = pulled(Geometry::PlaneStrain, Theory::Membrane, 50.0);
    let elements = (length / size).round() as usize;
    Model {
        title: "capstan".into(),
        blank: Blank { length, thickness: t, elements, edge: Edge::Free, ..plain.blank.clone() },
        material: Material::plain(Hardening::Ludwik(Ludwik::new(150.0, 0.0, 1.0).expect("valid"))),
        tools: vec![
            tool(Role::Punch, Profile::flat_punch(30.0, 10.0, t), 0.3, Motion::Travel),
            tool(Role::Die, Profile::die(31.3, shoulder, t), mu, Motion::Fixed),
            tool(Role::Holder, Profile::holder(41.3, t), 0.2 - mu, Motion::Pressed(Press::constant(holder))),
        ],
        ..plain
    }
}
