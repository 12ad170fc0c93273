//! Every shipped case against its references, and what those without a reference are held to.

use crate::common::cli::{stampflow, text};
use crate::common::files::files;
use serde_json::Value;
use stampflow::case;
use stampflow::solver::solve;
use std::path::Path;

/// A comparison of a case, in the order of `compare`: its quantity and what comes of it.
type Outcome = (&'static str, &'static str, &'static str);

/// Measured curves that are lost are no failure, and the demonstrations are outside of what was measured (docs/agreement.md).
const OUTCOMES: [Outcome; 13] = [
    ("brite_cylindrical", "edge_diameter", "OUT, demonstration"),
    ("brite_cylindrical", "thickness", "OUT, demonstration"),
    ("brite_four_steps", "edge_diameter", "OUT, demonstration"),
    ("brite_four_steps", "thickness", "OUT, demonstration"),
    ("chalmers_cup", "punch_force", "no data"),
    ("erichsen_304l", "peak_travel", "OUT, demonstration"),
    ("osu_stretch", "travel", "in"),
    ("osu_stretch_friction", "travel", "in"),
    ("split_ring", "ring_opening", "OUT, demonstration"),
    ("stretch_thin", "punch_force", "in"),
    ("strip_draw", "thickness_at_radius", "in"),
    ("surfalex_full_circle", "strain_path", "OUT, demonstration"),
    ("woo_hemispherical", "punch_force", "no data"),
];

/// Trust: the tolerances stand in the cases, each with its reason.
#[test]
fn every_comparison_is_within_its_tolerance() {
    let out = temp_dir::TempDir::new().unwrap();
    let out = out.path().to_str().expect("a path");
    let done = stampflow(Path::new(env!("CARGO_MANIFEST_DIR")), &["compare", "--json", "--out", out]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stdout));
    let found: Vec<Value> = serde_json::from_slice(&done.stdout).expect("JSON");
    let of = |found: &Value, key: &str| found[key].as_str().expect("a text").to_owned();
    let found: Vec<_> = found.iter().map(|one| ["case", "quantity", "verdict"].map(|key| of(one, key))).collect();
    assert_eq!(found, OUTCOMES.map(|(case, quantity, verdict)| [case, quantity, verdict].map(str::to_owned)));
}

/// Case, stage, largest punch force [N, of a whole plane section N/mm] or, where no punch presses, largest gas pressure [MPa], least
/// thickness [mm] and where it is on the flat sheet [mm], as computed when these lines were written.
const FIGURES: &[(&str, &str, f64, f64, f64)] = &[
    ("brite_cylindrical", "forming", 137208.4877, 0.636961, 137.8125),
    ("brite_four_steps", "draw", 136866.5245, 0.636932, 137.2202),
    ("brite_four_steps", "retract", 77653.1729, 0.637217, 137.2202),
    ("brite_four_steps", "lower", 0.0, 0.637217, 137.2202),
    ("brite_four_steps", "withdraw", 0.0, 0.637218, 137.2202),
    ("bulge", "forming", 9.5, 0.589803, 0.275),
    ("chalmers_cup", "forming", 100515.2657, 0.920649, 60.4294),
    ("cylindrical_bending", "bend", 9.29792392, 0.999855, 32.6250),
    ("cylindrical_bending", "release", 0.0, 0.999859, 32.625),
    ("erichsen_304l", "forming", 37119.4599, 0.305348, 3.1523),
    ("hat_springback", "draw", 62.2688, 0.76965, 36.37),
    ("hat_springback", "release", 0.0, 0.76979, 36.37),
    ("hydroform", "forming", 73814.5503, 0.933, 31.625),
    ("osu_stretch", "forming", 65043.1814, 0.528062, 4.0686),
    ("osu_stretch_friction", "forming", 9323.9569, 0.94313, 7.7674),
    ("quickstart", "forming", 45321.544, 0.94124, 28.325),
    ("split_ring", "draw", 17003.8097, 0.926281, 14.625),
    ("split_ring", "release", 0.0, 0.926775, 14.625),
    ("stages_cup", "draw", 49288.6971, 0.933999, 28.13),
    ("stages_cup", "retract", 327.9822, 0.934, 28.13),
    ("stages_cup", "draw_on", 45351.4329, 0.932771, 28.13),
    ("stretch_limit", "forming", 57295.4914, 0.530770, 29.2201),
    ("stretch_thin", "forming", 57559.9226, 0.547011, 21.0829),
    ("strip_draw", "forming", 610.1132, 0.736644, 324.2103),
    ("superplastic_box", "forming", 0.5463, 0.73713, 24.8438),
    ("superplastic_dome", "forming", 0.11585284, 0.48299, 0.25),
    ("surfalex_full_circle", "forming", 81981.6663, 0.915443, 28.665),
    ("warm_cup", "forming", 44512.5803, 0.871476, 71.5714),
    ("woo_hemispherical", "forming", 34811.8207, 0.347782, 4.9507),
    ("woo_porous", "forming", 28073.7179, 0.458321, 4.499),
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
                |of: fn(&stampflow::solver::solution::StepRecord) -> f64| run.steps.iter().map(of).fold(0.0, f64::max);
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
