//! Verification of contact, friction laws, holders, beads and gas against closed forms and against each other.

use crate::common::prelude::*;
use crate::observer::Stopper;
use stampflow::{contact::friction::Sliding, model::PressureCap};

/// Shear yield stress of the rope's material, Y = 150 MPa [MPa].
const K: f64 = 86.602_540_378_443_86;

/// Tension of a rope behind an arc of radius `rho` that it passes at the speed `v`, where it was `tension` before the
/// angle `wrap`: dT/dθ = ρ τ(T/ρ), integrated for each law [N/mm].
fn behind_arc(law: &Friction, tension: f64, rho: f64, wrap: f64, v: f64) -> f64 {
    match law {
        Friction::Coulomb(law) => tension * (law.coefficient * wrap).exp(),
        Friction::PressureDependent(law) => {
            let a = 1.0 - law.exponent;
            (tension.powf(a) + a * law.coefficient * (law.reference * rho).powf(a) * wrap).powf(1.0 / a)
        }
        Friction::Stribeck(law) => tension * (law.coefficient(v) * wrap).exp(),
        Friction::Tresca(law) => {
            let full = rho * law.factor * K;
            let u = law.coefficient * tension / full;
            (u.sinh() * (law.coefficient * wrap).exp()).asinh() * full / law.coefficient
        }
    }
}

/// Trust: the capstan equation of each law, integrated in closed form. The rope is held back by a bead, and by hardly
/// more: a frictionless holder of 1 N/mm on each side keeps the flange on the die, whose friction under it is a percent of the bead's.
#[test]
fn capstan_with_every_friction_law() {
    let (restraint, rho) = (60.0, 10.5);
    let mut errors = Vec::new();
    for (name, mut law) in Friction::examples() {
        // Weak shear yield and little back tension put Tresca's law in the middle of its passage.
        if let Friction::Tresca(law) = &mut law {
            (law.factor, law.coefficient) = (0.05, 0.15);
        }
        let mut model = simple::capstan(0.0, 2.0, 20);
        model.tools[1].friction = law;
        model.tools[2].friction = 0.0.into();
        model.beads = vec![Bead { at: 60.0, restraining: restraint.into(), closing: 0.0, round: None }];
        let run = solve(&model);
        let on_flange = |r: &StepRecord, v: f64| {
            let width = 120.0 - r.draw_in - 41.3;
            let at = Sliding { pressure: 1.0 / width, slip: v, scale: 0.01, duration: 1.0, shear_yield: K };
            width * law.at(&at).value
        };
        let ratios = run.steps.windows(2).filter(|w| w[1].travel > 40.0).map(|w| {
            let (dr, dz) = (41.3 - 20.0, w[1].travel - 21.0);
            let wrap = (21.0 / f64::hypot(dr, dz)).asin() + dz.atan2(dr);
            let v = (w[1].draw_in - w[0].draw_in) / (w[1].time - w[0].time);
            0.5 * w[1].punch_force / (behind_arc(&law, restraint + on_flange(&w[1], v), rho, wrap, v) * wrap.sin())
        });
        let error = mean(ratios) - 1.0;
        assert!(error.abs() < 5e-3, "{name}: {error:e}");
        errors.push((name, error));
    }
    let of = ["coulomb", "pressure_dependent", "stribeck", "tresca"]
        .map(|law| errors.iter().find(|(name, _)| *name == law).expect("a law of the family").1);
    assert_eq!(errors.len(), of.len(), "the page has a figure for every law");
    agrees("| Coulomb {} %, pressure-dependent {} %, Stribeck {} %, Tresca {} % |", &signed(&of, 2));
}

