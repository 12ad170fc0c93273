//! Friction that a verdict hangs on, and advice that keeps its word.

#[path = "../../benches/common/verdicts.rs"]
mod verdicts;

use crate::common::prelude::*;
use stampflow::{assess::advice, study::judge};

fn solved(overrides: &[&str]) -> Solution {
    shipped_case("quickstart", overrides).solve(&mut ())
}

fn row(solution: &Solution, has_advice: bool, key: &str) -> Finding {
    shipped::row(&judge(solution, None, has_advice, &()).1, key).clone()
}

/// Trust: a press that is used to 80 % between the forces of friction 0.08 and 0.10; with a larger one nothing changes.
#[test]
fn friction_is_amber_if_a_line_hangs_on_it() {
    let [own, more] = ["friction=0.08", "friction=0.1"]
        .map(|friction| row(&solved(&[friction]), false, "press_force").value().expect("a force"));
    assert!(more > 1.01 * own, "{own} {more}");
    for (rating, light, text) in [
        (0.5 * (own + more) / 0.8, Light::Amber, "0.08; at 0.1 Press force is amber"),
        (2.0 * more, Light::Green, "0.08 ± 0.02; changes no line of the verdict"),
    ] {
        let friction = row(&solved(&[&format!("press.force={rating} N")]), false, "friction");
        assert_eq!((friction.light, friction.statement().as_str()), (light, text));
    }
    let case = shipped_case("quickstart", &[]);
    let notes = assess::sentences(&assess::before(&case), Kind::Assumption);
    assert!(notes.iter().any(|note| note.contains("has no `source`")), "{notes:?}");
    assert_eq!(judge(&case.solve(&mut ()), None, true, &()).0.light, Light::Green);
}

/// Trust: the fit ends far below the strain of the rim; less hardening asks for less force, a third at most.
#[test]
fn hardening_beyond_its_fit_is_judged_by_a_run_with_half_of_it() {
    let fitted = "material.fitted_up_to=0.1";
    let force = row(&solved(&[]), false, "press_force").value().expect("a force");
    for (rating, text) in [(2.0 * force, "changes no line"), (force / 0.81, "beyond 0.1 Press force is green")] {
        let solution = solved(&[fitted, &format!("press.force={rating} N")]);
        let found = row(&solution, false, "hardening_range");
        assert!(found.light == Light::Green && found.text.contains(text), "{found:?}");
        let quick = assess::after(&solution.case, &solution.stages);
        assert!(quick.iter().any(|row| row.key == found.key && row.light == Light::Grey));
    }
}

/// Trust: each advice is set in the case by its words, which is solved and judged again.
#[test]
fn advice_does_what_it_says() {
    let solution = solved(&["tools.holder.force=2 kN", "tools.punch.travel=10 mm"]);
    assert_eq!(row(&solution, false, "wrinkling").advice, "");
    let advised = row(&solution, true, "wrinkling").advice;
    let all: Vec<&str> = advised.split("; or ").collect();
    assert!(!advised.is_empty() && all.len() <= 3, "{advised}");
    let keys = [
        ("holder force", "tools.holder.force"),
        ("die radius", "tools.die.shoulder"),
        ("blank radius", "blank.radius"),
    ];
    for (i, text) in all.into_iter().enumerate() {
        let (change, gain) = text.split_once(": ").expect("a change and its gain");
        let (words, key) = keys.iter().find(|(words, _)| change.starts_with(words)).unwrap_or_else(|| panic!("{text}"));
        let set = format!("{key}={}", change.strip_prefix(words).expect("words").trim());
        let new = row(&parsed(&solution.case.text, &[&set]).solve(&mut ()), false, "wrinkling");
        let amount = new.quantity.as_ref().expect("an index").amount;
        assert!(gain.ends_with(&format!("→ {amount}")), "{text}: {new:?}");
        assert!(i > 0 || new.light < Light::Red, "the best is first: {advised}");
    }
}

/// Trust: practice; a holder that presses more tears a sheet sooner. A gain of less than 2 points of percent, or than the
/// error bar, may be none. The finished sizes fix the blank.
#[test]
fn advice_goes_with_practice_and_beyond_the_error() {
    let pulled = solved(&["friction=0.25"]);
    let (_, findings) = judge(&pulled, None, false, &());
    let at = findings.iter().position(|row| row.key == "tearing").expect("tearing");
    let used = findings[at].value().expect("a share");
    assert_eq!(findings[at].light, Light::Amber);
    let advised = |size, is_more, gain: f64, bar: Option<f64>| {
        let (mut own, mut new) = (findings.clone(), findings.clone());
        new[0].light = if size == "blank radius" { Light::Amber } else { new[0].light };
        let amount = &mut new[at].quantity.as_mut().expect("a number").amount;
        amount.value = used - gain;
        new[at].light = Light::Green;
        own[at].quantity.as_mut().expect("a number").amount.bar = bar;
        advice::advise(&mut own, &[advice::Tried { words: "this".into(), size, is_more, findings: new }]);
        own[at].advice.starts_with("this")
    };
    assert!(advised("holder force", false, 5.0, None) && advised("die radius", true, 5.0, Some(4.0)));
    assert!(!advised("holder force", true, 5.0, None) && !advised("holder gap", false, 5.0, None));
    assert!(!advised("pressure", true, 5.0, None) && !advised("blank radius", false, 5.0, None));
    assert!(!advised("die radius", true, 1.5, None) && !advised("die radius", true, 5.0, Some(6.0)));
    // What tears all the same, or costs another row, is no help.
    let torn = made("hydroform", &[("depth", "25 mm")], &[]).solve(&mut ());
    let (answer, rows) = judge(&torn, None, true, &());
    assert_eq!(answer.failures.first(), Some(&FailureMode::Tears));
    assert!(rows.iter().all(|row| !row.advice.contains("green") && !row.advice.contains("pressure")), "{rows:?}");
    let sized = solved(&["friction=0.25", "finished.height=20 mm"]);
    let [free, fixed] = [&pulled, &sized].map(|solution| row(solution, true, "tearing").advice);
    assert!(free.contains("blank radius") && !fixed.contains("blank radius"), "{free}: {fixed}");
}

/// Trust: sizes by handbook rules make a sound part; a dome and a cone that are pulled with 91 % or more of what they bear are to be looked at. A cupping test goes on until the sheet tears.
#[test]
fn new_cases_are_green_with_their_defaults() {
    for template in TEMPLATES.iter().filter(|template| template.name != "erichsen") {
        let (answer, findings) = judge(solved_once(&made(template.name, &[], &[])), None, false, &());
        let open = assess::judgements(&findings).filter(|row| row.light > Light::Green).map(|row| row.key);
        let expected = match template.name {
            "hemispherical-cup" | "conical-cup" => &["tearing"][..],
            _ => &[],
        };
        assert_eq!(open.collect::<Vec<_>>(), expected, "{}: {}", template.name, answer.sentence);
    }
}

/// Trust: one verdict for all; `cargo bench --bench verdicts` has 200 parts.
#[test]
fn every_verb_judges_random_parts_alike_and_first_advice_keeps_its_word() {
    for seed in 0..4 {
        let part = verdicts::random_part(seed);
        assert_eq!(verdicts::disagreement(&part, seed == 0).0, None, "{seed}");
        let advised = verdicts::advised(&part).map(|one| (one.light, one.first));
        assert!(!matches!(advised, Some((_, Some((_, false))))), "{seed}: {advised:?}");
    }
}
