//! The elastoplastic law against closed forms, other programs and the flow law.

use crate::common::prelude::*;
use stampflow::material::elastoplastic::{Carried, ElastoplasticLaw, Operators, Trial};

/// Incompressible in its elasticity too: only then does plane strain yield at (2/√3) Y and stay there, as the closed forms
/// of an elastic-perfectly plastic strip assume.
const STRIP: Elastic = Elastic { young: 200_000.0, poisson: 0.5 };
const STEEL: Elastic = Elastic { young: 206_000.0, poisson: 0.3 };
const YIELD: f64 = 250.0;
const T: f64 = 1.2;
const LENGTH: f64 = 0.7;

/// A plane-strain element that is strained step by step.
struct Strip {
    points: Vec<Carried>,
    layers: Vec<ThicknessPoint>,
}

impl Strip {
    fn new(layers: usize) -> Self {
        let point = Carried { temperature: ROOM_TEMPERATURE, ..Carried::default() };
        Self { points: vec![point; layers], layers: lobatto(layers) }
    }

    /// Adds a membrane strain and a curvature [1/mm]; the force and the moment per mm of depth that go with them. The
    /// element is set back to its place each time, so that the closed forms' small strains hold.
    fn strain(&mut self, strain: f64, curvature: f64) -> [f64; 2] {
        let hardening = Hardening::Ludwik(Ludwik::new(YIELD, 0.0, 1.0).expect("valid"));
        let point = ElastoplasticLaw {
            hardening: Some(&hardening),
            operators: Operators::new(STRIP, YieldCriterion::default()),
            kinematic: None,
            rate: None,
            softening: None,
            secant: false,
            duration: 1.0,
        };
        let start = Reference::new(Geometry::PlaneStrain, Theory::Bending, [3.0, 0.0, 0.0], [3.0 + LENGTH, 0.0, 0.0]);
        let half = 0.5 * curvature * LENGTH;
        let end = start.moved([0.0, 0.0, -half], [strain.exp_m1() * LENGTH, 0.0, half]).expect("sound");
        let n = self.layers.len();
        for at in &mut self.points {
            at.yield_stress = point.yield_stress(at);
        }
        let mut trials = vec![Trial::default(); n];
        let mut responses = vec![StressUpdate::default(); n];
        let section =
            Section { law: &point, rule: &self.layers, slack_tension: 0.0, last_move: 0.0, forces_alone: false };
        let (force, _) = section.internal(&end, start.area() * T, T, &self.points, &mut trials, &mut responses);
        for (at, response) in self.points.iter_mut().zip(&responses) {
            at.stress = response.stress;
            at.strain += response.increment;
        }
        [force[3] * strain.exp(), force[5]]
    }
}

/// S = (2/√3) Y, E' = E/(1 − ν²), and the curvature at which the faces yield.
fn strip() -> (f64, f64, f64) {
    let s = 2.0 / 3f64.sqrt() * YIELD;
    let modulus = STRIP.young / (1.0 - STRIP.poisson * STRIP.poisson);
    (s, modulus, 2.0 * s / (modulus * T))
}

/// Largest miss of the moment over curvatures of 1.05 to 50 times that of first yield, and of the curvature that is left
/// once the moment is taken away, both over what they should be [–].
fn bending(layers: usize) -> (f64, f64) {
    let (s, modulus, first) = strip();
    let inertia = T * T * T / 12.0;
    let (mut moment_miss, mut left_miss): (f64, f64) = (0.0, 0.0);
    for k in 0..60 {
        let curvature = 1.05 * (50.0f64 / 1.05).powf(k as f64 / 59.0) * first;
        let [_, moment] = Strip::new(layers).strain(0.0, curvature);
        let exact = s * T * T / 4.0 * (1.0 - (first / curvature).powi(2) / 3.0);
        moment_miss = moment_miss.max((moment / exact - 1.0).abs());
        let back = |moment: f64| moment / (modulus * inertia);
        left_miss = left_miss.max(((back(moment) - back(exact)) / back(exact)).abs());
    }
    (moment_miss, left_miss)
}

