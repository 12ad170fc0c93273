//! Random sections in the range that press shops use, made from a seed: for the campaign and for tests.

use fastrand::Rng;
use stampflow::geometry::{Arc, Piece, Point, Profile, Segment};
use stampflow::material::hardening::{Branch, Extrapolation, Hollomon, Ludwik, PiecewisePower, Swift, Table, Voce};
use stampflow::model::{Blank, Edge, Geometry, Model, Motion, Norm, Press, Role, Settings, Tool};
use stampflow::{case::library, material::Hardening, material::Material};
use std::f64::consts::FRAC_PI_2;

/// The kinds of section.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Process {
    Hemispherical,
    Flat,
    Stretch,
    Hat,
    Conical,
    TwoRadius,
}

/// A random section and its description in one line.
pub struct RandomDie {
    pub process: Process,
    pub model: Model,
    pub text: String,
}

pub fn between(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * rng.f64()
}

/// From this seed on the dies are of the second series, whose hardening law is any example of the family: a law that joins
/// the family occurs there, and the dies of the first series, which figures are compared with, stay as they are.
pub const SECOND_SERIES: u64 = 1 << 40;

/// From this seed on they are of the third series, whose sheet is any of the library.
pub const THIRD_SERIES: u64 = 2 << 40;

/// The sheet of the die that belongs to `seed`.
fn sheet(rng: &mut Rng, seed: u64) -> (Material, String) {
    if seed >= THIRD_SERIES {
        let mut sheets = library::materials().expect("the shipped library");
        sheets.retain(|sheet| !sheet.about.is_made());
        let entry = sheets.swap_remove(rng.usize(0..sheets.len()));
        return (entry.material, entry.name.to_owned());
    }
    let (law, text) = hardening(rng, seed);
    (Material::plain(law), text)
}

/// σ in MPa with a tensile strength from mild aluminium to high-strength steel, n from 0.02 to 0.5.
fn hardening(rng: &mut Rng, seed: u64) -> (Hardening, String) {
    let k = between(rng, 150.0, 1200.0);
    let n = between(rng, 0.02, 0.5);
    if seed >= SECOND_SERIES {
        let mut laws = Hardening::examples();
        laws.retain(|(name, _)| *name != "scaled");
        let (_, law) = laws.swap_remove(rng.usize(0..laws.len()));
        let text = law.to_string();
        return (law, text);
    }
    let law = match rng.usize(0..6) {
        0 => Hardening::Swift(Swift::new(k, n, between(rng, 1e-4, 2e-2)).expect("in range")),
        1 => Hardening::Hollomon(Hollomon::new(k, n, Some(2e-3), None).expect("in range")),
        2 => Hardening::Ludwik(Ludwik::new(0.4 * k, 0.8 * k, n.max(0.1)).expect("in range")),
        3 => Hardening::Voce(Voce::new(0.4 * k, k, between(rng, 2.0, 12.0), 1.0).expect("in range")),
        4 => Hardening::PiecewisePower(branches(rng, k, n)),
        _ => Hardening::Table(measured(rng, k, n)),
    };
    let text = law.to_string();
    (law, text)
}

/// Two branches σ₀ + K ε^n that meet, the second with the exponent 0.5 to 1 of the first.
fn branches(rng: &mut Rng, k: f64, n: f64) -> PiecewisePower {
    let (initial, up_to) = (0.3 * k, between(rng, 0.05, 0.4));
    let flatter = n * between(rng, 0.5, 1.0);
    let first = Branch { up_to, initial, k: 0.7 * k, n };
    let second = Branch { up_to: f64::INFINITY, initial, k: 0.7 * k * up_to.powf(n - flatter), n: flatter };
    PiecewisePower::new(vec![first, second]).expect("the branches meet")
}

/// Points of a Swift law with 2 % of scatter that never falls, as from a tensile test, then held or continued.
fn measured(rng: &mut Rng, k: f64, n: f64) -> Table {
    let strain: Vec<f64> = [0.0, 0.002, 0.01, 0.03, 0.08, 0.15, 0.25, 0.5].to_vec();
    let mut last: f64 = 0.0;
    let stress = strain.iter().map(|e| {
        last = last.max(k * (e + 2e-3).powf(n) * between(rng, 0.98, 1.02));
        last
    });
    let stress = stress.collect();
    Table::new(strain, stress, if rng.bool() { Extrapolation::Hold } else { Extrapolation::Slope }).expect("rising")
}