/// Trust: two methods for one problem. The penalty's foot, δ = 0.001 t, spreads the pressure at the ends of a bend, which
/// moves the peak in proportion to δ: by 0.3 to 0.7 % of cups over shoulders of six thicknesses; the augmented Lagrangian
/// takes that back.
#[test]
fn augmented_lagrangian_agrees_with_the_penalty() {
    let (mut changes, mut deep_steps) = (Vec::new(), 0);
    for name in DRAWN.split(' ').chain(["bulge"]) {
        let penalty = solve(&shipped(name, &[]));
        let augmented = solve(&shipped(name, &["solver.contact=augmented_lagrangian"]));
        let deepest = augmented.steps.iter().map(|r| r.penetration).fold(0.0, f64::max);
        let deep = augmented.steps.iter().filter(|r| r.penetration > Settings::PENETRATION).count();
        // Under gas alone the load is given: then the height that it makes is compared.
        let answer = |run: &StageSolution| if name == "bulge" { last(run).pole_height } else { peak(run) };
        let change = answer(&augmented) / answer(&penalty) - 1.0;
        // In a step or two of a hundred the rounds end first, at a tenth of what the penalty lets through.
        assert!(deep <= 2 && deepest <= 2e-3, "{name}: {deepest:e} in {deep} steps");
        assert!(change.abs() < 1e-2, "{name}: {change:e}");
        changes.push((name, change));
        deep_steps += deep;
    }
    let named = ["quickstart", "brite_cylindrical", "chalmers_cup"];
    let of = named.map(|name| changes.iter().find(|(case, _)| *case == name).expect("it is drawn").1);
    let most = |of: &[f64]| of.iter().fold(0.0_f64, |most, change| most.max(change.abs()));
    let others: Vec<f64> = changes.iter().filter(|(case, _)| !named.contains(case)).map(|change| change.1).collect();
    let figures = [vec![deep_steps.to_string()], at_most(most(&of)), signed(&of, 2), at_most(most(&others))];
    agrees(
        "below 1e-4 thicknesses, but for {} of all steps; peak within {} % (quickstart {}, brite {}, Chalmers {}, the others \
         within {}): the foot",
        &figures.concat(),
    );
}

#[test]
fn holder_models_hold_what_they_promise() {
    let force = |motion: Motion| {
        let mut model = shipped("quickstart", &[]);
        model.tools.iter_mut().find(|t| t.role == Role::Holder).expect("a holder").motion = motion;
        solve(&model)
    };
    let rising = PiecewiseLinear::new(vec![(0.0, 4e3), (12.0, 16e3), (20.0, 8e3)]).expect("rising");
    let run = force(Motion::Pressed(Press { force: rising.clone(), stiffness: 0.0 }));
    for r in &run.steps {
        // Trust: the corrector's residual, 1 % of the largest nodal force at worst.
        assert!((r.holder_force / rising.at(r.travel) - 1.0).abs() < 0.01, "{} at {}", r.holder_force, r.travel);
    }
    let (preload, stiffness) = (6e3, 50e3);
    let run = force(Motion::Pressed(Press { force: preload.into(), stiffness }));
    for r in &run.steps {
        let wanted = preload - stiffness * r.holder_move;
        assert!((r.holder_force / wanted - 1.0).abs() < 0.01, "{} {wanted}", r.holder_force);
    }
    // The flange thickens, pushes the springs back and meets more force.
    assert!(last(&run).holder_move < 0.0 && last(&run).holder_force > preload);

    let gap = 1.12;
    let run = force(Motion::Gap(gap));
    for r in &run.steps {
        assert_eq!(r.holder_move, run.steps[0].holder_move);
    }
    // At first the flange only leans on the holder; once it has thickened to the gap the load on the holder rises.
    assert!(last(&run).holder_force > 5.0 * run.steps[3].holder_force, "{}", last(&run).holder_force);
}

/// Trust: the pressure times the annulus between the end of the shoulder and the blank's edge, by hand.
#[test]
fn holder_pressure_acts_on_the_initial_area() {
    let text = include_str!("../../cases/quickstart.toml").replace("force = \"10 kN\" ", "pressure = \"2 MPa\" ");
    let model = parsed(&text, &[]).model().clone();
    let Motion::Pressed(press) = &model.tool(Role::Holder).expect("a holder").motion else { panic!("pressed") };
    let area = PI * (55.0_f64.powi(2) - 37.25_f64.powi(2));
    assert!((press.force.at(0.0) / (2.0 * area) - 1.0).abs() < 1e-9);
}

