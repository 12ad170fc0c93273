//! The verdict on a run: lights, limits and advice.

use crate::common::prelude::*;
use crate::observer::Stopper;
use stampflow::{solver::solve, study::judge};

/// The verdict's rows, all findings made sure to be whole.
fn judged(case: &Case, passes: &[StageSolution]) -> Vec<Finding> {
    let mut findings = assess::after(case, passes);
    for finding in findings.iter().chain(&assess::before(case)) {
        let has_limit = finding.kind != Kind::Judgement || !finding.limit.is_empty();
        assert!(has_limit && !finding.statement().is_empty() && !finding.source.is_empty(), "{finding:?}");
        assert!(![finding.key, finding.label].contains(&""), "{finding:?}");
        assert!(finding.light != Light::Green || finding.advice.is_empty(), "{finding:?}");
    }
    findings.retain(|finding| finding.kind == Kind::Judgement);
    findings
}

#[test]
fn shipped_cases_have_their_lights() {
    for line in include_str!("../golden/lights.csv").lines().skip(1) {
        let [name, expected @ ..] = &line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let found = judged(&solved(name).case, &solved(name).stages);
        let keys = |light| found.iter().filter(|f| f.light == light).map(|f| f.key).collect::<Vec<_>>().join(" ");
        assert_eq!([Light::Red, Light::Amber, Light::Grey].map(keys), *expected, "{name}");
    }
}

#[test]
fn overrides_have_their_lights_and_failure_modes() {
    let torn =
        ["tools.holder.force=150 kN", "tools.die.friction=0.2", "tools.holder.friction=0.2", "forming_limit.hill=true"];
    let sharp = ["forming_limit.hill=true", "tools.die.shoulder=4.5 mm"];
    let (tears, wrinkles) = (Some(FailureMode::Tears), Some(FailureMode::Wrinkles));
    for (overrides, key, light, mode) in [
        (&torn[..], "forming_limit", Light::Red, tears),
        (&torn, "stop", Light::Red, tears),
        (&torn, "wrinkling", Light::Green, tears),
        (&sharp, "solution_quality", Light::Green, None),
        (&sharp, "forming_limit", Light::Green, None),
        (&["tools.holder.force=3 kN", "tools.punch.travel=3 mm"], "wrinkling", Light::Amber, None),
        (&["tools.holder.force=1 kN", "tools.punch.travel=3 mm"], "wrinkling", Light::Red, wrinkles),
        (&["tools.holder.force=600 kN", "tools.punch.travel=1 mm"], "holder", Light::Amber, None),
        (&["press.force=1 kN", "tools.punch.travel=3 mm"], "press_force", Light::Red, Some(FailureMode::Press)),
        // The largest load is 45.3 kN of the punch and 10 kN of the holder; 20 % more of it are 66.4 kN.
        (&["press.force=50 kN"], "press_force", Light::Red, Some(FailureMode::Press)),
        (&["press.force=60 kN"], "press_force", Light::Amber, None),
        (&["press.force=80 kN", "press.energy=5 kJ"], "press_force", Light::Green, None),
        (&["press.force=80 kN", "press.energy=5 kJ"], "energy", Light::Green, None),
        (&["press.energy=1 J", "tools.punch.travel=3 mm"], "energy", Light::Red, Some(FailureMode::Press)),
        // No holder is no better than a weak one: 50 mm of blank beyond the punch.
        (&["tools.holder.force=0 N", "tools.punch.travel=3 mm"], "wrinkling", Light::Red, wrinkles),
        // Runs with less and more are solved for the user of one case, see tests/suite/advice.rs.
        (&["friction.source=Woo (1968)"], "friction", Light::Grey, None),
        (&["tools.die.throat=40 mm", "tools.holder.inner_radius=46 mm"], "clearance", Light::Amber, None),
        // Sharp bends and bent strain paths are a question of trust, not of failure.
        (&["tools.die.shoulder=1.5 mm", "tools.punch.travel=8 mm"], "solution_quality", Light::Amber, None),
    ] {
        let (answer, found) = answered("quickstart", overrides);
        assert_eq!((row(&found, key).light, answer.failures.first().copied()), (light, mode), "{overrides:?} {key}");
    }
}

