//! The check of a case before it is run: its numbers by hand, its doubts, its text.

use crate::common::prelude::*;
use stampflow::assess::{SIZE_CHECKS, before, check::Check, check::report};

pub fn value(check: &Check, label: &str) -> f64 {
    let line = check.lines.iter().find(|line| line.label == label).unwrap_or_else(|| panic!("no {label}"));
    line.number.expect("a number")
}

/// Trust: hand calculation. R_m = k n^n exp(offset − n) for Swift; flange π(55² − 37.25²) mm²; β = 55/30.
#[test]
fn numbers_of_the_quickstart_are_those_of_a_hand_calculation() {
    let check = report(&shipped_case("quickstart", &[]));
    let strength = 520.0 * 0.22_f64.powf(0.22) * (0.005_f64 - 0.22).exp();
    assert_relative_eq!(value(&check, "tensile strength"), strength, max_relative = 1e-4);
    let area = PI * (55.0 * 55.0 - 37.25 * 37.25);
    assert_relative_eq!(value(&check, "holder pressure"), 10_000.0 / area, max_relative = 1e-9);
    let beta: f64 = 55.0 / 30.0;
    let siebel = 0.0025 * ((beta - 1.0).powi(2) + 0.3) * strength;
    assert_relative_eq!(value(&check, "least pressure"), siebel, max_relative = 1e-4);
    assert_relative_eq!(value(&check, "clearance"), 1.25);
    assert!(check.warnings.is_empty(), "{:?}", check.warnings);
}

#[test]
fn every_doubt_has_its_warning() {
    let doubts: [(&[&str], &str); 7] = [
        (&["material.hardening.swift.k=520 kPa"], "strength"),
        (&["tools.holder.force=10 MN"], "holder_pressure"),
        (&["tools.die.shoulder=4 mm"], "tool_radius"),
        (&["tools.die.friction=0.4"], "dry_friction"),
        (&["blank.elements=20"], "mesh"),
        (&["blank.radius=70 mm"], "draw_ratio"),
        (&["blank.thickness=0.03 mm", "tools.die.throat=30.04 mm"], "slenderness"),
    ];
    for (overrides, key) in doubts {
        let found = before(&shipped_case("quickstart", overrides));
        assert!(found.iter().any(|finding| finding.key == key), "{overrides:?}: {found:?}");
    }
    // A weak law is to blame, not the holder.
    let weak = before(&shipped_case("quickstart", &["material.hardening.swift.k=520 kPa"]));
    assert!(weak.iter().all(|finding| finding.key != "holder_pressure"), "{weak:?}");
}

#[test]
fn no_shipped_case_is_doubted() {
    let cases = files("cases", "toml");
    assert!(cases.len() > 10);
    for path in cases {
        let case = loaded(&path, &[]);
        let doubts: Vec<_> = SIZE_CHECKS.iter().filter_map(|check| check(case.model())).collect();
        assert!(doubts.is_empty(), "{}: {doubts:?}", path.display());
    }
}
