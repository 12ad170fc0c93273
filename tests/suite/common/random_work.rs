//! Random work of other kinds than stamping sections, made from a seed: bends, ironing, gas beside the punch, free flanges,
//! a second stage; with few elements and metals that hardly harden among them.

use super::random_die::{Process, RandomDie, SECOND_SERIES, between, random_die};
use fastrand::Rng;
use stampflow::geometry::{Arc, Piece, Point, Profile, Segment};
use stampflow::material::{Elastic, Hardening, hardening::Swift};
use stampflow::model::{
    Beginning, Edge, Face, Gas, Geometry, Grading, Mode, Model, Motion, ReleaseStiffness, Role, Stage, Tool,
};
use stampflow::numerics::PiecewiseLinear;
use std::f64::consts::{FRAC_PI_2, PI};

/// The kinds of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Kind {
    VBend,
    WBend,
    GasAndPunch,
    Ironing,
    FreeFlange,
    /// Drawn, the rim cut, and drawn on.
    Trimmed,
    /// Drawn, the rim cut, and let go; in the flow approach, in which nothing springs back, drawn alone.
    Released,
}

impl Kind {
    pub const ALL: [Kind; 7] =
        [Kind::VBend, Kind::WBend, Kind::GasAndPunch, Kind::Ironing, Kind::FreeFlange, Kind::Trimmed, Kind::Released];
}

/// Random work and its description in one line.
pub struct RandomWork {
    pub kind: Kind,
    pub stages: Vec<Stage>,
    pub text: String,
}

/// Makes a model's metal elastic too, with the elastoplastic law's usual number of points through the thickness.
pub fn make_elastic(model: &mut Model) {
    model.mode = Mode::ElastoViscoplastic;
    model.material.elastic = Some(Elastic { young: 206_000.0, poisson: 0.3 });
    model.blank.layers = 15;
}

/// The work that belongs to `seed`.
pub fn random_work(seed: u64, elastic: bool) -> RandomWork {
    let rng = &mut Rng::with_seed(seed ^ 0x5eed);
    let kind = Kind::ALL[rng.usize(0..Kind::ALL.len())];
    let sections: &[Process] = match kind {
        Kind::VBend | Kind::WBend => &[Process::Hat],
        Kind::Ironing => &[Process::Flat, Process::Hat, Process::TwoRadius],
        Kind::Released => &[Process::Hat, Process::Flat, Process::Conical],
        _ => &[Process::Hemispherical, Process::Flat, Process::Hat, Process::Conical, Process::TwoRadius],
    };
    // The next section of the right kind from somewhere on.
    let RandomDie { process, mut model, .. } = (rng.u64(0..SECOND_SERIES)..)
        .map(random_die)
        .find(|die| sections.contains(&die.process))
        .expect("all kinds occur");
    let t = model.blank.thickness;
    if rng.bool() {
        model.blank.elements = rng.usize(20..=40);
    }
    if rng.usize(0..3) == 0 {
        let law = Swift::new(between(rng, 150.0, 1200.0), 0.02, 1e-3).expect("in range");
        model.material.hardening = Hardening::Swift(law);
    }
    if elastic {
        make_elastic(&mut model);
    }
    let detail = match kind {
        Kind::VBend => bend(rng, &mut model, false),
        Kind::WBend => bend(rng, &mut model, true),
        Kind::GasAndPunch => add_gas(rng, &mut model),
        Kind::Ironing => iron(rng, &mut model),
        Kind::FreeFlange => {
            model.tools.retain(|tool| tool.role != Role::Holder);
            String::new()
        }
        Kind::Trimmed | Kind::Released => String::new(),
    };
    let mut text = format!(
        "{kind:?} of {process:?} t {t:.3} L {:.2} travel {:.2} mm, {} elements, {:?}, {}{detail}",
        model.blank.length, model.travel, model.blank.elements, model.settings.norm, model.material.hardening,
    );
    let second = match kind {
        Kind::Trimmed => Some(drawn_on(rng, &model)),
        Kind::Released => elastic.then(|| let_go(rng, &model)),
        _ => None,
    };
    if let Some(Stage { begin: Beginning { trim: Some(at), .. }, .. }) = &second {
        text += &format!(", cut at {at:.2} mm");
    }
    let first = Stage { name: "draw".into(), model, begin: Beginning::default() };
    RandomWork { kind, stages: [first].into_iter().chain(second).collect(), text }
}

/// Distance of a section's outer end from the axis or symmetry plane \[mm\].
fn outermost(profile: &Profile) -> f64 {
    profile.pieces().iter().map(|piece| piece.first().x.max(piece.last().x)).fold(0.0, f64::max)
}

fn sets_travel(model: &mut Model, travel: f64) {
    (model.travel, model.duration, model.frames) = (travel, travel, vec![travel]);
}

/// A punch that leaves 0.8 to 1.1 thicknesses to its die's wall.
fn iron(rng: &mut Rng, model: &mut Model) -> String {
    let t = model.blank.thickness;
    let clearance = between(rng, 0.8, 1.1);
    let radius = outermost(&model.tool(Role::Punch).expect("a punch").profile);
    let die = model.tools.iter_mut().find(|tool| tool.role == Role::Die).expect("a die");
    let shoulder = between(rng, 4.0, 12.0) * t;
    die.profile = Profile::die(radius + clearance * t, shoulder, t);
    format!(", clearance {clearance:.3} t, shoulder {:.1} t", shoulder / t)
}