/// Trust: by hand, as in `check`: Siebel's 0.0025 [(β − 1)² + 0.3] R_m with R_m = 520 n^n exp(offset − n), over 10 kN on the flat.
#[test]
fn wrinkle_index_is_that_of_a_hand_calculation() {
    let (_, found) = answered("quickstart", &[]);
    let strength = 520.0 * 0.22_f64.powf(0.22) * (0.005_f64 - 0.22).exp();
    let advised = 0.0025 * ((55.0_f64 / 30.0 - 1.0).powi(2) + 0.3) * strength;
    let held = PI * (55.0_f64.powi(2) - 37.25_f64.powi(2));
    // The strength is the largest of steps of 5e-4 in strain: flat at the maximum, so right to 1e-6.
    assert!((row(&found, "wrinkling").value().unwrap() / (advised * held / 10_000.0) - 1.0).abs() < 1e-4);
}

/// Trust: by hand, 1.5 of the second punch is beyond 1.3.
#[test]
fn later_draws_are_judged_too() {
    let case = made("redraw", &[("first-radius", "45 mm")], &[]);
    let mut passes = solve(&case.stages, &mut ());
    let found = judged(&case, &passes);
    assert_eq!(row(&found, "redraw_ratio").light, Light::Amber, "{found:?}");
    assert!((row(&found, "redraw_ratio").value().unwrap() - 1.5).abs() < 1e-9);
    // One stroke's energy, not the sum of both.
    let works = passes.iter().map(|pass| 1e-3 * pass.steps.last().expect("steps").work.external);
    assert!((row(&found, "energy").value().unwrap() - works.fold(0.0, f64::max)).abs() < 1e-9);
    // Tools that nothing presses on.
    passes[1].tool_forces.iter_mut().for_each(|forces| forces.fill(1e-8));
    let idle = row(&judged(&case, &passes), "idle_tool").clone();
    let names = "never presses on the punch, stage 2 and the die, stage 2;";
    assert!(idle.light == Light::Red && idle.text.contains(names), "{idle:?}");
}

/// Trust: by hand, p π a² of a clamped disc of 56 mm against a press of 500 kN; a third of σ t/r leaves the corner open.
#[test]
fn pressure_fills_a_die_and_pushes_its_press_open() {
    for (pressure, lights) in [(20.0, [Light::Red, Light::Green]), (71.0, [Light::Green, Light::Red])] {
        let case = made("hydroform", &[("pressure", &format!("{pressure} MPa"))], &["press.force=500 kN"]);
        let found = judged(&case, &solve(&case.stages, &mut ()));
        assert_eq!(["filling", "press_force"].map(|key| row(&found, key).light), lights, "{found:?}");
        let force = row(&found, "press_force").value().unwrap();
        assert_relative_eq!(force, pressure * PI * 56.0 * 56.0, max_relative = 1e-9);
    }
}

/// Trust: tools that close in less than the thickness coin a sheet that is to be bent, with a hundred times the force.
#[test]
fn closed_tools_leave_room_for_the_sheet() {
    for (clearance, light) in [("0.97 mm", Light::Amber), ("0.9 mm", Light::Red)] {
        let (answer, found) = judge(&made("joggle", &[("clearance", clearance)], &[]).solve(&mut ()), None, true, &());
        let narrow = row(&found, "clearance");
        assert_eq!((answer.light, narrow.light), (light, light), "{found:?}");
        assert!(!narrow.advice.contains("travel"), "{narrow:?}");
    }
}

fn answered(name: &str, overrides: &[&str]) -> (Answer, Vec<Finding>) {
    let case = shipped_case(name, overrides);
    let stages = solve(&case.stages, &mut ());
    let findings = judged(&case, &stages);
    (Answer::of(&case, &stages, &findings), findings)
}

/// Trust: the user's own doing is no fault of the part.
#[test]
fn an_interrupted_run_is_not_red() {
    let case = shipped_case("quickstart", &[]);
    let stages = solve(&case.stages, &mut Stopper { steps: 5, iterations: usize::MAX });
    let answer = Answer::of(&case, &stages, &judged(&case, &stages));
    assert_eq!((answer.light, answer.sentence.to_string().as_str()), (Light::Amber, "interrupted by the user"));
}
