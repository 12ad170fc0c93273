//! A punch whose travel is given over time: where it is, what it does to sheet that feels the rate and to sheet that does not.

use crate::common::prelude::*;

/// The quickstart with a history in place of its 25 mm at 1 mm/s.
fn cup(motion: &str, overrides: &[&str]) -> Model {
    let text = include_str!("../../cases/quickstart.toml").replace("travel = \"25 mm\"", &format!("motion = {motion}"));
    parsed(&text, overrides).model().clone()
}

/// Largest difference of the punch forces of two runs with the same steps, over the largest force.
fn difference(a: &StageSolution, b: &StageSolution) -> f64 {
    assert_eq!(a.steps.len(), b.steps.len());
    let steps = a.steps.iter().zip(&b.steps);
    let largest = a.steps.iter().map(|r| r.punch_force).fold(0.0, f64::max);
    for (a, b) in steps.clone() {
        assert!((a.travel / b.travel - 1.0).abs() < 1e-9, "{} {}", a.travel, b.travel);
    }
    steps.map(|(a, b)| (a.punch_force - b.punch_force).abs() / largest).fold(0.0, f64::max)
}

const CONSTANT: &str = r#"[["0 s", "0 mm"], ["12.5 s", "12.5 mm"], ["25 s", "25 mm"]]"#;

/// Trust: the same problem in other words; round-off of the times is all that may differ.
#[test]
fn a_history_of_one_speed_equals_that_speed() {
    let (history, speed) = (cup(CONSTANT, &[]), shipped::shipped("quickstart", &[]));
    assert_eq!((history.travel, history.speed, history.duration), (speed.travel, speed.speed, speed.duration));
    assert_eq!(history.frames, speed.frames);
    let difference = difference(&solve(&history), &solve(&speed));
    assert!(difference < 1e-10, "{difference:e}");
}

/// Trust: sheet without rate dependence feels the travel only. Steps, cut-off and the regularised friction are measured in
/// travel too, so a hundredfold change of speed leaves the force as it is.
#[test]
fn rate_free_sheet_does_not_feel_the_speed() {
    let fast_at_last = r#"[["0 s", "0 mm"], ["125 s", "12.5 mm"], ["126.25 s", "25 mm"]]"#;
    let model = cup(fast_at_last, &["output.frames=[\"12.5 mm\", \"20 mm\"]"]);
    assert_eq!(model.frames, [125.0, 125.75, 126.25]);
    let run = solve(&model);
    let travels: Vec<f64> = run.frames.iter().map(|f| f.travel).collect();
    for (found, asked) in travels.iter().zip([12.5, 20.0, 25.0]) {
        assert!((found - asked).abs() < 1e-9, "{travels:?}");
    }
    let difference = difference(&run, &solve(&cup(CONSTANT, &["output.frames=[\"12.5 mm\", \"20 mm\"]"])));
    assert!(difference < 1e-9, "{difference:e}");
}

/// Trust: with σ = σ_s (ε̄) (ε̄̇/ε̇₀)^m the force at equal stretch is in the ratio of the speeds to the power m, exactly.
#[test]
fn force_follows_the_speed_to_the_power_of_the_rate() {
    let m = 0.05;
    let mut slow = simple::pulled(Geometry::PlaneStrain, Theory::Membrane, 8.0);
    slow.material.rate = Some(Rate::PowerRate(PowerRate { exponent: m, reference: 1e-3 }));
    slow.frames = vec![3.0, 8.0];
    let mut fast = slow.clone();
    // 1 mm/s up to 3 mm, then 20 mm/s.
    fast.schedule = PiecewiseLinear::new(vec![(0.0, 0.0), (3.0, 3.0), (3.25, 8.0)]);
    (fast.speed, fast.duration, fast.frames) = (8.0 / 3.25, 3.25, vec![3.0, 3.25]);
    let (slow, fast) = (solve(&slow), solve(&fast));
    assert_eq!(slow.steps.len(), fast.steps.len());
    let mut compared = 0;
    for (a, b) in slow.steps.iter().zip(&fast.steps) {
        assert!((a.travel - b.travel).abs() < 1e-9, "{} {}", a.travel, b.travel);
        let ratio = if a.travel > 3.0 + 1e-9 { 20f64.powf(m) } else { 1.0 };
        // Trust: the corrector's tolerance.
        assert!((b.edge_force / a.edge_force / ratio - 1.0).abs() < 1e-5, "{} at {}", b.edge_force, b.travel);
        compared += usize::from(ratio > 1.0);
    }
    assert!(compared > 20, "{compared} steps at the higher speed");
}

/// Trust: closed forms. A crank of 50 mm without a rod comes down the last 25 mm from 60°, at 30 strokes a minute in a third of a
/// second, and permits there sin 30°/sin 60° of what it bears from 30° on. The force of a rate-free sheet is that of any speed.
#[test]
fn a_punch_without_a_speed_follows_its_press() {
    let drive = "press.drive={stroke=\"100 mm\", strokes_per_minute=30, nominal_angle=\"30 deg\"}";
    let case = shipped_case("quickstart", &["press.force=100 kN", drive]);
    let (model, permitted) = (case.model(), |left: f64| case.press.permitted(left).expect("a rating"));
    assert!((model.duration - 1.0 / 3.0).abs() < 1e-12 && (model.speed - 75.0).abs() < 1e-9 && model.timed);
    let speed = model.schedule.as_ref().expect("a schedule").slope_before(1e-3);
    assert!((speed / (50.0 * PI * (PI / 3.0).sin()) - 1.0).abs() < 0.01, "{speed}");
    assert!((permitted(25.0) / (100e3 * (PI / 6.0).sin() / (PI / 3.0).sin()) - 1.0).abs() < 1e-12);
    assert_eq!(shipped_case("quickstart", &[drive, "tools.punch.speed=1 mm/s"]).model().schedule, None);

    let solution = case.clone().solve(&mut ());
    let (run, even) = (&solution.stages[0], &shipped::solved("quickstart").stages[0]);
    assert!((peak(run) / peak(even) - 1.0).abs() < 2e-3);
    let shares = run.steps.iter().map(|step| (step.punch_force + step.holder_force) / permitted(25.0 - step.travel));
    let closest = shares.fold(0.0, f64::max);
    let rows = assess::after(&case, &solution.stages);
    let row = rows.iter().find(|row| row.key == "press_force").expect("a row");
    let (load, limit) = (row.quantity.as_ref().expect("one").amount.value, row.limits().and_then(|limits| limits.red));
    assert!((load / limit.expect("a limit") / closest - 1.0).abs() < 1e-9, "{load} {limit:?} {closest}");
    assert!(row.sentence().contains("° before the bottom dead centre"), "{}", row.sentence());
}