/// Trust: the closed form of an elastic-perfectly plastic strip, M = S t²/4 (1 − (κ_e/κ)²/3), and its spring-back M/(E'I).
#[test]
fn bending_and_unbending_converge_with_the_layers() {
    let layers = [5, 9, 15, 25, 35, 51];
    let misses = layers.map(|n| (n, bending(n).0, bending(n).1));
    let told = misses.map(|(layers, moment, left)| format!("{:.2} % with {layers}", 100.0 * moment.max(left)));
    agreement(
        "bending of an elastic-perfectly plastic strip (ν = 0.5, as the closed form assumes), curvatures of 1.05 to 50 times \
         first yield: largest miss of moment and spring-back, by the points through the thickness",
        &[told.join(", ")],
    );
    for misses in [misses.map(|m| m.1), misses.map(|m| m.2)] {
        // Trust: a rule's error at the corner of the stress goes with the square of its points' distance.
        let orders = orders(&layers.map(|n| 1.0 / n as f64), &misses);
        assert!(orders.iter().all(|p| (1.9..2.35).contains(p)), "{orders:?}");
    }
    assert!(misses[5].1 < 0.005, "{misses:?}");
}

/// Trust: the same closed form. Residual stress is that of the bent strip less the elastic line Mζ/I; bending back to
/// where it was flat yields it the other way.
#[test]
fn residual_stress_and_reverse_bending_are_the_closed_form() {
    let (s, modulus, first) = strip();
    let layers = 51;
    let mut strip = Strip::new(layers);
    let curvature = 6.0 * first;
    let [_, moment] = strip.strain(0.0, curvature);
    let [force, rest] = strip.strain(0.0, -moment / (modulus * T * T * T / 12.0));
    assert!(force.abs() < 1e-9 * s * T && rest.abs() < 1e-9 * moment, "{force} {rest}");
    // The element's moment is the exact one within the rule's error; so then is the elastic line.
    let exact = s * T * T / 4.0 * (1.0 - 1.0 / 36.0 / 3.0);
    for (point, layer) in strip.points.iter().zip(&strip.layers) {
        let zeta = 0.5 * T * layer.xi;
        let bent = (modulus * curvature * zeta).clamp(-s, s);
        let expected = bent - 12.0 * exact * zeta / (T * T * T);
        assert!((point.stress[0] - expected).abs() < 0.005 * s, "{zeta}: {} {expected}", point.stress[0]);
    }
    // Turned back by 2 κ from the fully bent state the strip is the mirror image of a virgin one bent by κ' = κ of twice
    // the yield stress: M = M_bent − ΔM, ΔM of a strip of 2 S.
    let mut strip = Strip::new(layers);
    let [_, bent] = strip.strain(0.0, curvature);
    let back = 1.5 * curvature;
    let [_, moment] = strip.strain(0.0, -back);
    let drop = 2.0 * s * T * T / 4.0 * (1.0 - (2.0 * first / back).powi(2) / 3.0);
    assert!((moment - (exact - drop)).abs() < 0.005 * bent, "{moment} {}", exact - drop);
}

/// Trust: M = S t²/4 (1 − (κ_e/κ)²/3) of a strip that is bent to a high ring and joined, δ = 2π r² M/(E′ I): within the rule's
/// error. What the element unbends by, until it bears no moment, opens a ring of that radius by as much: to round-off.
#[test]
fn a_strip_bent_to_a_ring_springs_open_by_its_moment() {
    let (s, modulus, first) = strip();
    for curvature in [1.5 * first, 4.0 * first, 10.0 * first] {
        let mut strip = Strip::new(51);
        let [_, moment] = strip.strain(0.0, curvature);
        let radius = 1.0 / curvature;
        let ring = CutRing { radius, thickness: T, height: 1e12, moment_hoop: moment, moment_meridional: 0.5 * moment };
        let opening = ring.opening(STRIP);
        let [_, rest] = strip.strain(0.0, -opening / (TAU * radius * radius));
        assert!(rest.abs() < 1e-9 * moment, "{curvature}: {rest} of {moment}");
        let exact = s * T * T / 4.0 * (1.0 - (first / curvature).powi(2) / 3.0);
        let closed = TAU * radius * radius * exact / (modulus * T.powi(3) / 12.0);
        assert!((opening / closed - 1.0).abs() < 0.005, "{curvature}: {opening} {closed}");
    }
}