/// Trust: equilibrium of a strip drawn over a die without friction: on each side the punch feels the holder's friction,
/// 0.05 · 100 N/mm, and the bead's restraint, turned by the wrap, until the edge has passed the bead.
#[test]
fn bead_restrains_while_the_sheet_passes_it() {
    let mut model = simple::capstan(0.0, 200.0, 10);
    model.tools[0].friction = 0.0.into();
    model.tools[2].friction = 0.05.into();
    model.beads = vec![Bead { at: 100.0, restraining: 40.0.into(), closing: 0.0, round: None }];
    let run = solve(&model);
    let wall = |r: &StepRecord| {
        let (dr, dz) = (41.3 - 20.0, r.travel - 21.0);
        0.5 * r.punch_force / ((21.0 / f64::hypot(dr, dz)).asin() + dz.atan2(dr)).sin()
    };
    // The edge starts at 120 mm: 20 mm of draw-in bring it to the bead.
    for r in run.steps.iter().filter(|r| r.travel > 22.0 && r.draw_in < 16.0) {
        assert!((wall(r) / 45.0 - 1.0).abs() < 0.01, "{} N/mm at {} mm", wall(r), r.travel);
    }
    // As long as the holder has hold of its width: then its force fades. Single steps tick over the die's edge.
    let passed = run.steps.iter().filter(|r| r.draw_in > 21.0 && r.holder_force > 198.0);
    let walls: Vec<f64> = passed.map(wall).collect();
    let mean = mean(walls.iter().copied());
    assert!((mean / 5.0 - 1.0).abs() < 0.01, "{mean} N/mm");
    assert!(walls.iter().all(|wall| (wall / 5.0 - 1.0).abs() < 0.1), "{walls:?}");
    assert!(last(&run).draw_in > 21.0, "the edge has to pass the bead for this test to mean something");
    // What the bead takes is dissipated: the balance of power must see it.
    assert!(last(&run).work.imbalance().abs() < 0.01, "{}", last(&run).work.imbalance());
}

#[test]
fn closing_a_bead_takes_force_from_the_holder() {
    let mut model = shipped("quickstart", &[]);
    let closing = 10.0;
    model.beads = vec![Bead { at: 45.0, restraining: 0.0.into(), closing, round: None }];
    let first = &solve(&model).steps[5];
    let wanted = 10e3 - closing * 2.0 * PI * 45.0;
    assert!((first.holder_force / wanted - 1.0).abs() < 0.01, "{} {wanted}", first.holder_force);
}

/// Trust: a strip under gas pressure is a circular arc of one thickness (plane strain, σ = 2/√3 σ_y(2/√3 ε)), so height,
/// strain and pressure follow from each other; 40 straight elements miss the arc by 1/(6·40²).
#[test]
fn plane_strain_bulge_is_a_circular_arc() {
    let rising = PiecewiseLinear::new(vec![(0.0, 0.0), (10.0, 5.0)]).expect("rising");
    let run = solve(&simple::bulged(Geometry::PlaneStrain, Theory::Membrane, 40, rising.into()));
    let law = Hardening::Swift(Swift::new(520.0, 0.22, 1e-3).expect("valid"));
    let (a, factor) = (50.0_f64, 2.0 / 3f64.sqrt());
    let (mut compared, mut worst) = (0, 0.0_f64);
    for r in run.steps.iter().filter(|r| r.pole_height > 5.0) {
        let h = r.pole_height;
        let rho = (a * a + h * h) / (2.0 * h);
        let strain = (rho * (a / rho).asin() / a).ln();
        let pressure = factor * law.at(factor * strain).stress * (-strain).exp() / rho;
        assert!((r.pressure / pressure - 1.0).abs() < 2e-3, "{} against {pressure} at {h} mm", r.pressure);
        compared += 1;
        worst = worst.max((r.pressure / pressure - 1.0).abs());
    }
    assert!(compared > 20, "{compared} steps beyond 5 mm");
    let row = "| plane-strain bulge, a circular arc of one thickness | pressure within {} % at equal height |";
    agrees(row, &at_most(worst));
    assert!(last(&run).work.imbalance().abs() < 2e-3, "{}", last(&run).work.imbalance());
}

