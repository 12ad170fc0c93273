//! The check of a case before it is run: its numbers by hand, its doubts, its text.

use crate::common::shipped::shipped_case;
use approx::assert_relative_eq;
use stampflow::assess::check::{Check, Line, report};
use stampflow::case::Case;
use stampflow::message::{Form, NO_BREAK, System};

fn quickstart(overrides: &[&str]) -> Case {
    shipped_case("quickstart", overrides)
}

fn value(check: &Check, label: &str) -> f64 {
    let line = check.lines.iter().find(|line| line.label.to_string() == label).unwrap_or_else(|| panic!("no {label}"));
    line.number().expect("a number")
}

/// Trust: hand calculation. R_m = k n^n exp(offset − n) for Swift; flange π(55² − 37.25²) mm²; β = 55/30.
#[test]
fn numbers_of_the_quickstart_are_those_of_a_hand_calculation() {
    let check = report(&quickstart(&[]));
    let strength = 520.0 * 0.22_f64.powf(0.22) * (0.005_f64 - 0.22).exp();
    assert_relative_eq!(value(&check, "tensile strength"), strength, max_relative = 1e-4);
    let area = std::f64::consts::PI * (55.0 * 55.0 - 37.25 * 37.25);
    assert_relative_eq!(value(&check, "holder pressure"), 10_000.0 / area, max_relative = 1e-9);
    let beta: f64 = 55.0 / 30.0;
    let siebel = 0.0025 * ((beta - 1.0).powi(2) + 0.3) * strength;
    assert_relative_eq!(value(&check, "advised pressure"), siebel, max_relative = 1e-4);
    assert_relative_eq!(value(&check, "clearance"), 1.25);
    assert!(check.warnings.is_empty(), "{:?}", check.warnings);
}

#[test]
fn every_doubt_has_its_warning() {
    let doubts: [(&[&str], &str); 8] = [
        (&["material.hardening.swift.k=520 kPa"], "check the unit of the law's stresses"),
        (&["tools.holder.force=10 MN"], "more than the sheet's tensile strength"),
        (&["tools.die.shoulder=4 mm"], "beyond thin-shell theory"),
        (&["tools.die.friction=0.4"], "above that of dry steel"),
        (&["blank.elements=20"], "elements per 90°"),
        (&["blank.radius=70 mm"], "draw ratio of 2.33"),
        (&["tools.punch.travel=40 mm"], "drawn through the die"),
        (&["blank.theory=membrane", "tools.die.shoulder=4 mm"], "membrane theory leaves out"),
    ];
    for (overrides, wanted) in doubts {
        let check = report(&quickstart(overrides));
        assert!(check.warnings.iter().any(|w| w.to_string().contains(wanted)), "{overrides:?}: {:?}", check.warnings);
    }
    let weak = report(&quickstart(&["material.hardening.swift.k=520 kPa"]));
    assert!(
        !weak.warnings.iter().any(|w| w.to_string().contains("its force")),
        "the holder is not to blame: {:?}",
        weak.warnings
    );
}

#[test]
fn report_reads_as_text_with_notes() {
    let text = report(&quickstart(&[])).to_string();
    for wanted in ["Steel cup", "  blank             Ø 110 mm", "notes\n  - declared: ", "Swift, σ = 520", "Siebel"] {
        assert!(text.contains(wanted), "{wanted} not in\n{text}");
    }
}

/// Trust: rounded by hand; 206 GPa are 29 877.8 ksi, 110.0246 mm 4.3317 in, 31.256 mm twice 2.4611 in.
#[test]
fn sizes_have_the_digits_of_drawings() {
    let sizes = ["blank.radius=55.0123 mm", "tools.punch.travel=12.3456 mm", "tools.die.throat=31.256 mm"];
    let elastic = ["material.mode=elasto_viscoplastic", "material.young=206 GPa", "material.poisson=0.3"];
    let check = report(&quickstart(&[&sizes[..], &elastic[..]].concat()));
    let (si, us) = (Form::default(), Form { system: System::Us, ..Form::default() });
    let told = |lines: &[Line], label: &str, form: Form| {
        let line = lines.iter().find(|line| line.label.to_string() == label).unwrap_or_else(|| panic!("no {label}"));
        line.value.told(form).replace(NO_BREAK, " ")
    };
    for (label, expected) in [
        ("blank", ["Ø 110 mm", "Ø 4.332 in"]),
        ("travel", ["12.3 mm", "0.486 in"]),
        ("die", ["Ø 62.51 mm", "Ø 2.461 in"]),
        ("clearance", ["1.26 mm", "0.049 in"]),
    ] {
        assert_eq!([si, us].map(|form| told(&check.lines, label, form)), expected, "{label}");
    }
    assert_eq!([si, us].map(|form| told(&check.details, "Young's modulus", form)), ["206000 MPa", "29900 ksi"]);
}