/// Oil in the die that presses the sheet onto the punch, up to the holder's inner end.
fn add_gas(rng: &mut Rng, model: &mut Model) -> String {
    let radius = outermost(&model.tool(Role::Punch).expect("a punch").profile);
    let strength = model.material.hardening.at(0.1).stress;
    let pressure = between(rng, 0.05, 0.5) * strength * model.blank.thickness / radius;
    let rise = between(rng, 0.1, 1.0) * model.duration;
    let history = vec![(0.0, 0.0), (rise, pressure)];
    let history = PiecewiseLinear::new(history).expect("rising times");
    model.gas = vec![Gas { face: Face::Upper, pressure: history.into(), within: radius }];
    format!(", gas {pressure:.2} MPa in {rise:.1} s")
}

/// Tools of a V-bend, or of a W-bend with another V beside: flanks that lean by an angle, round noses and valleys.
fn bend(rng: &mut Rng, model: &mut Model, two: bool) -> String {
    let t = model.blank.thickness;
    // Of the flanks from upright: legs of 60 to 140 degrees.
    let lean = between(rng, 30f64, 70.0).to_radians();
    let nose = between(rng, 1.0, 8.0) * t;
    let gap = between(rng, 1.0, 1.2) * t;
    let shoulder = between(rng, 2.0, 8.0) * t;
    let (flank, hump) = (between(rng, 8.0, 25.0) * t, between(rng, 1.0, 8.0) * t);
    let (sin, cos) = lean.sin_cos();
    let turn = FRAC_PI_2 - lean;
    // The V's middle, from the symmetry plane: past a hump and a flank in a W.
    let middle = if two { (hump + gap + nose) * cos + flank * sin } else { 0.0 };
    let outer = flank * between(rng, 1.0, 1.5) + hump;
    let valley = nose + gap;
    let end = middle + (valley + shoulder) * cos + outer * sin;
    let along = |from: Point, x: f64, y: f64, length: f64| Segment::new(from, from + Point::new(x, y) * length);

    let mut punch = Vec::new();
    let mut top = Arc::new(Point::new(0.0, -0.5 * t - nose), nose, FRAC_PI_2, -turn);
    if two {
        top = Arc::new(Point::new(middle, -0.5 * t - nose), nose, PI - lean, 2.0 * lean - PI);
        let start = top.at(0.0) - Point::new(sin, cos) * flank;
        let radius = hump + gap;
        punch.push(Piece::Arc(Arc::new(start + Point::new(-cos, sin) * radius, radius, -FRAC_PI_2, turn)));
        punch.push(Piece::Segment(Segment::new(start, top.at(0.0))));
    }
    punch.push(Piece::Arc(top));
    punch.push(Piece::Segment(along(top.at(1.0), sin, -cos, 20.0 * end)));

    let face = 0.5 * t;
    let round = Arc::new(Point::new(end, face + shoulder), shoulder, -FRAC_PI_2, -turn);
    let wall = along(round.at(1.0), -sin, cos, outer);
    let center = wall.to - Point::new(cos, sin) * valley;
    let bottom = Arc::new(center, valley, lean, if two { PI - 2.0 * lean } else { turn });
    let mut die = vec![
        Piece::Segment(Segment::new(Point::new(21.0 * end, face), Point::new(end, face))),
        Piece::Arc(round),
        Piece::Segment(wall),
        Piece::Arc(bottom),
    ];
    if two {
        let inner = along(bottom.at(1.0), -sin, -cos, flank);
        die.push(Piece::Segment(inner));
        die.push(Piece::Arc(Arc::new(inner.to + Point::new(-cos, sin) * hump, hump, -lean, -turn)));
    }
    let closed = center.y + valley - gap + 0.5 * t;
    let share = between(rng, 0.4, 0.98);
    let friction = model.tools[0].friction;
    let tool = |role, path, motion| Tool { role, profile: Profile::new(path).expect("connected"), friction, motion };
    model.tools = vec![tool(Role::Punch, punch, Motion::Travel), tool(Role::Die, die, Motion::Fixed)];
    // Long enough to lie on the shoulder until the V is closed.
    model.blank.length = end + (closed / cos + 4.0 * t) * between(rng, 0.6, 1.2);
    model.blank.edge = Edge::Free;
    model.blank.grading = Grading::Radii;
    model.geometry = Geometry::PlaneStrain;
    sets_travel(model, share * closed);
    format!(", flanks {:.0} degrees from upright, nose {:.1} t, {share:.2} of the way", lean.to_degrees(), nose / t)
}

/// Where the rim is cut: somewhere in what lies outside the die's shoulder at first.
fn cut(rng: &mut Rng, model: &Model) -> f64 {
    let die = model.tool(Role::Die).expect("a die").profile.least_r();
    die + (model.blank.length - die) * between(rng, 0.2, 0.8)
}

fn drawn_on(rng: &mut Rng, before: &Model) -> Stage {
    let mut model = before.clone();
    let travel = before.travel * between(rng, 0.1, 0.5);
    sets_travel(&mut model, travel);
    model.tools[0].motion = Motion::Path(Point::new(0.0, travel));
    Stage { name: "on".into(), begin: Beginning { trim: Some(cut(rng, before)), ..Beginning::default() }, model }
}

fn let_go(rng: &mut Rng, before: &Model) -> Stage {
    let mut model = before.clone();
    sets_travel(&mut model, 0.0);
    (model.duration, model.frames, model.speed) = (1.0, vec![1.0], before.blank.thickness);
    for tool in &mut model.tools {
        tool.motion = Motion::Fixed;
    }
    model.release = Some(ReleaseStiffness::Updated);
    let trim = rng.bool().then(|| cut(rng, before));
    Stage { name: "release".into(), begin: Beginning { trim, ..Beginning::default() }, model }
}