/// A flat sheet cannot bear a pressure at once: one pressure and no punch is raised over the run.
#[test]
fn one_pressure_alone_is_raised_over_the_run() {
    let model = shipped("bulge", &["gas.lower.pressure=5 MPa"]);
    assert_eq!(model.gas[0].pressure.prescribed(5.0), Some(2.5));
    let (raised, given) = (solve(&model), solve(&shipped("bulge", &[])));
    // Trust: rate-free, so the height at a pressure is the same however fast it came; linear between steps of 0.1 MPa.
    let after = given.steps.iter().find(|r| r.pressure >= 5.0).expect("it goes to 9.5 MPa");
    assert!((last(&raised).pole_height - after.pole_height).abs() < 0.5, "{}", last(&raised).pole_height);
}

/// Trust: for a sheet that is a linear fluid (m → 1) and stays a spherical cap, the mean thickness is 1/(1 + H²) by volume and
/// the pole's (sin α/α)², α = 2 atan H (Jovane 1968's assumption, exact only in that limit); H is height over radius. A
/// smaller m thins the pole more.
#[test]
fn superplastic_dome_holds_its_rate_and_follows_the_closed_forms() {
    let pole_error = |m: f64| {
        let overrides = [format!("material.rate.power.exponent={m}")];
        let run = solve(&shipped("superplastic_dome", &[&overrides[0]]));
        for r in &run.steps {
            // Trust: the corrector's tolerance; 1 % would be felt in the time of the cycle.
            assert!((r.held_rate / 1e-3 - 1.0).abs() < 1e-3, "{} at {} s", r.held_rate, r.time);
        }
        let frame = run.frames.last().expect("the end");
        let height = last(&run).pole_height / 50.0;
        let area: f64 =
            frame.nodes.windows(2).map(|w| PI * (w[0].r + w[1].r) * (w[1].r - w[0].r).hypot(w[1].z - w[0].z)).sum();
        let mean = PI * 50.0 * 50.0 / area;
        let cap = 1.0 / (1.0 + height * height);
        // Trust: how far a dome with a clamped rim and an uneven thickness is from a spherical cap, as measured: 2.5 %.
        assert!((mean / cap - 1.0).abs() < 0.04, "{mean} {cap}");
        let alpha = 2.0 * height.atan();
        [frame.elements[0].thickness / (alpha.sin() / alpha).powi(2) - 1.0, mean / cap - 1.0]
    };
    let found = [0.9, 0.6, 0.4].map(pole_error);
    let (errors, mean) = (found.map(|[pole, _]| pole), found.iter().fold(0.0_f64, |most, one| most.max(one[1].abs())));
    agrees(
        "pole within {} % of (sin α/α)² at m = 0.9, mean thickness within {} % of a spherical cap's",
        &[at_most(errors[0].abs()), at_most(mean)].concat(),
    );
    assert!(errors.is_sorted_by(|a, b| a > b), "{errors:?}");
    assert!(errors[0].abs() < 0.05, "{errors:?}");
}

/// Where the press gives less than the rate asks for, the pressure sits on its cap and the rate is below its target.
#[test]
fn a_capped_pressure_or_the_rate_is_at_its_limit_in_every_step() {
    for (largest, rise) in [(0.11, 2e-3), (0.2, 2e-3), (0.11, f64::INFINITY)] {
        let mut model = shipped("superplastic_dome", &[]);
        let Pressure::Rate(control) = &mut model.gas[0].pressure else { panic!("a held rate") };
        (control.max_pressure, control.max_rise) = (largest, rise);
        let run = solve(&model);
        let (mut pressure, mut time) = (0.0, 0.0);
        let mut seen = [0; 3];
        for r in &run.steps {
            let cap = f64::min(largest, pressure + rise * (r.time - time));
            let (rate, load) = (r.held_rate / 1e-3 - 1.0, r.pressure / cap - 1.0);
            // Trust: the corrector's tolerance for the rate, as without a cap; the cap's equation is linear, so round-off.
            assert!(rate < 1e-3 && load < 1e-9, "{rate:e} {load:e} at {} s", r.time);
            assert!(rate.abs() < 1e-3 || load.abs() < 1e-9, "{rate:e} {load:e} at {} s", r.time);
            assert_eq!(r.on_cap.is_some(), load.abs() < 1e-9, "{:?} {load:e} at {} s", r.on_cap, r.time);
            seen[r.on_cap.map_or(0, |cap| 1 + usize::from(cap == PressureCap::Rise))] += 1;
            (pressure, time) = (r.pressure, r.time);
        }
        assert!(seen[0] > 5 && seen[1] + seen[2] > 5, "{seen:?}");
        assert_eq!((seen[1] > 0, seen[2] > 0), (largest < 0.116, rise.is_finite()), "{seen:?}");
    }
}

