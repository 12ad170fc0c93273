//! No model that can be built in code ends in a panic: it is refused with the value that is wrong, or it runs.

use crate::common::prelude::*;
use stampflow::contact::friction::{PressureDependent, Stribeck, Tresca};

const NUMBERS: [f64; 8] = [f64::NAN, 0.0, -0.0, -1.0, f64::INFINITY, f64::NEG_INFINITY, 1e300, 1e-300];
const COUNTS: [usize; 4] = [0, 1, 2, usize::MAX];

/// A cup drawn by 0.5 mm: everything is there that a check may ask for, and it is solved in a moment.
fn cup() -> Model {
    let mut model = parsed(include_str!("common/small_cup.toml"), &[]).stages.remove(0).model;
    model.settings.max_step = 0.2;
    model.settings.min_step = 1e-3;
    model.settings.first_step = 0.05;
    model.beads = vec![Bead { at: 16.0, restraining: 10.0.into(), closing: 1.0, round: None }];
    model.gas = vec![Gas { face: Face::Lower, pressure: 0.1.into(), within: 9.0 }];
    let flow = HeatFlow {
        capacity: 3.6,
        plastic_share: 0.9,
        conductivity: 50.0,
        tools: vec![ToolHeat { role: Role::Punch, temperature: 300.0, transfer: 1.0 }],
    };
    model.heat = Some(Heat { initial: 300.0.into(), flow: Some(flow) });
    model
}

fn holder(model: &mut Model) -> &mut Motion {
    &mut model.tools.iter_mut().find(|tool| tool.role == Role::Holder).expect("a holder").motion
}

/// Whether the model is refused; where it is not, that it runs.
fn refused(name: &str, model: &Model) -> bool {
    let checked = model.check();
    let solution = run(model, &mut ());
    match &checked {
        Err(error) => {
            // As text, for NaN is not equal to itself.
            assert_eq!((solution.stop.kind, solution.stop.text), (StopKind::Refused, error.to_string()), "{name}");
            assert!(solution.steps.is_empty());
        }
        Ok(()) => assert_ne!(solution.stop.kind, StopKind::Refused, "{name}"),
    }
    checked.is_err()
}

