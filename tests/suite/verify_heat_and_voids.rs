//! Temperature and voids in whole runs: closed forms, balances, and the plain result where neither is there.

use crate::common::prelude::*;
use crate::voids::rates;
use stampflow::material::thermal::Exponential;

/// ρ c of aluminium, 2700 kg/m³ × 900 J/(kg K) [MPa/K].
const CAPACITY: f64 = 2.43;

fn flow(plastic_share: f64) -> HeatFlow {
    HeatFlow { capacity: CAPACITY, plastic_share, conductivity: 0.0, tools: vec![] }
}

fn heated(mut model: Model, initial: impl Into<PiecewiseLinear>, flow: Option<HeatFlow>) -> Model {
    model.heat = Some(Heat { initial: initial.into(), flow });
    model
}

fn softening() -> Option<ThermalLaw> {
    Some(ThermalLaw::Exponential(Exponential { coefficient: 0.003, reference: ROOM_TEMPERATURE }))
}

/// Trust: bookkeeping. β times the plastic work is what warms the sheet; sums of some hundred steps keep eleven digits.
#[test]
fn adiabatic_heating_keeps_the_energy() {
    for theory in [Theory::Bending, Theory::Membrane] {
        for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
            let mut model = heated(simple::pulled(geometry, theory, 8.0), 293.15, Some(flow(0.9)));
            model.material.thermal = softening();
            let run = solve(&model);
            let last = run.steps.last().expect("steps");
            let frame = run.frames.last().expect("a frame");
            let volume = model.extent().area(model.blank.length) * model.blank.thickness / frame.elements.len() as f64;
            let rise: f64 = frame.elements.iter().map(|e| e.temperature - 293.15).sum::<f64>();
            if geometry == Geometry::PlaneStrain {
                // Equal volumes: the sum over elements is the integral.
                let stored = CAPACITY * volume * rise;
                assert!((stored / (0.9 * last.work.plastic) - 1.0).abs() < 1e-10, "{stored} {}", last.work.plastic);
            }
            assert!((last.heat.stored / (0.9 * last.work.plastic) - 1.0).abs() < 1e-10);
            assert!(last.hottest > last.coldest - 1e-9 && last.hottest > 300.0, "{}", last.hottest);
        }
    }
}

/// Trust: closed form. In plane strain ε̄ = 2ε/√3 and dT = β σ_s exp(−b (T − T_r)) dε̄/(ρ c), hence
/// exp(b ΔT) = 1 + b β/(ρ c) ∫σ_s dε̄. The temperature is foreseen for the end of the step and the work is the trapezoidal
/// rule's; a lag of a step would miss 0.17 % with 100 steps. The first step, whose stress jumps, is tiny.
#[test]
fn adiabatic_softening_follows_its_closed_form() {
    let error = |max_step: f64| {
        let model = simple::pulled(Geometry::PlaneStrain, Theory::Membrane, 6.0);
        let mut model = heated(model, 293.15, Some(flow(0.9)));
        model.material.thermal = softening();
        model.settings = Settings { max_step, first_step: 1e-5, ..Settings::default() };
        let run = solve(&model);
        let strain = 2.0 / 3f64.sqrt() * (46.0 / 40.0_f64).ln();
        let n = 20_000;
        let h = strain / f64::from(n);
        let work: f64 = (0..n).map(|i| model.material.hardening.at((f64::from(i) + 0.5) * h).stress * h).sum();
        let rise = (1.0 + 0.003 * 0.9 / CAPACITY * work).ln() / 0.003;
        (run.steps.last().expect("steps").hottest - 293.15) / rise - 1.0
    };
    let (coarse, fine) = (error(0.04), error(0.01));
    let row = "closed form of an exponential law | {} % with 25 steps, {} % with 100 |";
    agrees(row, &signed(&[coarse, fine], 3));
    assert!(coarse.abs() < 4e-4 && fine.abs() < 1e-4, "{coarse} {fine}");
}

/// Trust: the definition. A sheet at 150 °C is exp(−0.003 × 130) times as strong; everything scales with it. A field over
/// the blank gives every element the value at its middle.
#[test]
fn a_given_temperature_scales_the_strength() {
    let model = simple::pulled(Geometry::PlaneStrain, Theory::Bending, 6.0);
    let cold = solve(&model).steps.last().expect("steps").edge_force;
    let mut warm = heated(model.clone(), 423.15, None);
    warm.material.thermal = softening();
    let force = solve(&warm).steps.last().expect("steps").edge_force;
    assert!((force / cold / (-0.39f64).exp() - 1.0).abs() < 1e-9, "{force} {cold}");
    let field = PiecewiseLinear::new(vec![(10.0, 300.0), (30.0, 400.0)]).expect("rising");
    for e in &solve(&heated(model, field, None)).frames[0].elements {
        assert!((e.temperature - (300.0 + 5.0 * (e.s0 - 10.0)).clamp(300.0, 400.0)).abs() < 1e-9, "{e:?}");
    }
}

