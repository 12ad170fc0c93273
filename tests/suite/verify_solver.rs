//! Verification of the solver on whole runs: invariants, refinement, and agreement between its own options.

use crate::common::prelude::*;

/// Largest departure of the load from a smooth curve, over its maximum: each point against the cubic through its
/// neighbours two and four steps away on either side.
fn largest_tick(run: &StageSolution) -> f64 {
    let h = &run.steps;
    let mut worst: f64 = 0.0;
    for i in 4..h.len().saturating_sub(4) {
        let at = [i - 4, i - 2, i + 2, i + 4];
        // Lagrange's interpolation at the travel of i.
        let factor = |a: usize, b: usize| (h[i].travel - h[b].travel) / (h[a].travel - h[b].travel);
        let weight = |a: usize| at.iter().filter(|b| **b != a).map(|b| factor(a, *b)).product::<f64>();
        let smooth: f64 = at.iter().map(|a| weight(*a) * h[*a].punch_force).sum();
        worst = worst.max((h[i].punch_force - smooth).abs());
    }
    worst / peak(run)
}

#[test]
fn every_shipped_case_runs_smoothly_to_its_full_travel() {
    let (mut most_rejected, mut ticks, mut missing) = (0, Vec::new(), 0.0_f64);
    for name in DRAWN.split(' ') {
        let run = solve(&shipped::shipped(name, &[]));
        let rejected: usize = run.steps.iter().map(|r| r.rejected).sum();
        let tick = largest_tick(&run);
        assert!(rejected <= 6, "{name}: {rejected} rejected steps");
        assert!(tick < 0.01, "{name}: the load ticks by {:.2} %", 100.0 * tick);
        // Trust: the trapezoidal rule along the path errs with the square of the step; 1 % is the promise.
        let balance = last(&run).work.imbalance();
        assert!(balance.abs() < 0.01, "{name}: the balance misses {balance:e}");
        assert!(last(&run).penetration < 0.05, "{name}: penetration {}", last(&run).penetration);
        most_rejected = most_rejected.max(rejected);
        missing = missing.max(balance.abs());
        ticks.push((name, 100.0 * tick));
    }
    let of = |name: &str| ticks.iter().find(|(case, _)| *case == name).expect("it is drawn").1;
    let woo = 100.0 * largest_tick(&solve(&shipped::shipped("woo_hemispherical", &[])));
    let coarse = 100.0 * largest_tick(&solve(&shipped::shipped("chalmers_cup", &["blank.elements=82"])));
    told(
        "docs/contact_on_faces.md",
        "by {} % of the peak with the 50 elements of Woo's cup, by {} % with 82 elements on Chalmers's cup, and by {} % \
         with its 163.",
        &plain(&[woo, coarse, of("chalmers_cup")], 2),
    );
    let (least, most) = ticks.iter().fold((f64::INFINITY, 0.0_f64), |ends, (_, t)| (ends.0.min(*t), ends.1.max(*t)));
    let ticks = plain(&[least, most], 2);
    agrees(
        "| full travel, rejected steps in a case: {} at most; largest tick of the load {} to {} % of its peak |",
        &[vec![most_rejected.to_string()], ticks].concat(),
    );
    agrees("| within {} % of the external work in the cases;", &at_most(missing));
}

/// A record of 300 measured points with scatter hardens the sheet as the law beneath it does.
///
/// Trust: by the law itself the strip takes 4 rejected steps. Through every point of the record it would take 300 to 1500 and
/// find no equilibrium; the peak may differ by the mean of the scatter, of which half a percent is the largest.
#[test]
fn a_long_record_with_scatter_is_solved_as_its_law() {
    let law = Hardening::Swift(Swift::new(520.0, 0.22, 5e-3).expect("valid"));
    // Short of where the strip is about to tear, which a scatter of half a percent decides.
    let mut model = shipped::shipped("strip_draw", &["tools.punch.travel=40 mm"]);
    model.material.hardening = law.clone();
    let expected = peak(&solve(&model));
    for (seed, top) in [(1, 0.3), (2, 0.6)] {
        let mut rng = fastrand::Rng::with_seed(seed);
        let strain: Vec<f64> = (0..300).map(|i| top * f64::from(i) / 299.0).collect();
        let mut last: f64 = 0.0;
        let stress = strain.iter().map(|e| {
            last = last.max(law.at(*e).stress * (1.0 + 5e-3 * (2.0 * rng.f64() - 1.0)));
            last
        });
        let stress = stress.collect();
        model.material.hardening = Hardening::Table(Table::new(strain, stress, Extrapolation::Slope).expect("rising"));
        let run = solve(&model);
        let rejected: usize = run.steps.iter().map(|step| step.rejected).sum();
        assert!(rejected <= 20, "{rejected} rejected up to {top}");
        assert!((peak(&run) / expected - 1.0).abs() < 5e-3, "{} {expected}", peak(&run));
    }
}

