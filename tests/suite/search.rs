//! Searches against what is known: limits of a condition, wanted values, named goals, bad requests.

use crate::common::prelude::*;
use crate::study::{base, run, sweep};
use stampflow::study::{Condition, Run, Side};

fn request(vary: &str, condition: Option<&str>, target: Option<&str>, side: Option<Side>) -> SearchRequest {
    let text = |text: Option<&str>| text.map(str::to_owned);
    SearchRequest {
        vary: Some(vary.to_owned()),
        condition: text(condition),
        target: text(target),
        side,
        ..SearchRequest::default()
    }
}

fn search(base: BaseCase, request: &SearchRequest) -> Result<(LimitSearch, RunTable), StudyError> {
    let mut search = LimitSearch::new(base, request)?;
    let table = run(&mut search, 2, &());
    Ok((search, table))
}

/// Trust: the force rises with the friction, so that the limit is where it is reached: the run inside keeps it, the one beyond not.
#[test]
fn a_limit_is_bracketed_by_runs_on_both_sides() {
    let asked = request("friction=0.02..0.2", Some("punch_force < 45 kN"), None, Some(Side::Largest));
    let (search, table) = search(base(&[]), &asked).expect("a search");
    let (found, best, other) = search.result(&table);
    let Bracket::Between([inner, outer]) = found else { panic!("{found:?}") };
    assert!(inner < outer && outer - inner <= 0.005 * 0.18 * 1.001, "{inner} {outer}");
    let force = table.response("punch_force").expect("a force");
    let of = |run: Option<usize>| table.runs[run.expect("a run")].numbers[force];
    assert!(of(best) < 45e3 && of(other) >= 45e3, "{} {}", of(best), of(other));
    let headline = search.report(&table).headline;
    assert!(headline.contains("holds up to"), "{headline}");
}

/// Trust: the wanted force is that of a run with a known friction.
#[test]
fn a_target_gives_back_the_value_that_makes_it() {
    let known = run(&mut sweep(&["friction=0.1"], false).expect("a sweep"), 1, &());
    let force = known.runs[0].numbers[known.response("punch_force").expect("a force")];
    let asked = request("friction=0.02..0.2", None, Some(&format!("punch_force={force} N")), None);
    let (search, table) = search(base(&[]), &asked).expect("a search");
    let (_, best, _) = search.result(&table);
    let found = table.runs[best.expect("a run")].value(0);
    assert!((found - 0.1).abs() < 1e-3, "{found}");
    assert!(table.runs.len() < 20, "{}", table.runs.len());
    let again = |threads| run(&mut LimitSearch::new(base(&[]), &asked).expect("a search"), threads, &()).csv();
    assert!(again(1) == table.csv() && again(8) == table.csv(), "it depends on the number of threads");
    let asked = request("friction=0.05..0.1/3", None, Some("punch_force=1 MN"), None);
    let mut beyond = LimitSearch::new(base(&[]), &asked).expect("a search");
    let table = run(&mut beyond, 2, &());
    let report = beyond.report(&table);
    assert!(!report.found && report.headline.contains("1000 kN is not reached: 4"), "{}", report.headline);
}

/// Trust: by hand.
#[test]
fn a_key_is_given_once() {
    for (set, vary, says) in [
        ("blank.elements=32", "friction=0.05..0.1 & friction=0.1..0.2", "friction is varied twice"),
        ("friction=0.3", "friction=0.05..0.1", "`friction=0.3` has no effect"),
        ("tools.punch.friction=0.3", "friction=0.05..0.1", "`tools.punch.friction=0.3` has no effect"),
        ("blank.elements=32", "tools.die.friction=0.1..0.3 & friction=0.1..0.3", "die.friction=0.2` has no effect"),
    ] {
        let asked = request(vary, Some("no red"), None, Some(Side::Largest));
        let refused = LimitSearch::new(base(&[set]), &asked).expect_err(vary).to_string();
        assert!(refused.contains(says), "{refused}");
    }
}

/// Trust: no blank of a cup with a soft condition fails, none of a hard one holds.
#[test]
fn a_search_without_a_limit_says_so() {
    for (condition, expected) in [("punch_force < 1 MN", true), ("punch_force < 1 N", false)] {
        let asked = request("friction=0.05..0.1/3", Some(condition), None, Some(Side::Largest));
        let (search, table) = search(base(&[]), &asked).expect("a search");
        let (found, ..) = search.result(&table);
        assert_eq!(search.report(&table).found, expected);
        assert_eq!(found, if expected { Bracket::Everywhere(0.1) } else { Bracket::Nowhere });
    }
}