/// Trust: plane strain with a uniform stress and no friction is a circular arc of one thickness. With the half-angle α and
/// the half-width a: t/t₀ = sin α/α, R = a/sin α, p = σ t/R, σ = (2/√3) K ε̄̇^m; and the rate is held, so
/// ln(α/sin α) = (√3/2) ε̄̇ time: pressure, thickness and height over time without a free number.
#[test]
fn superplastic_long_box_follows_its_closed_form_before_contact() {
    let (a, k, m, rate) = (50.0, 300.0, 0.6, 1e-3_f64);
    let worst_of = |elements: usize| {
        let text =
            include_str!("../../cases/superplastic_dome.toml").replace("radius = \"50 mm\"", "half_length = \"50 mm\"");
        let case = parsed(&text, &["geometry=plane_strain", &format!("blank.elements={elements}")]);
        let (mut worst, mut end): (f64, _) = (0.0, 0.0);
        for r in &solve(case.model()).steps {
            let strain = 3f64.sqrt() / 2.0 * rate * r.time;
            let [alpha, _] = bisect(0.0, PI / 1.01, 200, |alpha| (alpha / alpha.sin()).ln() <= strain);
            let (t, radius) = (alpha.sin() / alpha, a / alpha.sin());
            let pressure = 2.0 / 3f64.sqrt() * k * rate.powf(m) * t / radius;
            let height = radius * (1.0 - alpha.cos());
            for (found, exact) in [(r.pressure, pressure), (r.thinnest, t), (r.pole_height, height)] {
                worst = worst.max((found / exact - 1.0).abs());
            }
            assert!((r.thinnest / t - 1.0).abs() < 1e-6, "the thickness has no length in it");
            end = r.pole_height / height - 1.0;
        }
        (worst, end)
    };
    let found = [25, 50, 100].map(worst_of);
    let (errors, orders) = (found.map(|f| f.0), orders(&[4.0, 2.0, 1.0], &found.map(|f| f.1)));
    assert!(orders.iter().all(|p| (p - 2.0).abs() < 0.05), "{orders:?}");
    agrees("| pressure, thickness and height within {} % with 100 elements, second order |", &at_most(errors[2]));
    // Trust: chords for an arc are second order in the number of elements, down to the corrector's tolerance.
    assert!(errors[2] < 2e-4, "{errors:?}");
    assert!(errors[1] < 0.3 * errors[0] && errors[2] < 0.5 * errors[1], "{errors:?}");
}

#[test]
fn superplastic_box_is_blown_into_its_corner() {
    let run = solve(&shipped("superplastic_box", &[]));
    assert!(run.stop.kind == StopKind::ContactShare && last(&run).contact_share >= 0.95, "{}", run.stop);
    let rejected: usize = run.steps.iter().map(|r| r.rejected).sum();
    let failed = rejected - run.effort.overstepped;
    assert!(failed <= 8, "{failed} tries that came to no equilibrium");
    let frame = run.frames.last().expect("the end");
    assert_eq!(frame.time, last(&run).time, "the end of the run is kept");
    // Free bulge up to the bottom: contact grows on the shoulder only.
    let free = run.steps.iter().filter(|r| r.pole_height < 19.5).map(|r| r.contact_share);
    assert!(free.fold(0.0, f64::max) < 0.15);
    // Trust: what touches first is held by friction and stops thinning, so the last to touch is the thinnest (known of
    // boxes of all superplastic alloys); the corner's arc runs from (34, 20) to (40, 14) mm.
    let thinnest = frame.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness)).expect("elements");
    assert!(thinnest.r > 31.0 && thinnest.z > 13.0, "thinnest at {} {}", thinnest.r, thinnest.z);
    let (bottom, top) = (frame.elements[0].thickness, frame.elements[frame.elements.len() - 1].thickness);
    assert!(thinnest.thickness < 0.92 * bottom && bottom < top, "{} {bottom} {top}", thinnest.thickness);
    // The sheet follows the die: the corner's arc less half a thickness, within the foot of the contact law.
    for n in frame.nodes.iter().filter(|n| n.r > 35.0 && n.z > 15.0) {
        let gap = 6.0 - 0.5 * n.thickness - (n.r - 34.0).hypot(n.z - 0.5 - 14.0);
        assert!((-0.01..0.05).contains(&gap), "{gap} at {} {}", n.r, n.z);
    }
}

