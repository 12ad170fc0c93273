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
    ("bulge", "forming", 9.50000000, 0.587500, 0.2750),
    ("chalmers_cup", "forming", 100484.20732773, 0.931108, 57.3620),
    ("cylindrical_bending", "bend", 4.59466099, 0.999999, 38.8750),
    ("cylindrical_bending", "release", 0.00000000, 1.000000, 35.8750),
    ("hat_springback", "draw", 31.46754575, 0.771898, 31.7140),
    ("hat_springback", "release", 0.0, 0.772042, 31.714),
    ("hydroform", "forming", 73956.26577572, 0.940088, 32.1750),
    ("osu_stretch", "forming", 65867.37164927, 0.530254, 4.0686),
    ("osu_stretch_friction", "forming", 9369.56761656, 0.944512, 7.7674),
    ("quickstart", "forming", 45370.41857328, 0.946506, 28.8750),
    ("stages_cup", "draw", 49597.59381001, 0.939681, 28.7100),
    ("stages_cup", "retract", 362.43775111, 0.939683, 28.7100),
    ("stages_cup", "draw_on", 46490.25464412, 0.938212, 28.7100),
    ("stretch_limit", "forming", 47629.65522557, 0.511160, 9.9866),
    ("stretch_thin", "forming", 58112.2179, 0.550804, 21.8226),
    ("strip_draw", "forming", 304.8603, 0.743407, 328.1373),
    ("superplastic_box", "forming", 0.57158303, 0.728286, 29.2188),
    ("superplastic_dome", "forming", 0.11583373, 0.482827, 0.25),
    ("warm_cup", "forming", 44619.04748110, 0.889770, 71.5714),
    ("woo_hemispherical", "forming", 35094.53635919, 0.607320, 4.9507),
    ("woo_porous", "forming", 30010.74902122, 0.519500, 4.4990),
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