/// A strip that stands still between a die and a holder whose temperatures are given. It bends: a membrane buckles where it is
/// free, for the tools squeeze the sheet between them outward.
fn pressed(seconds: f64, conductivity: f64, transfer: f64, initial: impl Into<PiecewiseLinear>) -> Model {
    let mut model = simple::pulled(Geometry::PlaneStrain, Theory::Bending, 1.0);
    let tool = |role, profile, motion| Tool { role, profile, friction: 0.1.into(), motion };
    model.blank.edge = Edge::Clamped;
    model.blank.elements = 80;
    model.tools = vec![
        tool(Role::Die, Profile::die(4.0, 1.0, 1.0), Motion::Fixed),
        tool(Role::Holder, Profile::holder(5.0, 1.0), Motion::Pressed(Press::constant(800.0))),
    ];
    model.speed = 1.0 / seconds;
    (model.duration, model.frames) = (seconds, vec![seconds]);
    model.travel = 0.0;
    let tools = [Role::Die, Role::Holder].map(|role| ToolHeat { role, temperature: 293.15, transfer }).to_vec();
    heated(model, initial, Some(HeatFlow { conductivity, tools, ..flow(0.0) }))
}

/// Trust: closed form T = T_tool + ΔT exp(−2 h t/(ρ c s)) for a sheet of thickness s between two tools; backward Euler
/// with 100 steps of 1/50 of the time constant lags by 1 %.
#[test]
fn a_sheet_between_two_tools_cools_as_by_hand() {
    let transfer = 1.4; // 1.4 kW/(m² K) = 1.4 N/(mm s K)
    let run = solve(&pressed(2.0 * CAPACITY / (2.0 * transfer), 0.0, transfer, 493.15));
    let last = run.steps.last().expect("steps");
    let middle = run.frames[0].elements.iter().find(|e| e.s0 > 20.0).expect("an element");
    let exact = 293.15 + 200.0 * (-2.0f64).exp();
    let row = "{} K off, of 200 K, after two time constants with 100 steps; heat balance 1e-9 |";
    agrees(row, &plain(&[(middle.temperature - exact).abs()], 1));
    assert!((middle.temperature - exact).abs() < 0.01 * 200.0 * 2.0 * (-2.0f64).exp() + 0.3, "{}", middle.temperature);
    assert!((last.heat.stored / last.heat.tools - 1.0).abs() < 1e-9, "{:?}", last.heat);
    assert!(last.heat.tools < 0.0 && last.heat.plastic == 0.0);
}

/// Trust: closed form. A cosine of temperature along an insulated strip decays with exp(−k π² t/(ρ c L²)); 80 elements and
/// 100 steps keep it within 1 % of what has decayed. Two-node elements are of second order in their length, backward Euler of
/// first in the step.
#[test]
fn heat_is_conducted_along_the_sheet() {
    let conductivity = 130.0; // W/(m K) = N/(s K)
    let rate = conductivity / CAPACITY * (PI / 40.0).powi(2);
    let cosine = |s: f64| 400.0 + 50.0 * (PI * s / 40.0).cos();
    let points = (0..=400).map(|i| (0.1 * f64::from(i), cosine(0.1 * f64::from(i)))).collect();
    let mut model = pressed(1.0 / rate, conductivity, 0.0, PiecewiseLinear::new(points).expect("rising"));
    let run = solve(&model);
    for e in &run.frames[0].elements {
        let exact = 400.0 + (cosine(e.s0) - 400.0) * (-1.0f64).exp();
        assert!((e.temperature - exact).abs() < 0.01 * 50.0, "{} {exact}", e.temperature);
    }
    let heat = run.steps.last().expect("steps").heat;
    assert!(heat.stored.abs() < 1e-9 * 50.0 * CAPACITY * 40.0 * 2.0 / PI, "{heat:?}");

    let mut error = |elements: usize, step: f64| {
        model.blank.elements = elements;
        model.settings = Settings { max_step: step, first_step: step, ..Settings::default() };
        let e = solve(&model).frames[0].elements[0];
        (e.temperature - 400.0) / ((cosine(e.s0) - 400.0) * (-1.0f64).exp()) - 1.0
    };
    // What the steps leave is the same on every mesh, and the other way round.
    let in_space = orders_of_changes(&[10, 20, 40].map(|elements| error(elements, 2e-3)));
    let in_time = orders(&[4.0, 2.0, 1.0], &[0.02, 0.01, 0.005].map(|step| error(400, step)));
    assert!((in_space[0] - 2.0).abs() < 0.1, "{in_space:?}");
    assert!(in_time.iter().all(|p| (p - 1.0).abs() < 0.1), "{in_time:?}");
}