/// A flat membrane is strained alike by a bulge to either side, and its pressure on the other side is negative: twice the
/// elements and an eighth of the step made the second step jump there.
///
/// Trust: gas pushes away from the face that it is on.
#[test]
fn gas_that_holds_a_strain_rate_never_sucks() {
    for elements in [160, 320, 640] {
        for max_step in [0.01, 0.00125] {
            let sets = [
                format!("blank.elements={elements}"),
                format!("solver.max_step={max_step}"),
                format!("solver.first_step={}", 0.2 * max_step),
            ];
            let model = shipped("superplastic_box", &sets.each_ref().map(String::as_str));
            let start = solver::run(&model, &mut Stopper { steps: 10, iterations: usize::MAX }).steps;
            assert_eq!(start.len(), 10);
            for StepRecord { step, pole_height: height, pressure, .. } in start {
                assert!(height > 0.0 && pressure >= 0.0, "{sets:?}, step {step}: {height} mm, {pressure} MPa");
            }
        }
    }
}

#[test]
fn the_end_of_the_box_is_an_instant_within_its_step() {
    let end = |set: &[&str]| {
        let run = solve(&shipped("superplastic_box", set));
        assert_eq!(run.stop.kind, StopKind::ContactShare);
        let (share, time) = (last(&run).contact_share, run.end.time);
        // Trust: the share closes in its last hundredths within a second, a thousandth of a step is 6 ms at most.
        assert!((0.95..0.96).contains(&share), "{share}");
        time
    };
    let (usual, fine) = (end(&[]), end(&["blank.elements=320"]));
    let half = end(&["solver.max_step=0.005", "solver.first_step=0.001"]);
    // Trust: a step is 1 to 1.6 % of the time, and one element is 1.4 % of the area within the seal.
    assert!((usual / half - 1.0).abs() < 4e-3 && (usual / fine - 1.0).abs() < 1e-3, "{usual} {half} {fine}");
}

#[test]
fn tools_that_meet_end_the_run() {
    let mut model = shipped("quickstart", &[]);
    // Wider than the throat allows for half a thickness: the wall of the punch meets the shoulder's circle.
    model.tools[0].profile = Profile::crowned_punch(30.9, 60.0, 25.0, 1.0);
    model.stop.localised = false;
    drive_to(&mut model, 40.0);
    let run = solver::run(&model, &mut ());
    assert_eq!(run.stop.kind, StopKind::ToolsClosed);
    let [punch, die] = [0, 1].map(|tool| &model.tools[tool].profile);
    let gap = punch.distance_to(die, Point::new(0.0, run.end.travel)).0;
    // Trust: half a thickness is where the run is said to end.
    assert!((gap - 0.5).abs() < 1e-3, "{gap}");
}

#[test]
fn a_run_ends_after_the_load_maximum_when_asked() {
    let run = solver::run(&shipped("quickstart", &["tools.punch.travel=32 mm", "stop.load_drop=10 %"]), &mut ());
    assert_eq!(run.stop.kind, StopKind::LoadMaximum);
    let drop = 1.0 - last(&run).punch_force / peak(&run);
    assert!((0.10..0.15).contains(&drop), "{drop}");
}

#[test]
fn localisation_ends_the_run_where_it_happens() {
    let weak = ["blank.edge=clamped", "material.hardening.swift.n=0.05", "tools.punch.friction=0.3"];
    let run = solver::run(&shipped("quickstart", &weak), &mut ());
    assert_eq!(run.stop.kind, StopKind::Localised);
    assert!(run.stop.s0.is_some_and(|s0| s0 < 37.25) && last(&run).thinnest < 0.8 && run.end.travel < 25.0);
    let mut on = weak.to_vec();
    on.push("stop.localised=false");
    assert_ne!(solver::run(&shipped("quickstart", &on), &mut ()).stop.kind, StopKind::Localised);
}
