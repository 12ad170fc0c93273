//! Sizes that hardly fit a stamping are doubted by `check` and by `new`, by one set of rules.

use crate::common::cli::{CUP, stampflow};
use crate::common::files::files;
use stampflow::assess::SIZE_CHECKS;
use stampflow::assess::check::report;
use stampflow::case;

/// What `check` warns of in the cup of these tests with overrides.
fn warnings(overrides: &[&str]) -> Vec<String> {
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    let case = case::parse(CUP, "cup.toml", &overrides).unwrap_or_else(|error| panic!("{error}"));
    report(&case).warnings.iter().map(|warning| warning.to_string().replace('\u{a0}', " ")).collect()
}

/// Trust: by hand: 2 · 55 mm over 0.03 mm is 3667; a ratio of 3.67 is out of reach and its half is not; half of 62.5 mm leaves
/// 1.25 mm beside a punch of 30 mm.
#[test]
fn check_doubts_sizes() {
    for (overrides, says) in [
        (&["blank.thickness=0.03 mm", "tools.die.throat=30.04 mm"][..], "the blank is 3670 thicknesses wide"),
        (
            &["blank.radius=110 mm"],
            "the blank's radius of 110 mm is 3.67 times the punch's: is 110 mm the diameter? Then the radius is 55 mm",
        ),
        (
            &["blank.radius=79 mm", "tools.die.throat=62.5 mm", "tools.holder.inner_radius=69 mm"],
            "between punch and die's throat of 62.5 mm there is room for 32.5 sheets: is 62.5 mm the diameter",
        ),
        (
            &["blank.radius=1600 mm"],
            "the blank is 3200 mm wide, which is odd for a stamping: is the unit of its size right?",
        ),
    ] {
        let found = warnings(overrides);
        assert!(found.iter().any(|warning| warning.contains(says)), "{says} is not in {found:#?}");
        assert!(!warnings(&[]).iter().any(|warning| warning.contains(says)));
    }
}

/// What is shipped has the sizes of stampings.
#[test]
fn no_shipped_case_is_doubted() {
    let cases = files("cases", "toml");
    assert!(cases.len() > 10);
    for path in cases {
        let case = case::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
        let doubts: Vec<_> = SIZE_CHECKS.iter().filter_map(|check| check(case.model())).collect();
        assert!(doubts.is_empty(), "{}: {doubts:?}", path.display());
    }
}

/// Metres for millimetres are refused with what to try; a foil is doubted and written all the same.
#[test]
fn new_refuses_what_is_absurd_and_doubts_what_is_odd() {
    let dir = temp_dir::TempDir::new().unwrap();
    let done = stampflow(dir.path(), &["new", "cup", "--punch-radius", "8 m", "--trim", "8 %", "-o", "cup.toml"]);
    let said = String::from_utf8(done.stderr).unwrap().replace("\n  │ ", " ");
    assert_eq!(done.status.code(), Some(2), "{said}");
    for says in ["stampings are up to 3000 mm", "given: --punch-radius \"8 m\""] {
        assert!(said.contains(says), "{says} is not in\n{said}");
    }
    assert!(!dir.path().join("cup.toml").exists());
    let foil = ["--thickness", "0.009 mm", "--nose", "3 mm", "--shoulder", "3 mm", "--trim", "8 %"];
    let done = stampflow(dir.path(), &[&["new", "cup", "-o", "foil.toml"], &foil[..]].concat());
    let said = String::from_utf8(done.stderr).unwrap().replace('\u{a0}', " ");
    assert_eq!(done.status.code(), Some(0), "{said}");
    assert!(said.contains("warning: the sheet is 0.009 mm thick, thinner than foil"), "{said}");
    assert!(said.contains("thicknesses wide"), "{said}");
    assert!(dir.path().join("foil.toml").exists());
    let plain = stampflow(dir.path(), &["new", "cup", "--trim", "8 %"]);
    assert!(plain.stderr.is_empty());
}
