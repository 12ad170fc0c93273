//! A run that was not solved but drawn: a flat-bottomed cup whose shape follows the tools, for tests of what
//! is made from runs.

use stampflow::forming_limit::{self as limit, Instant, Kind, Paths, Sheet};
use stampflow::geometry::{Point, Profile};
use stampflow::material::hardening::Swift;
use stampflow::material::{Gtn, Hardening, Material};
use stampflow::model::{
    Blank, Edge, Face, Gas, Geometry, Grading, Heat, Mode, Model, Motion, Press, Pressure, PressureCap, RateControl,
    Role, Settings, StopRules, Theory, ThicknessRule, Tool,
};
use stampflow::numerics::lobatto;
use stampflow::plot::StageView;
use stampflow::solver::solution::{
    ElementRecord, Energy, Frame, NodeRecord, PointRecord, StageSolution, StepRecord, ThroughThickness,
};
use std::f64::consts::FRAC_PI_2;
use std::time::Duration;

const T0: f64 = 1.0;
const TRAVEL: f64 = 50.0;

/// The cup: blank radius 100 mm, punch 50 mm with a nose of 9 mm, die 51.25 mm with a shoulder of 7 mm.
pub fn model(geometry: Geometry) -> Model {
    let tool = |role, profile, motion| Tool { role, profile, friction: 0.05.into(), motion };
    Model {
        title: "Cup with a flat punch, drawn for tests".to_owned(),
        notes: vec![
            "The geometry is declared, not published: blank radius 100 mm, thickness 1.0 mm, flat punch of 50 mm \
             radius with a nose of 9 mm, die throat 51.25 mm with a shoulder of 7 mm."
                .to_owned(),
            "The law is offset to 547 (0.001 + ε)^0.18 MPa; the holder force of \"80 N\" is read as 80 kN.".to_owned(),
        ],
        geometry,
        depth: None,
        blank: Blank {
            length: 100.0,
            thickness: T0,
            elements: 80,
            grading: Grading::Uniform,
            theory: Theory::Bending,
            layers: 5,
            rule: ThicknessRule::default(),
            edge: Edge::Free,
        },
        material: Material::plain(Hardening::Swift(Swift::new(547.0, 0.18, 1e-3).unwrap())),
        tools: vec![
            tool(Role::Punch, Profile::flat_punch(50.0, 9.0, T0), Motion::Travel),
            tool(Role::Die, Profile::die(51.25, 7.0, T0), Motion::Fixed),
            tool(Role::Holder, Profile::holder(58.25, T0), Motion::Pressed(Press::constant(80_000.0))),
        ],
        beads: vec![],
        gas: vec![],
        heat: None,
        travel: TRAVEL,
        schedule: None,
        speed: 1.0,
        duration: TRAVEL,
        stop: StopRules::default(),
        timed: true,
        frames: (1..=5).map(|i| 0.2 * TRAVEL * i as f64).collect(),
        settings: Settings::default(),
        mode: Mode::default(),
        release: None,
        forming_limit: None,
    }
}

/// The same, hot and porous, with a gas pressure that holds a strain rate: then every output has something to show.
pub fn blown(geometry: Geometry) -> Model {
    let rate = RateControl { max_pressure: 2.0, ..RateControl::new(1e-3, 10.0) };
    let mut model = model(geometry);
    model.gas = vec![Gas { face: Face::Lower, pressure: Pressure::Rate(rate), within: 58.25 }];
    model.heat = Some(Heat { initial: 723.15.into(), flow: None });
    model.material.gtn = Some(Gtn::gurson(0.01));
    let sheet = Sheet { material: &model.material, thickness: 1.0, temperature: 723.15 };
    model.forming_limit = Some(Kind::Swift(limit::Swift { n: Some(0.2) }).curve(&sheet).expect("a curve"));
    model
}

/// A run of the model that reached its full travel.
pub fn run(model: &Model) -> StageSolution {
    let frames: Vec<Frame> = model.frames.iter().map(|&travel| frame(model, travel)).collect();
    let steps = 100;
    let mut history = Vec::new();
    let mut work = Energy::default();
    for step in 1..=steps {
        let travel = model.travel * step as f64 / steps as f64;
        let punch_force = 95_000.0 * (1.9 * travel / model.travel).sin().max(0.0).powf(0.8);
        let done = punch_force * model.travel / steps as f64;
        work.external += done;
        work.plastic += 0.9 * done;
        work.friction += 0.099 * done;
        work.contact += 0.0005 * done;
        work.cutoff += 0.002 * done;
        let now = frame(model, travel);
        let thinnest = now.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness)).unwrap();
        history.push(StepRecord {
            step,
            time: travel,
            travel,
            punch_force,
            holder_force: 80_000.0,
            pressure: 0.02 * step as f64,
            held_rate: 1e-3,
            on_cap: (step == steps).then_some(PressureCap::Largest),
            contact_share: 0.009 * step as f64,
            edge_force: 0.0,
            draw_in: model.blank.length - now.nodes.last().unwrap().r,
            thinnest: thinnest.thickness,
            thinnest_s0: thinnest.s0,
            penetration: 6e-2,
            iterations: 5 + step % 3,
            rejected: usize::from(step == 7),
            velocity_norm: 3e-6,
            residual_norm: 2e-5,
            power: Energy::default(),
            work,
            ..StepRecord::default()
        });
    }
    let mut paths = Paths::default();
    if let (Some(_), Some(first)) = (&model.forming_limit, frames.first()) {
        paths = Paths::starting(first.elements.iter().map(|e| e.s0).collect());
        let strains = |f: &Frame| f.elements.iter().map(|e| [e.strain_meridional, e.strain_hoop]).collect();
        frames.iter().for_each(|f| paths.push(Instant { time: f.time, travel: f.travel, strains: strains(f) }));
    }
    StageSolution { steps: history, frames, paths, ..StageSolution::unsolved(model.clone()) }
}

