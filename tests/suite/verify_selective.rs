//! Verification of selective bending: against bending everywhere, and against membrane theory where nothing bends.

use crate::common::prelude::*;
use crate::common::shipped::shipped;

fn with(theory: Theory, model: &Model) -> Model {
    let mut model = model.clone();
    model.blank.theory = theory;
    model
}

/// Largest difference of the punch force from that of `other` at equal travel, straight between its steps, over its peak;
/// and the travel where it is.
fn largest_difference(run: &StageSolution, other: &StageSolution) -> (f64, f64) {
    let h = &other.steps;
    let differences = run.steps.iter().filter(|r| r.travel >= h[0].travel).map(|r| {
        let after = h.partition_point(|o| o.travel < r.travel).clamp(1, h.len() - 1);
        let (a, b) = (&h[after - 1], &h[after]);
        let share = (r.travel - a.travel) / (b.travel - a.travel);
        let force = a.punch_force + share * (b.punch_force - a.punch_force);
        ((r.punch_force - force) / peak(other), r.travel)
    });
    differences.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).expect("steps")
}

/// Largest relative difference of the elements' thickness at the end.
fn thickness_apart(run: &StageSolution, other: &StageSolution) -> f64 {
    let [run, other] = [run, other].map(|run| &run.frames[run.frames.len() - 1].elements);
    run.iter().zip(other).map(|(a, b)| (a.thickness / b.thickness - 1.0).abs()).fold(0.0, f64::max)
}

/// Share of the elements that bend, over all steps.
fn bent(run: &StageSolution) -> f64 {
    let bending: usize = run.steps.iter().map(|r| r.bending).sum();
    bending as f64 / (run.steps.len() * run.end.thickness.len()) as f64
}

/// Trust: outside the radii the only curvature is that of faces with t/R below the limit; what a moment adds to the force
/// there is of the order of t/R of it, on a small part of the way. 1 % is what the option promises on a cup.
#[test]
fn selective_bending_gives_the_punch_force_of_bending_everywhere() {
    let mut differences = Vec::new();
    for name in ["woo_hemispherical", "chalmers_cup", "quickstart"] {
        let model = shipped(name, &[]);
        let (full, run) = (solve(&model), solve(&with(Theory::Selective, &model)));
        let (difference, travel) = largest_difference(&run, &full);
        assert!(difference.abs() < 0.01, "{name}: {difference:e} at {travel} mm");
        differences.push(difference);
        let elements = model.blank.elements;
        // Trust: before the first step nothing is in tension, and little in the first; once it is, faces and flanges are flat,
        // and radii are not.
        assert_eq!(run.steps[0].bending, elements, "{name}");
        let drawn = run.steps.iter().filter(|r| r.travel > 0.02 * model.travel);
        assert!(drawn.map(|r| r.bending).all(|bending| (1..elements).contains(&bending)), "{name}");
        assert!(full.steps.iter().all(|r| r.bending == elements), "{name}");
    }
    told(
        "docs/agreement.md",
        "Woo {} % of the peak force at most at equal travel, Chalmers {} %, quickstart {} %;",
        &signed(&differences, 2),
    );
}

/// What the limit does: where it is below the t/R of a hemisphere all of it bends, and where it is above that of every corner none
/// of it does. Trust: the fewer elements bend, the further force and thickness are from those of bending everywhere.
#[test]
fn the_limit_decides_how_much_bends() {
    let cups = ["woo_hemispherical", "chalmers_cup"].map(|name| {
        let full = shipped(name, &["blank.theory=\"bending\""]);
        (solve(&full), with(Theory::Selective, &full))
    });
    let mut apart = 0.0;
    for ratio in [0.02, 0.05, 0.1, 0.2] {
        let found = cups.each_ref().map(|(full, selective)| {
            let mut model = selective.clone();
            model.settings.bend_ratio = ratio;
            let run = solve(&model);
            [largest_difference(&run, full).0, thickness_apart(&run, full), bent(&run)]
        });
        let row = format!(
            "| {ratio}{} | {{}} %, {{}} %, {{}} % | {{}} %, {{}} %, {{}} % |",
            match ratio {
                0.05 => " (default)",
                0.2 => ": no corner of these tools bends the sheet",
                _ => "",
            }
        );
        let figures = found.map(|[force, thickness, bent]| {
            [signed(&[force], 2), plain(&[100.0 * thickness], 1), plain(&[100.0 * bent], 0)].concat()
        });
        told("docs/agreement.md", &row, &figures.concat());
        let now: f64 = found.iter().map(|[force, ..]| force.abs()).sum();
        assert!(ratio < 0.2 || now > 4.0 * apart, "{ratio}: {found:?}");
        apart = now;
    }
}