/// Trust: the thickness follows from the volume, so only round-off of a few hundred steps can add up.
#[test]
fn volume_is_constant() {
    for name in ["woo_hemispherical", "chalmers_cup", "strip_draw"] {
        let model = shipped::shipped(name, &[]);
        let flat = State::initial(&model, mesh::nodes(&model));
        let before: f64 = flat.volume.iter().sum();
        let state = solver::run_from(&model, flat, &mut ()).end;
        let volumes = state.nodes.windows(2).zip(&state.thickness).map(|(ends, thickness)| {
            let (a, b) = (ends[0], ends[1]);
            let around = if model.geometry == Geometry::Axisymmetric { PI * (a[0] + b[0]) } else { 1.0 };
            around * (b[0] - a[0]).hypot(b[1] - a[1]) * thickness
        });
        let after: f64 = volumes.sum();
        assert!((after / before - 1.0).abs() < 1e-12, "{name}: {:e}", after / before - 1.0);
    }
}

/// Trust: the residual is the same whatever H is, so its zero is. From one state in mid-draw, one step each, corrected
/// until the velocity norm is far below the 1e-6 that is compared; the cut-off is larger than the default, where Newton stands.
#[test]
fn all_iteration_matrices_find_the_same_state() {
    for name in ["woo_hemispherical", "stretch_thin", "osu_stretch_friction"] {
        let mut model = shipped::shipped(name, &[]);
        drive_to(&mut model, 15.0);
        let start = solver::run_from(&model, State::initial(&model, mesh::nodes(&model)), &mut ()).end;
        let step = 0.05;
        drive_to(&mut model, 15.0 + step);
        let after = |iteration: Iteration| {
            let mut model = model.clone();
            let (max_iterations, first_step, cutoff_strain) = (400, 0.01, 2e-4);
            let own = Settings { iteration, tolerance: 1e-10, ..model.settings };
            model.settings = Settings { max_iterations, first_step, cutoff_strain, ..own };
            let run = solver::run_from(&model, start.clone(), &mut ());
            assert!(run.stop.is_complete() && run.steps.len() == 1, "{name} {iteration:?}: {}", run.stop);
            run
        };
        let reference = after(Iteration::PrimalDual);
        for iteration in [Iteration::Newton, Iteration::Secant] {
            let run = after(iteration);
            for (a, b) in reference.end.nodes.iter().zip(&run.end.nodes) {
                for d in 0..2 {
                    assert!((a[d] - b[d]).abs() < 1e-6 * step, "{name} {iteration:?}: {} {}", a[d], b[d]);
                }
            }
            let force = run.steps[0].punch_force / reference.steps[0].punch_force - 1.0;
            assert!(force.abs() < 1e-6, "{name} {iteration:?}: force differs by {force:e}");
        }
    }
}

/// Trust: refinement. The shipped meshes and default steps are converged to what a designer can use.
#[test]
fn doubling_elements_or_halving_steps_changes_little() {
    let mut changes = [Vec::new(), Vec::new()];
    for name in ["woo_hemispherical", "chalmers_cup"] {
        let model = shipped::shipped(name, &[]);
        let base = solve(&model);
        let mut finer = model.clone();
        finer.blank.elements *= 2;
        let mut shorter = model.clone();
        shorter.settings.max_step *= 0.5;
        shorter.settings.first_step *= 0.5;
        let refined = [("elements doubled", finer), ("steps halved", shorter)];
        for ((what, model), changes) in refined.into_iter().zip(&mut changes) {
            let run = solve(&model);
            let force = peak(&run) / peak(&base) - 1.0;
            let thin = last(&run).thinnest / last(&base).thinnest - 1.0;
            assert!(force.abs() < 0.007, "{name}, {what}: peak moves by {force:e}");
            assert!(thin.abs() < 0.01, "{name}, {what}: thinnest place moves by {thin:e}");
            changes.extend([force, thin]);
        }
    }
    for (what, changes) in ["elements doubled", "steps halved"].iter().zip(&changes) {
        let row = format!("| {what} | Woo: peak {{}} %, thinnest {{}} %; Chalmers: {{}} %, {{}} % |");
        agrees(&row, &signed(changes, 2));
    }
}