#[test]
fn a_temperature_that_does_not_matter_changes_nothing() {
    let model = simple::pulled(Geometry::Axisymmetric, Theory::Bending, 6.0);
    let plain = solve(&model);
    for heat in [(293.15, None), (500.0, None), (500.0, Some(flow(0.9)))] {
        let run = solve(&heated(model.clone(), heat.0, heat.1.clone()));
        assert_eq!(run.steps.len(), plain.steps.len());
        for (a, b) in run.steps.iter().zip(&plain.steps) {
            assert_eq!((a.edge_force, a.thinnest, a.iterations), (b.edge_force, b.thinnest, b.iterations));
        }
    }
    let mut soft = heated(model, ROOM_TEMPERATURE, None);
    soft.material.thermal = softening();
    assert_eq!(solve(&soft).steps.last().expect("steps").edge_force, plain.steps.last().expect("steps").edge_force);
}

/// Without voids the voided law gives the plain run to 1e-12 (it adds the same numbers in another order; the corrector
/// accepts at 1e-5, and both go through the same iterations).
#[test]
fn no_porosity_gives_the_plain_run() {
    for (geometry, theory) in [(Geometry::Axisymmetric, Theory::Bending), (Geometry::PlaneStrain, Theory::Membrane)] {
        let model = simple::pulled(geometry, theory, 6.0);
        let plain = solve(&model);
        let mut voided = model;
        voided.material.gtn = Some(Gtn { initial: 0.0, nucleation: None, coalescence: None, ..Gtn::example() });
        for (a, b) in solve(&voided).steps.iter().zip(&plain.steps) {
            assert!((a.edge_force / b.edge_force - 1.0).abs() < 1e-12, "{} {}", a.edge_force, b.edge_force);
            assert!((a.thinnest / b.thinnest - 1.0).abs() < 1e-12);
            assert_eq!(a.porosity, 0.0);
        }
    }
}

/// Trust: the equation of equi-biaxial Gurson flow integrated on its own. The run reckons with a
/// porosity foreseen from the last step: second order. The thickness has the volume of the voids that the step's end found:
/// ln(t/t₀) = −2 ε + ∫ ε̇_kk.
#[test]
fn a_pulled_disc_grows_its_voids_as_integrated() {
    let voids = Gtn::example();
    let mut model = simple::pulled(Geometry::Axisymmetric, Theory::Membrane, 12.0);
    model.material.gtn = Some(voids);
    model.settings = Settings { max_step: 5e-4, first_step: 5e-4, ..Settings::default() };
    let run = solve(&model);
    let last = run.steps.last().expect("steps");

    let rates = |f: f64, strain: f64| rates(&voids, f, strain, [1.0, 1.0, 0.0]);
    let steps = 20_000;
    let end = (52.0 / 40.0_f64).ln();
    let h = end / f64::from(steps);
    let (mut f, mut strain, mut volume) = (voids.initial, 0.0, 0.0);
    for _ in 0..steps {
        let k = rates(f, strain);
        let k = rates(f + 0.5 * h * k[0], strain + 0.5 * h * k[1]);
        (f, strain, volume) = (f + h * k[0], strain + h * k[1], volume + h * k[2]);
    }
    assert!((last.porosity - f).abs() < 1e-9, "{} {f}", last.porosity);
    let force = |step: f64| {
        let mut model = model.clone();
        model.settings = Settings { max_step: step, first_step: step, tolerance: 1e-9, ..Settings::default() };
        solve(&model).steps.last().expect("steps").edge_force
    };
    let orders = orders_of_changes(&[8e-3, 4e-3, 2e-3, 1e-3].map(force));
    assert!(orders.iter().all(|p| (p - 2.0).abs() < 0.1), "{orders:?}");
    assert!((last.thinnest / (volume - 2.0 * end).exp() - 1.0).abs() < 1e-8);
    let middle = run.frames[0].elements[3];
    assert!((middle.strain_thickness - middle.thickness.ln()).abs() < 1e-9, "{middle:?}");
    assert!((middle.strain_equivalent - strain).abs() < 1e-5, "{middle:?} {strain}");
}

#[test]
fn coalescence_ends_the_run() {
    let mut model = simple::pulled(Geometry::Axisymmetric, Theory::Membrane, 30.0);
    model.material.gtn = Some(Gtn { initial: 0.08, ..Gtn::example() });
    model.stop.localised = false;
    let run = solver::run(&model, &mut ());
    assert_eq!(run.stop.kind, StopKind::Coalesced);
    assert!(run.stop.is_physical() && run.frames.len() == 1);
}