type Mutation<T> = (&'static str, fn(&mut Model, T));
type Change = (&'static str, fn(&mut Model));

/// Every number of a model: NaN and both infinities are refused in each.
const MUTATIONS: &[Mutation<f64>] = &[
    ("length", |m, x| m.blank.length = x),
    ("thickness", |m, x| m.blank.thickness = x),
    ("pulled", |m, x| m.blank.edge = Edge::Pulled { speed: x }),
    ("travel", |m, x| m.travel = x),
    ("travel without schedule", |m, x| (m.schedule, m.travel) = (None, x)),
    ("speed", |m, x| m.speed = x),
    ("duration", |m, x| m.duration = x),
    ("duration and frames", |m, x| (m.duration, m.frames) = (x, vec![x])),
    ("first frame", |m, x| m.frames[0] = x),
    ("last frame", |m, x| m.frames = vec![1.0, x]),
    ("schedule", |m, x| m.schedule = PiecewiseLinear::new(vec![(0.0, 0.0), (2.0, x)])),
    ("load drop", |m, x| m.stop.load_drop = Some(x)),
    ("contact share", |m, x| m.stop.contact_share = Some(x)),
    ("young", |m, x| {
        (m.mode, m.material.elastic) = (Mode::ElastoViscoplastic, Some(Elastic { young: x, poisson: 0.3 }))
    }),
    ("poisson", |m, x| {
        (m.mode, m.material.elastic) = (Mode::ElastoViscoplastic, Some(Elastic { young: 2e5, poisson: x }));
    }),
    ("anisotropy", |m, x| m.material.yield_criterion = Hill48::new(x).into()),
    ("back-stress", |m, x| (m.mode, m.material.chaboche[0].modulus) = (Mode::ElastoViscoplastic, x)),
    ("recovery", |m, x| (m.mode, m.material.chaboche[0].dynamic_recovery) = (Mode::ElastoViscoplastic, x)),
    ("rate exponent", |m, x| m.material.rate = Some(Rate::PowerRate(PowerRate { exponent: x, reference: 1.0 }))),
    ("rate reference", |m, x| m.material.rate = Some(Rate::PowerRate(PowerRate { exponent: 0.1, reference: x }))),
    ("critical damage", |m, x| m.material.fracture = Some(Fracture::Brozzo(Brozzo { critical: x }))),
    ("q1", |m, x| voids(m).q1 = x),
    ("q2", |m, x| voids(m).q2 = x),
    ("q3", |m, x| voids(m).q3 = x),
    ("porosity", |m, x| voids(m).initial = x),
    ("nucleation", |m, x| voids(m).nucleation.as_mut().expect("of the example").fraction = x),
    ("deviation", |m, x| voids(m).nucleation.as_mut().expect("of the example").deviation = x),
    ("critical", |m, x| voids(m).coalescence.as_mut().expect("of the example").critical = x),
    ("fracture", |m, x| voids(m).coalescence.as_mut().expect("of the example").fracture = x),
    ("friction", |m, x| m.tools[0].friction = x.into()),
    ("friction at rest", |m, x| {
        m.tools[0].friction = Friction::Stribeck(Stribeck { at_rest: x, sliding: 0.05, speed: 2.0, viscous: 0.0 });
    }),
    ("friction, viscous", |m, x| {
        m.tools[0].friction = Friction::Stribeck(Stribeck { at_rest: 0.1, sliding: 0.05, speed: 2.0, viscous: x });
    }),
    ("friction factor", |m, x| m.tools[0].friction = Friction::Tresca(Tresca { factor: x, coefficient: 0.1 })),
    ("friction exponent", |m, x| {
        let law = PressureDependent { coefficient: 0.1, reference: 10.0, exponent: x };
        m.tools[0].friction = Friction::PressureDependent(law);
    }),
    ("path", |m, x| m.tools[0].motion = Motion::Path(Point::new(0.0, x))),
    ("path aside", |m, x| m.tools[0].motion = Motion::Path(Point::new(x, 0.1))),
    ("holder's force", |m, x| *holder(m) = Motion::Pressed(Press::constant(x))),
    ("holder's spring", |m, x| *holder(m) = Motion::Pressed(Press { force: 1e3.into(), stiffness: x })),
    ("holder's gap", |m, x| *holder(m) = Motion::Gap(x)),
    ("bead", |m, x| m.beads[0].at = x),
    ("restraint", |m, x| m.beads[0].restraining = x.into()),
    ("closing", |m, x| m.beads[0].closing = x),
    ("pressure", |m, x| m.gas[0].pressure = x.into()),
    ("seal", |m, x| m.gas[0].within = x),
    ("strain rate", |m, x| m.gas[0].pressure = Pressure::Rate(RateControl::new(x, 10.0))),
    ("norm", |m, x| m.gas[0].pressure = Pressure::Rate(RateControl::new(0.1, x))),
    ("temperature", |m, x| m.heat.as_mut().expect("heat").initial = x.into()),
    ("capacity", |m, x| flow(m).capacity = x),
    ("plastic share", |m, x| flow(m).plastic_share = x),
    ("conductivity", |m, x| flow(m).conductivity = x),
    ("tool's temperature", |m, x| flow(m).tools[0].temperature = x),
    ("transfer", |m, x| flow(m).tools[0].transfer = x),
    ("tolerance", |m, x| m.settings.tolerance = x),
    ("max_step", |m, x| m.settings.max_step = x),
    ("first_step", |m, x| m.settings.first_step = x),
    ("min_step", |m, x| m.settings.min_step = x),
    ("cutoff_strain", |m, x| m.settings.cutoff_strain = x),
    ("contact_stiffness", |m, x| m.settings.contact_stiffness = x),
    ("contact_smoothing", |m, x| m.settings.contact_smoothing = x),
    ("slip_speed", |m, x| m.settings.slip_speed = x),
    ("strain_step", |m, x| m.settings.strain_step = x),
];

fn voids(model: &mut Model) -> &mut Gtn {
    model.material.gtn.insert(Gtn::example())
}

fn flow(model: &mut Model) -> &mut HeatFlow {
    model.heat.as_mut().and_then(|heat| heat.flow.as_mut()).expect("a flow of heat")
}

#[test]
fn every_number_is_refused_or_runs() {
    assert!(!refused("the cup itself", &cup()));
    let mut accepted = Vec::new();
    for (name, mutate) in MUTATIONS {
        for value in NUMBERS {
            let mut model = cup();
            mutate(&mut model, value);
            let changed = format!("{name} = {value}");
            if !refused(&changed, &model) && !value.is_finite() {
                accepted.push(changed);
            }
        }
    }
    assert_eq!(accepted, [""; 0]);
}

#[test]
fn every_count_is_refused_or_runs() {
    let counts: [Mutation<usize>; 3] = [
        ("elements", |m, n| m.blank.elements = n),
        ("layers", |m, n| m.blank.layers = n),
        ("max_iterations", |m, n| m.settings.max_iterations = n),
    ];
    for (name, mutate) in counts {
        for n in COUNTS {
            let mut model = cup();
            mutate(&mut model, n);
            let refused = refused(&format!("{name} = {n}"), &model);
            assert!(refused || (1..1000).contains(&n), "{name} = {n} is accepted");
        }
    }
}

/// Trust: each is a contradiction by the documentation of the field.
#[test]
fn what_does_not_go_together_is_refused() {
    let contradictions: [Change; 12] = [
        ("no frames", |m| m.frames.clear()),
        ("frames that fall", |m| m.frames = vec![1.5, 1.0, 2.0]),
        ("two punches", |m| m.tools.push(m.tools[0].clone())),
        ("a holder without a die", |m| m.tools.retain(|tool| tool.role != Role::Die)),
        ("a pressed punch", |m| m.tools[0].motion = Motion::Pressed(Press::constant(1.0))),
        ("gas twice on a face", |m| m.gas.push(m.gas[0].clone())),
        ("no elasticity", |m| (m.mode, m.material.elastic) = (Mode::Elastic, None)),
        ("elastic voids", |m| (m.mode, m.material.gtn) = (Mode::ElastoViscoplastic, Some(Gtn::example()))),
        ("a membrane of three points", |m| m.blank.theory = Theory::Membrane),
        ("a release that cannot spring back", |m| m.release = Some(Default::default())),
        ("heat to a tool that is not there", |m| m.tools.retain(|tool| tool.role != Role::Punch)),
        ("nothing that acts", |m| {
            m.tools.clear();
            flow(m).tools.clear();
            m.gas.clear();
        }),
    ];
    for (name, contradict) in contradictions {
        let mut model = cup();
        contradict(&mut model);
        assert!(refused(name, &model), "{name} is accepted");
    }
}

/// A later stage goes on with the points and the section of the one before.
#[test]
fn a_stage_that_cannot_go_on_is_refused() {
    let first = Stage { name: "first".into(), model: cup(), begin: Default::default() };
    let changes: [fn(&mut Stage); 4] = [
        |stage| stage.model.blank.layers = 5,
        |stage| stage.begin.trim = Some(f64::NAN),
        |stage| stage.model.geometry = stampflow::model::Geometry::PlaneStrain,
        |stage| stage.model.blank.thickness = -1.0,
    ];
    for change in changes {
        let mut second = first.clone();
        change(&mut second);
        let solutions = solver::solve(&[first.clone(), second], &mut ());
        assert_eq!(solutions.len(), 2);
        assert_eq!(solutions[1].stop.kind, StopKind::Refused);
    }
}

/// Trust: the words of the trade, written out by hand.
#[test]
fn words_and_texts_name_their_tools_in_three_languages() {
    use Role::{Die, Holder, Pad, Punch};
    for (texts, roles) in [
        ("punch, OP20_PUNCH, OP10 - Ziehstempel unten, draw punch, Poinçon, poinc\u{327}on", &[Punch][..]),
        ("LowerDie2, lowerdie, draw_die, Matrize, Ziehring, matrice", &[Die]),
        ("SERRE FLAN, Blank holder 1, binder, blank_holder, Blech-Niederhalter, serre-tôle", &[Holder]),
        ("punch and die", &[Punch, Die]),
        ("Gegenhalter, counter-punch, OP10_PAD, Auswerfer 2, éjecteur", &[Pad]),
        ("Stempelhalter, Radien, centre line, blank, ring", &[]),
    ] {
        texts.split(", ").for_each(|text| assert_eq!(Role::named_in(text), roles, "{text}"));
    }
}