/// Trust: by hand.
#[test]
fn conditions_judge_lights_tears_and_quantities() {
    let table = run(&mut sweep(&["friction=0.08"], false).expect("a sweep"), 1, &());
    let force = table.response("punch_force").expect("a force");
    let with = |red: &[&str], amber: &[&str], newtons: f64, torn: bool| {
        let mut run = table.runs[0].clone();
        (run.red, run.amber) = (owned(red), owned(amber));
        run.failures = if torn { vec![stampflow::study::FailureMode::Tears] } else { Vec::new() };
        run.numbers[force] = newtons;
        run
    };
    let holds = |text: &str, run: &Run| {
        let mut condition = Condition::read(text).unwrap_or_else(|error| panic!("{error}"));
        condition.resolve(&table).unwrap_or_else(|error| panic!("{error}"));
        condition.holds(run)
    };
    for (text, run, expected) in [
        ("no red", with(&[], &["thinning"], 1.0, false), Some(true)),
        ("no red or amber", with(&[], &["thinning"], 1.0, false), Some(false)),
        ("thinning not red", with(&["wrinkling"], &[], 1.0, false), Some(true)),
        ("thinning is not red or amber", with(&[], &["thinning"], 1.0, false), Some(false)),
        ("no tear", with(&["localisation"], &[], 1.0, true), Some(false)),
        ("no tear and no wrinkles", with(&["wrinkling"], &[], 1.0, false), Some(true)),
        ("no wrinkles", with(&["localisation"], &[], 1.0, true), Some(true)),
        ("punch_force < 2 kN", with(&[], &[], 1999.0, false), Some(true)),
        ("punch force >= 2 kN", with(&[], &[], 2000.0, false), Some(true)),
        ("punch_force > 2 kN", with(&[], &[], 2000.0, false), Some(false)),
        ("punch_force < 2 kN", with(&[], &[], 1.0, true), Some(false)),
        ("no red and punch_force < 2 kN", with(&["energy"], &[], 1.0, false), Some(false)),
        ("punch_force < 2 kN", with(&[], &[], f64::NAN, false), None),
    ] {
        assert_eq!(holds(text, &run), expected, "{text}");
    }
}

/// Trust: Siebel's pressure on every blank. 4ming has 2.0 for DC04 and a punch of 100 mm, textbooks 2.0 to 2.2.
#[test]
fn the_limiting_draw_ratio_has_its_holder_by_the_rule() {
    for (row, diameter, set) in [
        ("cup of DC04, Ø 60 mm, as `new` has it", 60.0, &[][..]),
        ("friction of 0.12", 60.0, &["friction=0.12"]),
        (
            "friction of 0.12 under the holder and on the die",
            60.0,
            &["tools.holder.friction=0.12", "tools.die.friction=0.12"],
        ),
        ("nose of 3 thicknesses", 60.0, &["tools.punch.flat.nose=3 mm"]),
        ("Ø 100 mm", 100.0, &[]),
    ] {
        let sizes = [("material", "drawing-steel"), ("punch-diameter", &format!("{diameter} mm"))];
        let text = find("cup").and_then(|cup| cup.fill(&sizes)).unwrap_or_else(|error| panic!("{error}"));
        let base = BaseCase::from_text(text, "cup.toml", owned(set)).unwrap_or_else(|error| panic!("{error}"));
        let request = SearchRequest { goal: Some("limiting-draw-ratio".into()), ..SearchRequest::default() };
        let (search, table) = search(base, &request).unwrap_or_else(|error| panic!("{error}"));
        assert!(table.runs.iter().all(|run| !run.red.contains(&"wrinkling".to_owned())), "{row}");
        assert!(table.runs.iter().all(|run| !run.amber.contains(&"trim_allowance".to_owned())), "{row}");
        let notes = search.report(&table).notes;
        assert!(notes.iter().any(|note| note.contains("Siebel's rule")), "{row}: {notes:?}");
        let (Bracket::Between([radius, _]), ..) = search.result(&table) else { panic!("{row}: {notes:?}") };
        let ratio = radius / (0.5 * diameter);
        assert!((2.0..2.3).contains(&ratio), "{row}: {ratio}");
        agreement(row, &[format!("{ratio:.2}")]);
    }
}
