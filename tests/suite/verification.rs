//! Error bars: that the truth lies inside them, and how they are told.

use crate::common::{coverage::case_of, coverage::check, coverage::last_digits, prelude::*, random_die::random_die};
use stampflow::assess::error_bars::Number;

fn half(bars: &ErrorBars, origin: Origin, key: &str) -> f64 {
    bars.number(origin, key).and_then(Number::half).unwrap_or_else(|| panic!("{key} has a bar"))
}

/// Trust: the truth is what each direction comes to that is refined eight times. Sharp is a bar that a press shop would
/// call one number: 2 % of the peak, which Woo's cup passes before it necks.
#[test]
fn the_bars_of_woos_cup_are_sharp_and_hold_the_truth() {
    let checked = check(shipped_case("woo_hemispherical", &[]));
    for number in &checked.full.numbers {
        let (Some(half), Some(truth)) = (number.half(), checked.truth(number)) else { continue };
        let (key, value) = (number.quantity.key, number.quantity.amount.value);
        let error = (truth - value).abs();
        assert!(error <= half, "{key}: {error} is beyond {half}");
    }
    for (origin, key) in [(Origin::Answer, "punch_force"), (Origin::Part, "half_travel_force")] {
        let value = checked.full.number(origin, key).expect("a force").quantity.amount.value;
        assert!(half(&checked.full, origin, key) < 0.02 * value, "{key}");
    }
}

/// Trust: the bench `coverage` has 95 % and more in 300 dies; of 6 dies one number in ten may be missed.
#[test]
fn the_truth_lies_inside_the_bars_of_six_random_dies() {
    let checked: Vec<_> = (60_000..60_006).map(|seed| check(case_of(random_die(seed).model))).collect();
    let is_inside = |(one, truth): (&Number, f64)| Some((truth - one.quantity.amount.value).abs() <= one.half()?);
    let inside: Vec<bool> = checked.iter().flat_map(|one| one.with_truth()).filter_map(is_inside).collect();
    let share = inside.iter().filter(|is_inside| **is_inside).count() as f64 / inside.len() as f64;
    assert!(inside.len() > 30 && share >= 0.9, "{share} of {}", inside.len());
}

/// Trust: `benches/measured.sh digits` has all shipped cases; these are the fastest. The last digit is sure within two units.
#[test]
fn a_run_prints_digits_that_are_sure() {
    let cases = ["quickstart", "osu_stretch", "chalmers_cup"];
    let printed: Vec<_> = cases.iter().flat_map(|name| last_digits(shipped_case(name, &[]))).collect();
    let sure = printed.iter().filter(|(.., units)| *units <= 2.0).count();
    assert!(printed.len() > 12 && 4 * sure >= 3 * printed.len(), "{printed:?}");
}

#[test]
fn a_file_has_the_numbers_of_every_run_and_replaces_only_its_own_kind() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = temp_dir::TempDir::new().expect("a folder");
    let out = dir.path().to_string_lossy().into_owned();
    let args = ["verify", "cases/quickstart.toml", "--set", "blank.elements=30", "--quiet", "--json", "--out", &out];
    for _ in 0..2 {
        let done = stampflow(root, &args);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        let value: serde_json::Value = serde_json::from_slice(&done.stdout).expect("JSON");
        assert_eq!(value["runs"].as_array().map(Vec::len), Some(9));
        let force = value["numbers"].as_array().expect("numbers").iter().find(|n| n["key"] == "punch_force");
        assert!(force.expect("a force")["error_bar"].as_f64().is_some_and(|bar| bar > 0.0));
    }
    let file = dir.path().join("verification.csv");
    let table = fs::read_to_string(&file).expect("a table");
    let mut lines = table.lines();
    let header = lines.next().expect("a header");
    assert!(header.starts_with("told_by,quantity,unit,value,error_bar,") && header.contains(",elements_2"), "{header}");
    let columns = header.split(',').count();
    assert!(lines.all(|line| line.split(',').count() == columns), "{table}");
    fs::write(&file, "mine").expect("writable");
    assert_eq!(stampflow(root, &args).status.code(), Some(2));
    assert_eq!(fs::read_to_string(&file).expect("there"), "mine");
}
