use super::*;

fn settings(text: &str) -> Result<Vec<Vec<String>>, StudyError> {
    let variables = Variable::read_together(text)?;
    variables.iter().map(|v| Ok(v.values()?.iter().map(|value| v.setting(value)).collect())).collect()
}

/// Trust: by hand.
#[test]
fn ranges_and_lists_give_the_overrides_that_a_user_would_type() {
    for (text, expected) in [
        ("a.b=4..10 mm/4", vec!["a.b=4 mm", "a.b=6 mm", "a.b=8 mm", "a.b=10 mm"]),
        ("k=0.1 .. 0.3/3", vec!["k=0.1", "k=0.2", "k=0.3"]),
        ("k=1..100 GPa/3 log", vec!["k=1 GPa", "k=10 GPa", "k=100 GPa"]),
        ("friction=0.04,0.08", vec!["friction=0.04", "friction=0.08"]),
        ("f=0,5,10 kN", vec!["f=0 kN", "f=5 kN", "f=10 kN"]),
        ("material=dc04,\"dc06\"", vec!["material=\"dc04\"", "material=\"dc06\""]),
        ("f=1e3,2E+3 N", vec!["f=1e3 N", "f=2E+3 N"]),
    ] {
        assert_eq!(settings(text).unwrap_or_else(|error| panic!("{error}")), [expected]);
    }
    assert_eq!(settings("a=1,3 mm & b=2,6 kN").expect("values")[1], ["b=2 kN", "b=6 kN"]);
    let range = Variable::read("a.k = 500 in 300 .. 800 MPa").expect("a range").search_range().expect("a range");
    assert_eq!((range.start, range.ends), (Some(500.0), [300.0, 800.0]));
    let header = |text: &str| Variable::read(text).expect("a variable").header();
    assert_eq!((header("a.b=1,2 N/mm").as_str(), header("friction=0.1").as_str()), ("a.b_N_per_mm", "friction"));
}

/// Trust: each is wrong in the way that its message says.
#[test]
fn bad_ranges_and_lists_are_refused() {
    for (text, says) in [
        ("tools.die.shoulder", "gives no key values"),
        ("a=4..10 mm", "does not say how many"),
        ("a=4..10 mm/1", "has 1 values"),
        ("a=4..4 mm/3", "has no width"),
        ("a=4 in..10 mm/3", "has two units, in and mm"),
        ("a=0..10 mm/3 log", "has no logarithms"),
        ("a=4..10 mmm/3", "mmm"),
        ("a=4,,6 mm", "a value is missing"),
        ("a=4 in,6 mm", "two units"),
        ("a=x..3/4", "does not begin with a number"),
        ("a=5 in 1..3", "does not hold its start"),
        ("friction=0,04", "a decimal comma, or two values, in `0,04`\n  help: write a point, 0.04"),
        ("friction=0,04..0,12/3", "a decimal comma in `0,04..0,12/3`\n  help: write a point: 0.04..0.12/3"),
    ] {
        let error = settings(text).expect_err(text).to_string();
        assert!(error.contains(says), "{text}: {error}");
    }
}