/// A cone: flat face, corner of `nose`, wall that leans by `angle` from upright up to `radius`.
fn conical_punch(radius: f64, nose: f64, angle: f64, height: f64, t: f64) -> Profile {
    let top = -0.5 * t;
    let sweep = FRAC_PI_2 - angle;
    // The cone reaches `radius` at `height` above the face; the corner starts where the flat ends.
    let run = (height - nose * (1.0 - angle.sin())) * angle.tan();
    let flat = radius - nose * angle.cos() - run;
    let corner = Arc::new(Point::new(flat, top - nose), nose, FRAC_PI_2, -sweep);
    let start = corner.at(1.0);
    let end = Point::new(radius, start.y - run / angle.tan());
    let pieces = vec![
        Piece::Segment(Segment::new(Point::new(0.0, top), Point::new(flat, top))),
        Piece::Arc(corner),
        Piece::Segment(Segment::new(start, end)),
        Piece::Segment(Segment::new(end, Point::new(radius, end.y - 20.0 * radius))),
    ];
    Profile::new(pieces).expect("connected")
}

/// The section that belongs to `seed`.
pub fn random_die(seed: u64) -> RandomDie {
    let rng = &mut Rng::with_seed(seed);
    let process =
        [Process::Hemispherical, Process::Flat, Process::Stretch, Process::Hat, Process::Conical, Process::TwoRadius]
            [rng.usize(0..6)];
    let t = 0.3 * 10f64.powf(rng.f64());
    let corner = t * between(rng, 3.0, 20.0);
    let shoulder = t * between(rng, 3.0, 20.0);
    let ratio = between(rng, 1.2, 2.2);
    let friction = between(rng, 0.0, 0.2);
    let clearance = t * between(rng, 1.05, 1.6);
    let siebels = between(rng, 0.0, 3.0);
    let radius = (corner * between(rng, 1.5, 6.0)).max(20.0 * t);
    let (material, material_text) = sheet(rng, seed);

    let throat = radius + clearance;
    let plane = process == Process::Hat;
    let stretch = process == Process::Stretch;
    let flange = throat + shoulder;
    let length = if stretch { flange } else { (ratio * radius).max(flange + 3.0 * t) };
    let cup = if plane { length - radius } else { 0.5 * (length * length - radius * radius) / radius };
    let share = between(rng, 0.3, 0.9);
    let travel = if stretch { share * radius } else { share * cup.max(2.0 * t) };
    let punch = match process {
        Process::Hemispherical | Process::Stretch => Profile::hemispherical_punch(radius, t),
        Process::Flat | Process::Hat => Profile::flat_punch(radius, corner, t),
        Process::TwoRadius => Profile::crowned_punch(radius, radius * between(rng, 1.5, 5.0), corner, t),
        Process::Conical => {
            let height = (0.8 * radius).max(2.0 * corner);
            let room = ((radius - 1.2 * corner) / height).clamp(0.05, 0.5);
            conical_punch(radius, corner, between(rng, 0.3, 0.9) * room, height, t)
        }
    };

    let strength =
        (0..400).map(|i| 5e-3 * f64::from(i)).map(|e| material.hardening.at(e).stress * (-e).exp()).fold(0.0, f64::max);
    let beta = length / radius;
    let siebel = 0.0025 * ((beta - 1.0).powi(2) + radius / (100.0 * t)) * strength;
    let held = if plane { 2.0 * (length - flange) } else { std::f64::consts::PI * (length * length - flange * flange) };
    let force = siebels * siebel * held;
    let tool = |role, profile, motion| Tool { role, profile, friction: friction.into(), motion };
    let mut tools = vec![
        tool(Role::Punch, punch, Motion::Travel),
        tool(Role::Die, Profile::die(throat, shoulder, t), Motion::Fixed),
    ];
    if !stretch && siebels > 0.05 {
        tools.push(tool(Role::Holder, Profile::holder(flange, t), Motion::Pressed(Press::constant(force))));
    }
    let elements = rng.usize(30..=200);
    let edge = if stretch { Edge::Clamped } else { Edge::Free };
    let blank = Blank { elements, edge, ..Blank::new(length, t) };
    let norm = if rng.bool() { Norm::Velocity } else { Norm::Both };
    let text = format!(
        "{process:?} t {t:.3} R {radius:.2} corner {:.1} t shoulder {:.1} t ratio {beta:.2} clearance {:.2} t mu {friction:.3} \
         holder {siebels:.2} Siebel travel {travel:.2} mm, {elements} elements, {norm:?}, {material_text}",
        corner / t,
        shoulder / t,
        clearance / t,
    );
    let model = Model {
        title: format!("random die {seed}"),
        geometry: if plane { Geometry::PlaneStrain } else { Geometry::Axisymmetric },
        timed: true,
        settings: Settings { norm, ..Settings::default() },
        ..Model::new(blank, material, tools, travel)
    };
    RandomDie { process, model, text }
}