/// Trust: stress of an elastic-perfectly plastic strip under ε₀ + κζ, by hand between the places where it yields.
#[test]
fn bending_under_tension_is_the_closed_form() {
    let (s, modulus, first) = strip();
    let mut worst: f64 = 0.0;
    for curvature in [2.0, 5.0, 12.0].map(|k| k * first) {
        for share in [0.1, 0.4, 0.8] {
            // The neutral line lies at −share t/2 from the middle.
            let [force, moment] = Strip::new(51).strain(curvature * share * 0.5 * T, curvature);
            let elastic = s / (modulus * curvature);
            let neutral = -share * 0.5 * T;
            let (low, high) = ((neutral - elastic).max(-0.5 * T), (neutral + elastic).min(0.5 * T));
            let slope = modulus * curvature;
            let expected_force = -s * (low + 0.5 * T)
                + slope * (0.5 * (high * high - low * low) - neutral * (high - low))
                + s * (0.5 * T - high);
            let expected_moment = -s * 0.5 * (low * low - 0.25 * T * T)
                + slope * ((high.powi(3) - low.powi(3)) / 3.0 - neutral * 0.5 * (high * high - low * low))
                + s * 0.5 * (0.25 * T * T - high * high);
            let scale = [s * T, s * T * T / 4.0];
            worst = worst.max((force - expected_force).abs() / scale[0]);
            worst = worst.max((moment - expected_moment).abs() / scale[1]);
        }
    }
    agreement("bending under tension of the same strip", &[format!("within {:.2} % with 51 layers", 100.0 * worst)]);
    assert!(worst < 0.01, "{worst}");
}

/// Trust: closed form, Poisson's contraction ε_t = −ν/(1−ν) ε_s of a wide strip; the strains of a step sum up to round-off.
#[test]
fn a_wide_elastic_strip_contracts_by_poisson() {
    for theory in [Theory::Bending, Theory::Membrane] {
        let travel = 0.01;
        let mut model = simple::pulled(Geometry::PlaneStrain, theory, travel);
        (model.mode, model.material.elastic) = (Mode::ElastoViscoplastic, Some(STEEL));
        let run = solve(&model);
        let strain = f64::ln_1p(travel / 40.0);
        for (t, dilation) in run.end.thickness.iter().zip(&run.end.dilation) {
            assert!((t.ln() + 0.3 / 0.7 * strain).abs() < 1e-9 * strain, "{theory:?}: {t}");
            assert!((dilation - 0.4 / 0.7 * strain).abs() < 1e-9 * strain, "{theory:?}: {dilation}");
        }
    }
}

/// Trust: closed form of a disc that is stretched alike in all directions, F = 2πr t σ_y(ε̄) on the thickness
/// t = t₀ exp(−2ε + ln J): yield by Cauchy's stress. J lags by a step of a hundredth, in which the stress rises by less than
/// a hundredth: 1e-2 of ln J.
#[test]
fn a_disc_stretched_alike_carries_the_yield_stress_on_its_section() {
    let (mut worst, mut ln_j) = (0.0_f64, 0.0);
    for theory in [Theory::Bending, Theory::Membrane] {
        let mut model = simple::pulled(Geometry::Axisymmetric, theory, 4.0);
        let elastic = Elastic { young: 69_000.0, poisson: 0.3 };
        (model.mode, model.material.elastic) = (Mode::ElastoViscoplastic, Some(elastic));
        let run = solve(&model);
        let strain = f64::ln_1p(4.0 / 40.0);
        let (mut volume, mut yields) = (0.0f64, 0.0);
        for _ in 0..50 {
            let stress = volume.exp() * yields;
            let plastic = 2.0 * (strain - (1.0 - elastic.poisson) / elastic.young * stress);
            yields = model.material.hardening.at(plastic).stress;
            volume = elastic.volume_strain([stress, stress, 0.0]);
        }
        let thickness = (volume - 2.0 * strain).exp();
        let lag = 1e-2 * volume;
        for t in &run.end.thickness {
            assert!((t / thickness - 1.0).abs() < lag, "{theory:?}: {t} {thickness}");
        }
        let force = std::f64::consts::TAU * 44.0 * thickness * yields;
        let found = run.steps.last().expect("steps").edge_force;
        assert!((found / force - 1.0).abs() < lag, "{theory:?}: {found} {force}");
        worst = worst.max((found / force - 1.0).abs()).max((run.end.thickness[0] / thickness - 1.0).abs());
        ln_j = volume;
    }
    agrees(
        "on the section t₀ exp(−2ε + ln J), ln J = {} % | within {} % |",
        &[plain(&[100.0 * ln_j], 2), at_most(worst)].concat(),
    );
}