/// Every case that a punch drives: as many steps are rejected as are allowed to full bending, the balance closes, and the peak
/// force is that of full bending.
#[test]
fn every_shipped_case_runs_with_selective_bending() {
    let (mut peaks, mut balance) = (0.0_f64, 0.0_f64);
    for name in DRAWN {
        let full = with(Theory::Bending, &shipped(name, &["blank.theory=\"bending\""]));
        let (full, run) = (solve(&full), solve(&with(Theory::Selective, &full)));
        let rejected: usize = run.steps.iter().map(|r| r.rejected).sum();
        let change = peak(&run) / peak(&full) - 1.0;
        assert!(rejected <= 3, "{name}: {rejected} rejected steps");
        // Trust: largest force of one on the other's curve is smooth there; full bending of a face with t/R = 0.02 adds less.
        assert!(change.abs() < 0.01, "{name}: the peak moves by {change:e}");
        // Trust: the trapezoidal rule along the path; a moment that ends with a step adds its square.
        assert!(last(&run).work.imbalance().abs() < 0.005, "{name}: {:?}", last(&run).work);
        (peaks, balance) = (peaks.max(change.abs()), balance.max(last(&run).work.imbalance().abs()));
    }
    told(
        "docs/agreement.md",
        "the peaks of all nine punch-driven cases within {} %, the balance within {} %.",
        &[at_most(peaks), at_most(balance)].concat(),
    );
}

/// Trust: with the limit out of reach the equations are those of membrane theory, though the sheet has five layers: both
/// runs stop iterating at a velocity norm of 1e-5, so forces agree to about that.
#[test]
fn a_sheet_that_nowhere_bends_is_a_membrane_and_its_fibres_stay_upright() {
    let model = shipped("osu_stretch", &["blank.theory=\"membrane\""]);
    let membrane = solve(&model);
    let mut selective = with(Theory::Selective, &model);
    selective.blank.layers = 5;
    selective.settings.bend_ratio = 1.0;
    // In tension from the start: a slack sheet would bend.
    let mut tight = State::flat(&selective, mesh::nodes(&selective));
    for point in tight.points.iter_mut() {
        point.stress = [100.0, 100.0, 0.0];
    }
    let run = solver::run_from(&selective, tight, &mut ());
    let state = run.end.clone();
    assert!(run.steps.iter().all(|r| r.bending == 0));
    let (difference, travel) = largest_difference(&run, &membrane);
    assert!(difference.abs() < 1e-4, "{difference:e} at {travel} mm");
    for (a, b) in run.frames[3].elements.iter().zip(&membrane.frames[3].elements) {
        assert!((a.thickness / b.thickness - 1.0).abs() < 1e-4, "{a:?} {b:?}");
        assert!((a.strain_equivalent / b.strain_equivalent - 1.0).abs() < 1e-3, "{a:?} {b:?}");
        assert!((a.strain_equivalent_max - a.strain_equivalent).abs() < 1e-12, "{a:?}");
    }
    // Trust: the turns of every step add up to the slope, to round-off.
    let slope = |e: usize| {
        let (a, b) = (state.nodes[e], state.nodes[e + 1]);
        (b[1] - a[1]).atan2(b[0] - a[0])
    };
    for i in 1..state.nodes.len() - 1 {
        assert!((state.nodes[i][2] - 0.5 * (slope(i - 1) + slope(i))).abs() < 1e-9, "{:?}", state.nodes[i]);
    }
}
