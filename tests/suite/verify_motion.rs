//! A punch whose travel is given over time: where it is, what it does to sheet that feels the rate and to sheet that does not.

use crate::common::prelude::*;
use stampflow::material::rate::Rate;

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