/// A clamped elastic disc under a small pressure; its deflection in the middle [mm].
fn deflection(elements: usize, length: f64, pressure: f64) -> f64 {
    let mut model = simple::pulled(Geometry::Axisymmetric, Theory::Bending, 1.0);
    model.blank = Blank { length, elements, edge: Edge::Clamped, ..model.blank };
    model.travel = 0.0;
    (model.mode, model.material.elastic) = (Mode::Elastic, Some(STEEL));
    model.gas = vec![Gas { face: Face::Lower, pressure: pressure.into(), within: length }];
    solve(&model).frames.last().expect("frames").nodes[0].z
}

/// Trust: the clamped plate, w = p a⁴/(64 D) + p a²/(4 k G t) with the shear of Mindlin's plate; at a hundred thousandth of
/// the thickness the stretching of the middle is felt by 1e-10.
#[test]
fn clamped_elastic_plate_converges_to_the_closed_form_in_second_order() {
    let (a, t, e, nu) = (40.0f64, 1.0, 206_000.0, 0.3);
    let d = e * t * t * t / (12.0 * (1.0 - nu * nu));
    let shear = 5.0 / 6.0 * e / (2.0 * (1.0 + nu)) * t;
    let p = 1e-5 * t * 64.0 * d / (a * a * a * a);
    let exact = p * a.powi(4) / (64.0 * d) + p * a * a / (4.0 * shear);
    let misses = [10, 20, 40].map(|n| deflection(n, a, p) / exact - 1.0);
    agreement("clamped elastic plate", &[format!("{} with 10, 20, 40 elements: second order", percent(&misses, 2))]);
    let orders = orders(&[4.0, 2.0, 1.0], &misses);
    assert!(orders.iter().all(|p| (p - 2.0).abs() < 0.1), "{orders:?}");
    assert!(misses[2].abs() < 0.002, "{misses:?}");
}

/// Complete elliptic integrals of the first and second kind K(k), E(k), by the arithmetic-geometric mean.
fn elliptic(k: f64) -> (f64, f64) {
    let (mut a, mut b, mut c, mut weight, mut sum) = (1.0, (1.0 - k * k).sqrt(), k, 0.5, 0.0);
    while c.abs() > 1e-16 {
        sum += weight * c * c;
        (a, b, c) = (0.5 * (a + b), (a * b).sqrt(), 0.5 * (a - b));
        weight *= 2.0;
    }
    let first = std::f64::consts::FRAC_PI_2 / a;
    (first, first * (1.0 - sum))
}

