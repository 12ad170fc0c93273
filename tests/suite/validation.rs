//! Every shipped case against its references, and what those without a reference are held to.

use crate::common::cli::{stampflow, text};
use crate::common::files::files;
use serde_json::Value;
use stampflow::case;
use stampflow::solver::solve;
use std::path::Path;

/// A comparison of a case, in the order of `validate`: its quantity and what comes of it.
type Outcome = (&'static str, &'static str, &'static str);

/// Measured curves that are lost are no failure, and the demonstrations are outside of what was measured (README).
const OUTCOMES: [Outcome; 10] = [
    ("brite_cylindrical", "edge_diameter", "OUT, demonstration"),
    ("brite_cylindrical", "thickness", "OUT, demonstration"),
    ("brite_four_steps", "edge_diameter", "OUT, demonstration"),
    ("brite_four_steps", "thickness", "OUT, demonstration"),
    ("chalmers_cup", "punch_force", "no data"),
    ("osu_stretch", "travel", "in"),
    ("osu_stretch_friction", "travel", "in"),
    ("stretch_thin", "punch_force", "in"),
    ("strip_draw", "thickness_at_radius", "in"),
    ("woo_hemispherical", "punch_force", "no data"),
];

/// Trust: the tolerances stand in the cases, each with its reason.
#[test]
fn every_comparison_is_within_its_tolerance() {
    let out = temp_dir::TempDir::new().unwrap();
    let out = out.path().to_str().expect("a path");
    let done = stampflow(Path::new(env!("CARGO_MANIFEST_DIR")), &["validate", "--json", "--out", out]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stdout));
    let found: Vec<Value> = serde_json::from_slice(&done.stdout).expect("JSON");
    let of = |found: &Value, key: &str| found[key].as_str().expect("a text").to_owned();
    let found: Vec<_> = found.iter().map(|one| ["case", "quantity", "verdict"].map(|key| of(one, key))).collect();
    assert_eq!(found, OUTCOMES.map(|(case, quantity, verdict)| [case, quantity, verdict].map(str::to_owned)));
}

/// Case, stage, largest punch force [N, plane strain N/mm] or, where no punch presses, largest gas pressure [MPa], least
/// thickness [mm] and where it is on the flat sheet [mm], as computed when these lines were written.
const FIGURES: &[(&str, &str, f64, f64, f64)] = &[
    ("brite_cylindrical", "forming", 136689.86049434, 0.640298, 137.8125),
    ("brite_four_steps", "draw", 136334.916, 0.639805, 138.3983),
    ("brite_four_steps", "retract", 77128.3643, 0.640692, 138.3983),
    ("brite_four_steps", "lower", 0.0, 0.640693, 138.3983),
    ("brite_four_steps", "withdraw", 0.0, 0.640693, 138.3983),
    ("bulge", "forming", 9.5, 0.585596, 0.275),
    ("chalmers_cup", "forming", 100544.081, 0.930285, 57.9755),
    ("cylindrical_bending", "bend", 4.6075, 0.999999, 38.875),
    ("cylindrical_bending", "release", 0.0, 1.0, 42.125),
    ("hat_springback", "draw", 31.4404, 0.771904, 31.714),
    ("hat_springback", "release", 0.0, 0.772042, 31.714),
    ("hydroform", "forming", 73918.9677, 0.938227, 32.175),
    ("osu_stretch", "forming", 65881.796, 0.532781, 3.3289),
    ("osu_stretch_friction", "forming", 9351.1563, 0.944622, 7.7674),
    ("quickstart", "forming", 45454.3062, 0.942579, 26.125),
    ("stages_cup", "draw", 49582.4255, 0.938704, 25.81),
    ("stages_cup", "retract", 342.7898, 0.938704, 25.81),
    ("stages_cup", "draw_on", 45474.4124, 0.937165, 25.81),
    ("stretch_limit", "forming", 47620.283, 0.51194, 9.9866),
    ("stretch_thin", "forming", 58125.283, 0.551223, 21.8226),
    ("strip_draw", "forming", 304.8566, 0.743322, 332.0643),
    ("superplastic_box", "forming", 0.55780945, 0.73034, 29.5312),
    ("superplastic_dome", "forming", 0.11585284, 0.48299, 0.25),
    ("warm_cup", "forming", 44786.9765, 0.893923, 70.7143),
    ("woo_hemispherical", "forming", 35198.306, 0.608164, 4.9507),
    ("woo_porous", "forming", 30070.6945, 0.522969, 4.499),
];

/// What a figure may move by without a decision. The corrector's tolerance leaves 1e-5 of a force open, and one step more or
/// less, as another machine's last digits may bring about, 1e-4 of it; a friction or a law that is wrong by 1 % moves forces by
/// more than this.
const MOVE: f64 = 5e-4;

/// Trust: no reference, but a record: a change that moves these figures says so and why.
#[test]
fn forces_and_thinnest_places_are_those_on_record() {
    let mut record = FIGURES.iter();
    let mut moved = Vec::new();
    for path in files("cases", "toml") {
        let case = case::load(&path, &[]).unwrap_or_else(|e| panic!("{e}"));
        let stages = &case.stages;
        for (stage, pass) in stages.iter().zip(solve(stages, &mut ())) {
            let &(name, label, peak, thinnest, place) = record.next().expect("a line for every stage");
            assert_eq!((case.name.as_str(), stage.name.as_str()), (name, label));
            let run = &pass;
            assert!(run.stop.is_complete() || run.stop.is_physical(), "{name} {label}: {}", run.stop);
            let largest =
                |of: fn(&stampflow::solution::StepRecord) -> f64| run.steps.iter().map(of).fold(0.0, f64::max);
            let force = largest(|r| r.punch_force);
            let found = if force > 1.0 { force } else { largest(|r| r.pressure) };
            let last = run.steps.last().expect("steps");
            // Beside a flat minimum the next element may be as thin.
            let spacing = 1.5 * pass.model.blank.length / pass.model.blank.elements as f64;
            let same = (found - peak).abs() <= MOVE * peak
                && (last.thinnest - thinnest).abs() <= MOVE * thinnest
                && (last.thinnest_s0 - place).abs() <= spacing;
            if !same {
                moved.push(format!(
                    "(\"{name}\", \"{label}\", {found:.8}, {:.6}, {:.4}),",
                    last.thinnest, last.thinnest_s0
                ));
            }
        }
    }
    assert!(moved.is_empty() && record.next().is_none(), "{}", moved.join("\n"));
}
