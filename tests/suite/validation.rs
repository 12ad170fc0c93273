//! Every shipped case against its references, and what those without a reference are held to.

use crate::common::cli::{stampflow, text};
use serde_json::Value;
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