/// A strip whose two edges are held upright and pushed together until it has buckled so far that it stands at 60°, misses
/// of its force and of its deflection: each quarter is a cantilever with a dead load that presses on its tip.
fn elastica(elements: usize) -> [f64; 2] {
    let (length, k) = (100.0, 30f64.to_radians().sin());
    let (first, second) = elliptic(k);
    let quarter = 0.5 * length;
    let shortened = 2.0 * quarter * (2.0 - 2.0 * second / first);
    let mut model = simple::pulled(Geometry::PlaneStrain, Theory::Bending, shortened);
    model.blank = Blank { length, elements, edge: Edge::Pulled { speed: -1.0 }, ..model.blank };
    (model.mode, model.material.elastic) = (Mode::Elastic, Some(STEEL));
    // A breath of pressure tells it which way to go, and fades.
    let pressure = PiecewiseLinear::new(vec![(0.0, 0.02), (shortened, 0.0)]).expect("valid");
    model.gas = vec![Gas { face: Face::Upper, pressure: pressure.into(), within: length }];
    let run = solve(&model);
    let stiffness = 206_000.0 / (1.0 - 0.09) / 12.0;
    // Of one of both edges.
    let force = -0.5 * run.steps.last().expect("steps").edge_force / (stiffness * (first / quarter).powi(2));
    let deflection = run.frames.last().expect("frames").nodes[0].z / (4.0 * k * quarter / first);
    [force - 1.0, deflection.abs() - 1.0]
}

/// Trust: the elastica (as given by S. P. Timoshenko, J. M. Gere, Theory of Elastic Stability, section 2.7; not read), with
/// slopes of 60° and a deflection of sixty thicknesses. It does not stretch or shear; the strip does, by 2e-4, to which it
/// converges in second order.
#[test]
fn a_strip_that_turns_by_sixty_degrees_is_the_elastica() {
    let misses = [20, 40, 80].map(elastica);
    let [force, deflection] = [0, 1].map(|i| percent(&misses.map(|miss| miss[i]), 2));
    agreement(
        "the elastica: a strip pushed together until it stands at 60°, deflection of 60 thicknesses",
        &[format!("force {force}, deflection {deflection} with 20, 40, 80 elements")],
    );
    for i in 0..2 {
        let order = orders_of_changes(&misses.map(|miss| miss[i]))[0];
        assert!((order - 2.0).abs() < 0.1, "{order}: {misses:?}");
        assert!(misses[2][i].abs() < 1e-3, "{misses:?}");
    }
}

fn force_at(run: &StageSolution, travel: f64) -> f64 {
    let after = run.steps.iter().position(|r| r.travel >= travel).expect("reached");
    let (b, a) = (&run.steps[after], &run.steps[after.max(1) - 1]);
    let share = if b.travel > a.travel { (travel - a.travel) / (b.travel - a.travel) } else { 1.0 };
    a.punch_force + share * (b.punch_force - a.punch_force)
}

/// Trust: a continuum model of the same stretch in another program (numerical cross-check, see the file's head); 1 % is
/// what shells and solids of this t/R differ by.
#[test]
fn thin_stretch_follows_the_continuum() {
    let model = shipped("stretch_thin", &[]);
    let flow = solve(&model);
    let run = solve(&Model { mode: Mode::ElastoViscoplastic, ..model });
    let points = numbers(include_str!("../../reference_data/stretch_solid_fe.csv"));
    let judged = points.iter().filter(|[travel, _]| (2.6..=33.0).contains(travel));
    let miss = |&[travel, force]: &[f64; 2]| (travel, 100.0 * (force_at(&run, travel) / force - 1.0));
    let misses: Vec<(f64, f64)> = judged.map(miss).collect();
    let within = |from: f64| {
        let far = misses.iter().filter(|(travel, _)| *travel >= from).map(|(_, miss)| *miss);
        let (least, most) = far.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), miss| (a.min(miss), b.max(miss)));
        percent(&[0.01 * least, 0.01 * most], 1).replace(", ", " to ")
    };
    agreement(
        "`stretch_thin`, elastoplastic law against the continuum from 2.6 to 33 mm",
        &[format!("{}, from 7 mm on {}", within(0.0), within(7.0))],
    );
    // The flow law has no elasticity: how much that is, at the continuum's point next to a travel.
    let stiffer = |near: f64| {
        let next = points.iter().min_by(|a, b| (a[0] - near).abs().total_cmp(&(b[0] - near).abs()));
        let &[travel, force] = next.expect("points");
        (travel, force_at(&flow, travel) / force - 1.0)
    };
    let on_the_way = [5.4, 9.5, 13.5, 20.7, 29.9, 33.9].map(stiffer);
    let figures = on_the_way.map(|(travel, share)| [signed(&[share], 1), plain(&[travel], 1)].concat()).concat();
    agrees(
        "in `stretch_thin`: {} % at {} mm of travel, {} % at {}, {} % at {}, {} % at {}, {} % at {}, {} % at {}. That",
        &figures,
    );
    assert!(misses.len() > 20 && misses.iter().all(|(_, miss)| miss.abs() < 1.0), "{misses:.2?}");
}