/// Trust: no reference; the friction of the punch decides whether the cup necks, and neither peak force nor mesh shows it.
#[test]
fn woo_s_neck_hangs_on_the_friction_of_the_punch() {
    let run = |(mu, elements): (&str, usize)| {
        let set = [format!("tools.punch.friction={mu}"), format!("blank.elements={elements}")];
        let set = ["tools.punch.travel=45 mm", &set[0], &set[1]];
        let run = solver::run(&shipped::shipped("woo_hemispherical", &set), &mut ());
        [last(&run).thinnest, 100.0 * (1.0 - last(&run).thinnest / 0.889), 1e-3 * peak(&run)]
    };
    let runs = [("0.04", 50), ("0.05", 50), ("0.06", 50), ("0.08", 50), ("0.04", 100), ("0.04", 200)].map(run);
    let [left, thinned, peaks] = [0, 1, 2].map(|i| runs.map(|run| run[i]));
    assert!([0, 4, 5].iter().all(|&i| (0.3..0.42).contains(&left[i])) && thinned[1] < 36.0, "{left:?}");
    assert!(peaks.iter().all(|force| (force / peaks[1] - 1.0).abs() < 0.015), "{peaks:?}");
    let sentence = "at 45 mm a coefficient of 0.04 has thinned the sheet by {} %, 0.05 by {} %, 0.06 by {} % and 0.08 by {} %, at \
                    peak forces of {}, {}, {} and {} kN";
    for page in ["docs/agreement.md", "cases/woo_hemispherical.toml"] {
        told(page, sentence, &[plain(&thinned[..4], 0), plain(&peaks[..4], 1)].concat());
    }
    let elements = "With 0.04 and twice and four times the elements {} and {} mm are left.";
    agrees(elements, &plain(&left[4..], 2));
}

/// Trust: refinement, with no closed form: the changes as elements or steps are halved twice. Steps are of second order
/// where the sheet flows steadily and of first order elsewhere, as around Woo's pole close to its neck;
/// elements of second or better in the edge's draw-in, while the peak of the force, which ticks as points pass a radius, is
/// only asked to settle faster than in first order. The coarsest elements have no neighbourhood but themselves, the finer ones
/// have: that moves the draw-in by a little of its own.
#[test]
fn whole_draws_converge_in_their_orders() {
    for name in ["woo_hemispherical", "chalmers_cup", "quickstart"] {
        let model = shipped::shipped(name, &[]);
        let of = |run: StageSolution| [peak(&run), last(&run).draw_in];
        let finer = [1, 2, 4].map(|k| {
            let mut model = model.clone();
            model.blank.elements *= k;
            of(solve(&model))
        });
        let shorter = [0.25, 0.125, 0.0625].map(|k| {
            let mut model = model.clone();
            model.settings.max_step *= k;
            model.settings.first_step *= k;
            model.settings.strain_step *= k;
            peak(&solve(&model))
        });
        let [force, drawn] = [0, 1].map(|k| orders_of_changes(&finer.map(|f| f[k]))[0]);
        let steps = orders_of_changes(&shorter)[0];
        // Where the peak moves by less than a thousandth there is nothing to see an order in.
        let settled = |peaks: [f64; 3]| peaks.windows(2).all(|f| (f[1] / f[0] - 1.0).abs() < 1e-3);
        assert!(force > 1.1 || settled(finer.map(|f| f[0])), "{name}: {force}");
        assert!(steps > 0.9 || settled(shorter), "{name}: {steps}");
        // The edge of Chalmers' cup lies still but for 4 µm on every mesh: nothing to see an order in.
        assert!(drawn > 1.8 || name == "chalmers_cup", "{name}: {drawn}");
    }
}
