//! Runs that end for want of equilibrium are named after what the sheet does: it bursts, arches, or nothing holds it.

use crate::common::prelude::*;
use stampflow::solver::solve;

const METAL: &str = r#"hardening = { swift = { k = "520 MPa", n = 0.22, offset = 0.005 } }"#;

/// Runs a case of one stage, whose advice must be there where it stops early.
fn solved(geometry: &str, blank: &str, tools: &str) -> StageSolution {
    let text = format!("title = \"End\"\ngeometry = \"{geometry}\"\n[blank]\n{blank}\n[material]\n{METAL}\n{tools}");
    let case = parsed(&text, &[]);
    let stages: Vec<StageSolution> = solve(&case.stages, &mut ());
    let found = assess::after(&case, &stages);
    let run = row(&found, "stop");
    let stage = stages.into_iter().next_back().expect("one stage");
    let stop = &stage.stop;
    use StopKind::{Coalesced, LoadMaximum, Localised, PressureMaximum};
    let tears = matches!(stop.kind, Localised | Coalesced | LoadMaximum | PressureMaximum);
    assert_eq!(run.advice.is_empty(), stop.is_complete() || tears, "{run:?}");
    assert!(stop.is_complete() || (stop.is_physical() && run.statement().contains(stop.kind.name())), "{run:?}");
    stage
}

/// A clamped disc bulged over an opening of 50 mm radius while a punch follows far below it.
///
/// Trust: the membrane with σ = K ε^n of that opening bears at most about 9.5 MPa, whatever stands below: Hill's
/// p = 2 σ t/ρ at its maximum, (4/11)(2n + 1) = 0.52 in strain (`verify_loads` holds it to that).
#[test]
fn a_dome_over_a_punch_bursts_at_the_pressure_that_it_bursts_at_without() {
    let blank = "radius = \"55 mm\"\nthickness = \"1 mm\"\nedge = \"clamped\"\nelements = 60";
    let die = r#"die = { throat = "50 mm", shoulder = "5 mm", friction = 0.1 }"#;
    let punch = r#"punch = { flat = { radius = "20 mm", nose = "6 mm" }, travel = "10 mm", friction = 0.1 }"#;
    let gas =
        |rest: &str| format!("[gas]\nlower = {{ pressure = [[\"0 s\", \"0 MPa\"], [\"10 s\", \"20 MPa\"]] }}\n{rest}");
    let alone = solved("axisymmetric", blank, &format!("[tools]\n{die}\n{}", gas("duration = \"10 s\"")));
    let over = solved("axisymmetric", blank, &format!("[tools]\n{punch}\n{die}\n{}", gas("")));
    let [p, q] = [&alone, &over].map(|run| {
        assert_eq!((run.stop.kind, run.stop.s0), (StopKind::PressureMaximum, Some(0.0)));
        run.steps.last().expect("steps").pressure
    });
    // Trust: the punch takes no part; both find the maximum by halving steps, as in `verify_bulge` to half a percent.
    assert!((p / q - 1.0).abs() < 5e-3, "{p} {q}");
}

/// A strip of membranes over a die, with or without what holds it.
///
/// Trust: statics. Without a tension a chain of membranes has no stiffness across itself, and nothing gives it one here.
#[test]
fn a_strip_of_membranes_that_nothing_holds_is_a_mechanism() {
    let strip = |theory: &str, more: &str, metal: &str| {
        let blank =
            format!("half_length = \"80 mm\"\nthickness = \"1 mm\"\nelements = 60\ntheory = \"{theory}\"\n{more}");
        let punch = r#"punch = { hemispherical = { radius = "25 mm" }, travel = "4 mm", friction = 0.1 }"#;
        let die = r#"die = { throat = "40 mm", shoulder = "5 mm", friction = 0.1 }"#;
        solved("plane_strain", &blank, &format!("{metal}[tools]\n{punch}\n{die}")).stop.kind
    };
    assert_eq!(strip("membrane", "", ""), StopKind::Mechanism);
    // Nor has it elasticity across itself.
    let elastic = "mode = \"elasto_viscoplastic\"\nyoung = \"206 GPa\"\npoisson = 0.3\n";
    assert_eq!(strip("membrane", "", elastic), StopKind::Mechanism);
    for (theory, more) in [("membrane", "edge = \"clamped\""), ("bending", "")] {
        assert_eq!(strip(theory, more, ""), StopKind::FullTravel, "{theory} {more}");
    }
}