/// What all outputs are made from.
pub fn view(run: &StageSolution) -> StageView<'_> {
    let mut view = StageView::alone("cup", run);
    view.case_text = "title = \"cup\"\n";
    view.wall = Some(Duration::from_millis(312));
    view
}

/// The sheet wrapped around punch nose and die shoulder with volume kept, thinned at the nose.
fn frame(model: &Model, travel: f64) -> Frame {
    let depth = travel / TRAVEL;
    let thickness = |s0: f64| {
        let nose = (-((s0 - 48.0) / 7.0_f64).powi(2)).exp();
        T0 * (1.0 - depth * (0.16 * nose + 0.03 * (s0 < 45.0) as i32 as f64) + 0.18 * depth * (s0 / 100.0).powi(4))
    };
    let n = model.blank.elements;
    let fine = 20;
    let ds0 = model.blank.length / (n * fine) as f64;
    let mut s = 0.0;
    let mut nodes = vec![node(travel, 0.0, thickness(0.0))];
    for i in 0..n * fine {
        let s0 = (i as f64 + 0.5) * ds0;
        let (r, _) = along(travel, s + 0.5 * ds0);
        let width = if model.geometry == Geometry::Axisymmetric { s0 / r } else { 1.0 };
        s += ds0 * width * T0 / thickness(s0);
        if (i + 1) % fine == 0 {
            nodes.push(node(travel, s, thickness(s0)));
        }
    }
    let h = model.blank.length / n as f64;
    let elements: Vec<ElementRecord> = nodes
        .windows(2)
        .enumerate()
        .map(|(i, w)| {
            let s0 = (i as f64 + 0.5) * h;
            let r = 0.5 * (w[0].r + w[1].r);
            let chord = (w[1].r - w[0].r).hypot(w[1].z - w[0].z);
            let (meridional, hoop) = ((chord / h).ln(), (r / s0).ln());
            let equivalent = (4.0 / 3.0 * (meridional.powi(2) + hoop.powi(2) + meridional * hoop)).sqrt();
            let flow = model.material.hardening.at(equivalent).stress;
            ElementRecord {
                s0,
                r,
                z: 0.5 * (w[0].z + w[1].z),
                thickness: thickness(s0),
                strain_meridional: meridional,
                strain_hoop: hoop,
                strain_thickness: (thickness(s0) / T0).ln(),
                strain_equivalent: equivalent,
                strain_equivalent_max: 1.1 * equivalent,
                stress_meridional: 0.9 * flow,
                stress_hoop: 0.3 * flow,
                porosity: 0.01 + 0.1 * equivalent * travel / TRAVEL,
                temperature: 293.15 + 200.0 * s0 / model.blank.length - travel,
                bends: true,
            }
        })
        .collect();
    // Bent and stretched: tension and more of it on the punch's face, in proportion to the mean stress.
    let layers = lobatto::rule(model.blank.layers);
    let points = elements.iter().flat_map(|e| layers.iter().map(|layer| point(e, layer.xi))).collect();
    let tool_displacement = [travel, 0.0, -0.12 * depth].map(|along| Point::new(0.0, along)).to_vec();
    let through = ThroughThickness { layers, points };
    Frame { time: travel, travel, elements, nodes, through, tool_displacement }
}

fn point(element: &ElementRecord, xi: f64) -> PointRecord {
    PointRecord {
        stress_meridional: element.stress_meridional * (1.0 + 0.5 * xi),
        stress_hoop: element.stress_hoop * (1.0 + 0.5 * xi),
        strain_equivalent: element.strain_equivalent * (1.0 + 0.1 * xi.abs()),
    }
}

fn node(travel: f64, s: f64, thickness: f64) -> NodeRecord {
    let (r, z) = along(travel, s);
    NodeRecord { r, z, theta: 0.0, thickness }
}

/// The mid-surface at the length `s` from the axis: bottom, punch nose, straight wall, die shoulder, flange.
fn along(travel: f64, s: f64) -> (f64, f64) {
    let (nose, shoulder) = (9.0 + 0.5 * T0, 7.0 + 0.5 * T0);
    let (c1, c2) = (Point::new(41.0, travel - nose), Point::new(58.25, shoulder));
    let between = c2 - c1;
    let normal = between.y.atan2(between.x) + ((nose + shoulder) / between.norm()).acos();
    let n = Point::new(normal.cos(), normal.sin());
    let (from, to) = (c1 + nose * n, c2 - shoulder * n);
    let wall = (to - from).norm();
    let turn = FRAC_PI_2 - normal;
    let mut rest = s;
    if rest <= c1.x {
        return (rest, travel);
    }
    rest -= c1.x;
    if rest <= nose * turn {
        let angle = FRAC_PI_2 - rest / nose;
        return (c1.x + nose * angle.cos(), c1.y + nose * angle.sin());
    }
    rest -= nose * turn;
    if rest <= wall {
        let p = from + (to - from) * (rest / wall);
        return (p.x, p.y);
    }
    rest -= wall;
    if rest <= shoulder * turn {
        let angle = normal + rest / shoulder;
        return (c2.x - shoulder * angle.cos(), c2.y - shoulder * angle.sin());
    }
    (c2.x + rest - shoulder * turn, 0.0)
}