/// Trust: once the sheet is plastic everywhere elasticity is a detail: 2 % beyond a third of the travel. The elastoplastic law has the
/// points through the thickness that it needs to stand: with few of them the moment of an element falls in jumps.
#[test]
fn elastoplastic_law_and_flow_law_agree_on_drawn_cups() {
    let mut largest = Vec::new();
    for name in ["woo_hemispherical", "chalmers_cup"] {
        let model = shipped(name, &["blank.layers=15"]);
        let elastoplastic = solve(&Model { mode: Mode::ElastoViscoplastic, ..model.clone() });
        let flow = solve(&model);
        let travel = flow.steps.last().expect("steps").travel;
        let difference = |x: f64| force_at(&flow, x) / force_at(&elastoplastic, x) - 1.0;
        let differences = (0..=40).map(|k| (1.0 + k as f64 / 20.0) / 3.0 * travel).map(|x| (x, difference(x)));
        let (at, worst) = differences.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).expect("some");
        assert!(worst.abs() < 0.02, "{name}: {worst} at {at}");
        largest.push(worst);
        for run in [&flow, &elastoplastic] {
            assert!(run.steps.last().expect("steps").work.imbalance().abs() < 0.002, "{name}");
        }
    }
    agrees("15 layers | Woo {} % at most, Chalmers {} % |", &signed(&largest, 1));
}

/// The opening angle of the bent strip before and after it is let go [°].
fn opening(overrides: &[&str]) -> [f64; 2] {
    let passes = solver::solve(&shipped_case("cylindrical_bending", overrides).stages, &mut ());
    assert!(passes.len() == 2 && passes.iter().all(|pass| pass.stop.is_complete()), "{overrides:?}");
    let angle = |pass: &StageSolution| Shape::of(pass.frames.last().expect("frames")).opening_angle().expect("a wall");
    [angle(&passes[0]), angle(&passes[1])]
}

/// Trust: two published codes, which differ by 1.4° before and 2.9° after the release; 1.5° beyond them is half of what they
/// differ by. Other elements and points change it by less than they do.
#[test]
fn cylindrical_bending_springs_back_as_in_two_published_codes() {
    let text = include_str!("../../reference_data/cylindrical_bending_nafems.csv");
    let row = text.lines().find(|line| line.starts_with("0.0,")).expect("the frictionless row");
    let values: Vec<f64> = row.split(',').map(|v| v.parse().expect("a number")).collect();
    let angles = opening(&[]);
    for (angle, pair) in angles.iter().zip([&values[1..3], &values[3..5]]) {
        let (low, high) = (pair[0].min(pair[1]), pair[0].max(pair[1]));
        assert!((low - 1.5..=high + 1.5).contains(angle), "{angles:?}");
    }
    let others = [["blank.elements=320"], ["blank.layers=15"]].map(|other| opening(&other));
    assert!(others.iter().all(|other| (0..2).all(|i| (other[i] - angles[i]).abs() < 0.8)), "{others:?}");
    let published = [[1, 2], [3, 4]].map(|[a, b]| [values[a].min(values[b]), values[a].max(values[b])]).concat();
    agrees(
        "| {}° and {}°; two published codes {}° to {}° and {}° to {}°. 320 elements: {}°; 15 points: {}°.",
        &plain(&[&angles[..], &published[..], &others.map(|other| other[1])[..]].concat(), 1),
    );
}