/// Strips without friction in a narrow gap without a holder: the legs lift the middle off the punch, and it snaps.
///
/// Trust: where each of them ends, the middle is thicknesses ahead of a punch that only pushes. Whether an arch snaps or is
/// drawn on depends on the mesh, so that one of them must, not all.
#[test]
fn a_strip_that_its_legs_lift_off_the_punch_ends_as_an_arch() {
    let punch = r#"punch = { flat = { half_width = "15 mm", nose = "3 mm" }, travel = "20 mm", friction = 0 }"#;
    let mut arches = 0;
    for elements in [60, 80] {
        for shoulder in [2, 4, 6] {
            let blank = format!("half_length = \"50 mm\"\nthickness = \"1 mm\"\nelements = {elements}");
            let die = format!(r#"die = {{ throat = "16.2 mm", shoulder = "{shoulder} mm", friction = 0 }}"#);
            let run = solved("plane_strain", &blank, &format!("[tools]\n{punch}\n{die}"));
            if run.stop.kind == StopKind::Arched {
                let (travel, ahead) = (run.end.travel, run.end.nodes[0][1] - run.end.tools[0].y - 0.5);
                assert!(travel < 20.0 && ahead > 3.0, "{elements} {shoulder}: {ahead} mm at {travel} mm");
                arches += 1;
            }
        }
    }
    assert!(arches >= 1, "{arches}");
}

/// A cup whose corrector may take two iterations and whose steps may be as short as round-off: the steps that it asks for
/// are a ten-thousandth of the planned ones.
///
/// Trust: it would take a hundred thousand steps to the end; cups that come on take about as many as planned.
#[test]
fn a_run_that_creeps_ends_soon_and_says_where() {
    let case = shipped_case("quickstart", &["solver.max_iterations=2", "solver.min_step=1e-12"]);
    let stages = solve(&case.stages, &mut ());
    let (stop, travel) = (&stages[0].stop, stages[0].end.travel);
    assert_eq!(stop.kind, StopKind::Creeping);
    let tries: usize = stop.text.split(' ').nth(1).and_then(|tries| tries.parse().ok()).expect("creeping: n tries");
    let planned = 100;
    assert!(tries > planned && tries < 10 * planned, "{tries}");
    assert!(travel > 0.0 && travel < 0.01 * case.model().travel, "{travel}");
    assert!(stop.s0.is_some_and(|s0| s0 <= case.model().blank.length) && stop.text.contains("touches"), "{stop}");
    let found = assess::after(&case, &stages);
    let run = row(&found, "stop");
    assert!(run.statement().contains("creeping") && !run.advice.is_empty(), "{run:?}");
    assert!(!stages[0].stop.is_complete() && !stages[0].stop.is_physical());
}

/// The quickstart, pushed on through its die, with and without the wish for it.
///
/// Trust: where the rim stands by the shape of the die alone, a thickness behind the end of the shoulder; the load has fallen
/// to what rubs in the throat, by the quickstart's thick rim a seventh of the peak.
#[test]
fn a_cup_that_is_to_go_through_the_die_ends_as_wished_behind_the_shoulder() {
    let run = |overrides: &[&str]| {
        let mut solution = shipped_case("quickstart", overrides).solve(&mut ());
        let run = row(&findings(&solution), "stop").clone();
        (solution.stages.remove(0), run)
    };
    let through = |travel: &'static str| run(&[travel, "stop.drawn_through=true"]);
    let (stage, judged) = through("tools.punch.travel=60 mm");
    assert!(stage.stop.kind == StopKind::LeftDie && stage.stop.is_complete(), "{}", stage.stop);
    assert!(judged.light == Light::Green && judged.statement().contains("strip it off the punch"), "{judged:?}");
    let rim = stage.end.nodes.last().expect("a rim");
    // The shoulder of 6 mm begins half a thickness above the sheet's middle. Found to a thousandth of a step of 0.6 mm.
    let end = 0.5 + 6.0 + 1.0;
    assert!(rim[1] >= end && rim[1] < end + 1e-2, "{rim:?}");
    assert!(last(&stage).punch_force < 0.2 * peak(&stage));

    let (early, judged) = run(&["tools.punch.travel=60 mm"]);
    assert!(early.stop.kind == StopKind::DrawnThrough && !early.stop.is_complete(), "{}", early.stop);
    assert_eq!(judged.light, Light::Amber, "{judged:?}");
    let (short, judged) = through("tools.punch.travel=30 mm");
    assert_eq!((short.stop.kind, judged.light), (StopKind::FullTravel, Light::Amber));
    assert!(judged.statement().contains("not through the die"), "{judged:?}");
}

/// Trust: nothing holds a punch back; the first draw's forces fade; the bend's gap is less than its sheet at the end.
#[test]
fn what_is_drawn_back_goes_all_the_way_and_what_bottoms_ends_as_closed() {
    for (name, overrides, kind, is_remedied) in [
        ("drawn_back", &[][..], StopKind::FullTravel, false),
        ("redrawn", &[], StopKind::FullTravel, false),
        ("w_bend", &["blank.elements=36", "tools.punch.travel=36.8 mm"], StopKind::ToolsClosed, true),
        ("w_bend", &["solver.min_step=5e-4"], StopKind::ToolsClosed, false),
    ] {
        let case = loaded(format!("tests/suite/stops/{name}.toml"), overrides);
        let stages = solve(&case.stages, &mut ());
        let (last, found) = (stages.last().expect("a stage"), assess::after(&case, &stages));
        let light = |key: &str| found.iter().find(|finding| finding.key == key).map(|finding| finding.light);
        assert_eq!((last.stop.kind, light("remedied").is_some()), (kind, is_remedied), "{}", last.stop);
        let deepest = last.steps.iter().map(|step| step.penetration).fold(0.0, f64::max);
        assert_eq!(light("solution_quality") == Some(Light::Red), deepest > 0.1, "{deepest}");
        assert!(last.largest_work() >= stages[0].largest_work());
    }
}
