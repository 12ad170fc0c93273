//! Every shipped case against its references, and what those without a reference are held to.

use crate::common::prelude::*;

/// Measured curves that are lost are no failure, and the demonstrations are outside of what was measured (docs/agreement.md).
///
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
    let mut golden = csv::Reader::from_reader(include_str!("../golden/comparisons.csv").as_bytes());
    let expected: Vec<[String; 3]> = golden.deserialize().map(|row| row.expect("a row")).collect();
    assert_eq!(found, expected);
}
