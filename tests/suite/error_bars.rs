//! Error bars beside whatever is told of a run: numbers, lights, JSON, reports and pictures.

use crate::common::prelude::*;
use crate::scripts::json;

/// Trust: a press whose rating leaves a thousandth of room below its amber share, where the bar is some 0.6 % of the force.
#[test]
fn a_press_force_just_below_its_limit_is_amber_by_its_bar() {
    let plain = solved("quickstart");
    let force = |solution: &Solution, found: Option<&ErrorBars>| {
        let (answer, findings) = answered(solution, found);
        (answer, row(&findings, "press_force").clone())
    };
    let needed = force(plain, None).1.value().expect("a force");
    let rated = |share: f64| shipped_case("quickstart", &[&format!("press.force={} N", needed / share)]).solve(&mut ());
    let near = rated(0.799);
    let found = verify(&near, &()).bars;
    assert_eq!(force(&near, None).1.light, Light::Green);
    let (answer, row) = force(&near, Some(&found));
    assert_eq!(row.light, Light::Amber, "{row:?}");
    assert!(row.statement().starts_with("with its error bar it reaches the limit of"), "{row:?}");
    assert!(row.statement().contains('±') && row.text.contains("the finer runs give"), "{row:?}");
    assert_eq!(row.advice, "", "a remark is no change");
    assert!(answer.sentence.to_string().contains("Press force"), "{answer:?}");
    let far = rated(0.7);
    assert_eq!(force(&far, Some(&verify(&far, &()).bars)).1.light, Light::Green);
}

/// Trust: the worst place of this cup is another in the coarser run, which uses half as much again of its limit there. A few
/// percent are what the places of both runs differ by.
#[test]
fn whether_it_tears_is_said_alike_with_and_without_bars() {
    let given = [("height", "60 mm"), ("punch-radius", "40 mm"), ("shoulder", "6.5 mm")];
    let solution = made("cup", &given, &[]).solve(&mut ());
    let row = |findings: &[Finding]| row(findings, "forming_limit").clone();
    let found = verify(&solution, &()).bars;
    let (plain, (barred, findings)) = (answered(&solution, None), answered(&solution, Some(&found)));
    let tears = |answer: &Answer| answer.sentence.split(';').next().map(str::to_owned);
    assert_eq!(tears(&plain.0), tears(&barred));
    let half = found.number(Origin::Verdict, "forming_limit").expect("a number").half().expect("a bar");
    assert!(half < 30.0 && row(&findings).light == Light::Green, "{:?}", row(&findings));
}

#[test]
fn what_is_interrupted_has_no_bars_and_says_so() {
    let solution = shipped_case("quickstart", &["blank.elements=20"]).solve(&mut ());
    let found = verify(&solution, &crate::study::After(0.into(), 0)).bars;
    assert!(found.numbers.iter().all(|number| number.half().is_none()));
    assert_eq!(found.sentences(), ["no error bars: interrupted by the user"]);
    let (answer, _) = answered(&solution, Some(&found));
    assert!(!answer.numbers[0].amount.to_string().contains('±'));
}

fn numbers(value: &Value) -> Vec<(String, Option<f64>)> {
    let all = value["numbers"].as_array().expect("numbers").iter();
    all.map(|n| (n["key"].as_str().expect("a key").to_owned(), n["error_bar"].as_f64())).collect()
}

/// Those of `verify` to the last digit: of a check by default, of a run with its option.
#[test]
fn programs_read_the_bars_that_are_asked_for() {
    let dir = folder(CUP);
    let check = json(dir.path(), "check cases/cup.toml --run --json");
    assert_eq!(check["verdict"]["error_bars"]["runs"], 8);
    assert_eq!(check["verdict"]["error_bars"]["method"], "error bars from 8 finer runs");
    let told = numbers(&check["verdict"]);
    assert!(told.iter().filter(|(_, bar)| bar.is_some_and(|bar| bar > 0.0)).count() >= 4, "{told:?}");
    let blank = check["verdict"]["numbers"].as_array().expect("numbers").iter().find(|n| n["key"] == "blank");
    assert_eq!(blank.expect("a blank")["error_bar_reason"], "given, not computed");
    for row in check["verdict"]["findings"].as_array().expect("rows").iter().filter(|row| row["value"].is_number()) {
        assert!(row["error_bar"].is_number() || row["error_bar_reason"].is_string(), "{row}");
    }

    for line in ["check cases/cup.toml --run --json --no-error-bars", "run cases/cup.toml --json"] {
        let plain = json(dir.path(), line);
        assert!(!plain.to_string().contains("error_bar"), "{plain}");
    }

    let run = json(dir.path(), "run cases/cup.toml --error-bars --json");
    let of_verify = numbers(&json(dir.path(), "verify cases/cup.toml --json"));
    for (key, bar) in numbers(&run["verdict"]).into_iter().filter(|(_, bar)| bar.is_some()) {
        assert!(of_verify.contains(&(key.clone(), bar)), "{key} {bar:?} {of_verify:?}");
    }
    assert!(run["thinnest_error_bar_mm"].as_f64().is_some_and(|bar| bar > 0.0), "{run}");
}
