//! The verdict on a run: lights, limits and advice.

use crate::common::cli::{CUP, STAGES, folder, stampflow, text};
use serde_json::Value;
use stampflow::assess::{self, Answer, Finding, Kind, Light, advice, headline};
use stampflow::case::{self, Case};
use stampflow::solver::solution::StageSolution;
use stampflow::solver::solve;
use std::path::Path;

/// The findings on a shipped case with overrides.
fn findings(name: &str, overrides: &[&str]) -> Vec<Finding> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases").join(name);
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    let case = case::load(path, &overrides).expect("valid");
    judged(&case, &solve(&case.stages, &mut ()))
}

/// The verdict's rows, all findings made sure to be whole.
fn judged(case: &Case, passes: &[StageSolution]) -> Vec<Finding> {
    let mut findings = assess::after(case, passes);
    for finding in findings.iter().chain(&assess::before(case)) {
        let said = [&finding.found(), &finding.limit, &finding.source].iter().all(|message| !message.is_empty());
        assert!(said && ![finding.key, finding.label].contains(&""), "{finding:?}");
        let row = finding.kind == Kind::Judgement;
        assert!(!row || (finding.light != Light::Green) != finding.advice.is_empty(), "{finding:?}");
    }
    findings.retain(|finding| finding.kind == Kind::Judgement);
    findings
}

fn light(findings: &[Finding], key: &str) -> Light {
    findings.iter().find(|f| f.key == key).unwrap_or_else(|| panic!("no {key}: {findings:?}")).light
}

fn value(findings: &[Finding], key: &str) -> f64 {
    findings.iter().find(|f| f.key == key).and_then(|f| f.value()).unwrap_or_else(|| panic!("no {key}"))
}

/// Trust: the quickstart draws a whole cup; the source of its friction is not given, and it has nothing to hold the strains,
/// the force, the work and the law's range against, which is said.
#[test]
fn the_quickstart_is_a_good_cup_with_a_guess_and_open_questions() {
    let found = findings("quickstart.toml", &[]);
    assert!(found.iter().all(|f| f.light != Light::Red), "{found:?}");
    let lit = |light| found.iter().filter(|f| f.light == light).map(|f| f.key).collect::<Vec<_>>();
    assert_eq!(lit(Light::Amber), ["friction"]);
    assert_eq!(lit(Light::Grey), ["forming_limit", "press_force", "energy", "hardening_range"]);
    let said = headline(&found);
    assert!(said.to_string().starts_with("1 amber (Friction), 4 not judged (Forming limit, Press force, "), "{said}");
    let told = advice(&found, |light| light == Light::Grey);
    assert!(
        told.iter().any(|(labels, _)| labels.to_string() == "Press force, Energy"),
        "advice is given once: {told:?}"
    );
    // By hand, as in `check`: Siebel's 0.0025 [(β − 1)² + 0.3] R_m with R_m = 520 n^n exp(offset − n), over 10 kN on the flat.
    let strength = 520.0 * 0.22_f64.powf(0.22) * (0.005_f64 - 0.22).exp();
    let advised = 0.0025 * ((55.0_f64 / 30.0 - 1.0).powi(2) + 0.3) * strength;
    let held = std::f64::consts::PI * (55.0_f64.powi(2) - 37.25_f64.powi(2));
    // The strength is the largest of steps of 5e-4 in strain: flat at the maximum, so right to 1e-6.
    assert!((value(&found, "wrinkling") / (advised * held / 10_000.0) - 1.0).abs() < 1e-4);
    let tears = std::f64::consts::PI * 61.0 * strength;
    // The holder's 10 kN are constant.
    let share = (value(&found, "press_force") - 10_000.0) / tears;
    assert!((value(&found, "bottom_tearing") / (100.0 * share) - 1.0).abs() < 1e-4);
}

#[test]
fn force_and_work_are_held_against_the_press() {
    let short = ["tools.punch.travel=3 mm"];
    for (force, energy, lights) in [("1 MN", "1 kJ", Light::Green), ("1 kN", "1 J", Light::Red)] {
        let press = [&format!("press.force={force}") as &str, &format!("press.energy={energy}"), short[0]];
        let found = findings("quickstart.toml", &press);
        assert_eq!([light(&found, "press_force"), light(&found, "energy")], [lights; 2], "{found:?}");
    }
    let wrong = |name: &str, given: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases").join(name);
        case::load(path, &[given.to_owned()]).expect_err(given).to_string()
    };
    assert!(wrong("quickstart.toml", "press.force=80 N/mm").contains("whole ring"));
    assert!(wrong("quickstart.toml", "press.force=0 N").contains("forms nothing"));
    assert!(wrong("strip_draw.toml", "press.energy=2 kJ").contains("length of the part"));
}

/// Trust: by hand. A nose of 6 mm that ends at 27.338 mm in a wall leaning by 20°; a hemisphere has no bottom to tear off.
#[test]
fn a_cone_tears_where_its_nose_ends() {
    let judged = |template: &str| {
        let text =
            stampflow::author::templates::find(template).and_then(|template| template.fill(&[])).expect("a case");
        let case = case::parse(&text, "made.toml", &["tools.punch.travel=5 mm".to_owned()]).expect("valid");
        let stages = solve(&case.stages, &mut ());
        let peak = stages[0].steps.iter().map(|step| step.punch_force).fold(0.0, f64::max);
        (judged(&case, &stages), peak)
    };
    let (cone, peak) = judged("conical-cup");
    let strength = 520.0 * 0.22_f64.powf(0.22) * (0.005_f64 - 0.22).exp();
    let tears = std::f64::consts::PI * (2.0 * 27.338 + 1.0) * strength * 20_f64.to_radians().cos();
    // The sizes are written to 1e-3 mm.
    let share = peak / tears;
    assert!((value(&cone, "bottom_tearing") / (100.0 * share) - 1.0).abs() < 1e-4, "{cone:?}");
    assert!(judged("hemispherical-cup").0.iter().all(|f| f.key != "bottom_tearing"));
}

/// Trust: by hand, 1.5 of the second punch is beyond 1.3; its wall carries π·61·1·301 N and tears in the second stage.
#[test]
fn later_draws_are_judged_too() {
    let text = stampflow::author::templates::find("redraw")
        .and_then(|t| t.fill(&[("first-radius", "45 mm")]))
        .expect("a case");
    let case = case::parse(&text, "made.toml", &[]).expect("valid");
    let passes = solve(&case.stages, &mut ());
    let found = judged(&case, &passes);
    assert_eq!(light(&found, "redraw_ratio"), Light::Amber, "{found:?}");
    assert!((value(&found, "redraw_ratio") - 1.5).abs() < 1e-9);
    let of = |key: &str| found.iter().find(|f| f.key == key).expect(key);
    assert!(of("bottom_tearing").found().ends_with("stage 2"), "{:?}", of("bottom_tearing"));
    let strength = 520.0 * 0.22_f64.powf(0.22) * (0.005_f64 - 0.22).exp();
    let peak = passes[1].steps.iter().map(|step| step.punch_force).fold(0.0, f64::max);
    // The strength is right to 1e-6, the radius exact.
    assert!((value(&found, "bottom_tearing") - 100.0 * peak / (std::f64::consts::PI * 61.0 * strength)).abs() < 1e-2);
    // One stroke's energy, not the sum of both.
    let works = passes.iter().map(|pass| 1e-3 * pass.steps.last().expect("steps").work.external);
    assert!((value(&found, "energy") - works.fold(0.0, f64::max)).abs() < 1e-9);
}

#[test]
fn what_a_run_cannot_say_is_grey_and_what_is_implausible_amber() {
    let grey = |name: &str, key: &str| assert_eq!(light(&findings(name, &[]), key), Light::Grey, "{name} {key}");
    grey("strip_draw.toml", "springback");
    grey("woo_hemispherical.toml", "wall_wrinkles");
    let short = "tools.punch.travel=3 mm";
    let of = |given: &[&str], key: &str| {
        let found = findings("quickstart.toml", &[&[short], given].concat());
        let it = found.iter().find(|f| f.key == key).unwrap_or_else(|| panic!("no {key}"));
        (it.light, it.found())
    };
    // No holder is no better than a weak one: 50 mm of blank beyond the punch.
    assert_eq!(of(&["tools.holder.force=0 N"], "wrinkling").0, Light::Red);
    // Only the key for it says where a number comes from; prose may say anything, and another number is not the source's.
    for note in ["friction was not measured", "friction for a plate 2000 mm wide", "friction measured on a strip"] {
        assert_eq!(of(&[&format!("notes=[\"{note}\"]")], "friction").0, Light::Amber, "{note}");
    }
    let source = "friction.source=Woo (1968)";
    let (light, found) = of(&[source], "friction");
    assert!(light == Light::Green && found.to_string().contains("Woo (1968)"), "{found}");
    assert_eq!(of(&[source, "tools.die.friction=0.5"], "friction").0, Light::Amber);
    let quickstart = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/quickstart.toml");
    let empty = case::load(quickstart, &["friction.source=\" \"".to_owned()]).expect_err("a source that is none");
    assert!(empty.to_string().contains("says nothing"), "{empty}");
    let wide = ["tools.die.throat=40 mm", "tools.holder.inner_radius=46 mm"];
    assert_eq!(of(&wide, "clearance").0, Light::Amber);
}

#[test]
fn a_holder_that_squeezes_is_said() {
    let squeezed = ["tools.holder.force=600 kN", "tools.punch.travel=1 mm"];
    let found = findings("quickstart.toml", &squeezed);
    let holder = found.iter().find(|f| f.key == "holder").unwrap();
    assert!(holder.light == Light::Amber && holder.advice.to_string().contains("squeezed"), "{holder:?}");
}

#[test]
fn too_much_friction_and_holder_force_tear_the_cup() {
    let torn =
        ["tools.holder.force=150 kN", "tools.die.friction=0.2", "tools.holder.friction=0.2", "forming_limit.hill=true"];
    let found = findings("quickstart.toml", &torn);
    assert_eq!(light(&found, "forming_limit"), Light::Red, "{found:?}");
    assert_eq!(light(&found, "stop"), Light::Red, "{found:?}");
    let stop = found.iter().find(|f| f.key == "stop").unwrap();
    assert!(stop.advice.to_string().contains("less holder force"), "{stop:?}");
    assert_eq!(light(&found, "wrinkling"), Light::Green);
}

#[test]
fn a_weak_holder_lets_the_flange_wrinkle() {
    let found = findings("quickstart.toml", &["tools.holder.force=3 kN", "tools.punch.travel=3 mm"]);
    assert_eq!(light(&found, "wrinkling"), Light::Amber, "{found:?}");
    let found = findings("quickstart.toml", &["tools.holder.force=1 kN", "tools.punch.travel=3 mm"]);
    assert_eq!(light(&found, "wrinkling"), Light::Red, "{found:?}");
}

/// Tables, isotherms, gas, plane strain, stages: whatever a case has, its findings are whole sentences.
#[test]
fn other_kinds_of_cases_are_judged_too() {
    for (name, overrides) in
        [("bulge.toml", &[][..]), ("hat_springback.toml", &["blank.elements=60"][..]), ("strip_draw.toml", &[][..])]
    {
        assert!(findings(name, overrides).len() > 5, "{name}");
    }
}

#[test]
fn check_run_prints_its_table_and_its_json_and_writes_nothing() {
    let dir = folder(CUP);
    let printed = stampflow(dir.path(), &["check", "cases/cup.toml", "--run", "--quiet"]);
    assert_eq!(printed.status.code(), Some(0), "{}", text(&printed.stderr));
    let out = text(&printed.stdout);
    for word in ["→ change", "green", "amber", "Thinning", "no forming limit given"] {
        assert!(out.contains(word), "no {word}: {out}");
    }
    assert!(!out.contains('\u{1b}'), "no terminal, no colours");
    let json = stampflow(dir.path(), &["check", "cases/cup.toml", "--run", "--json"]);
    let value: Value = serde_json::from_slice(&json.stdout).expect("JSON");
    assert_eq!(value["complete"], true);
    let found = value["verdict"]["findings"].as_array().expect("an array");
    assert!(found.len() > 10 && found.iter().all(|f| f["light"].is_string() && f["unit"].is_string()));
    assert!(value["lines"].is_array(), "the check is there too");
    let left: Vec<_> = std::fs::read_dir(dir.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["cases"]);
}

#[test]
fn a_run_that_stops_early_and_bad_input_have_their_exit_codes() {
    let dir = folder(CUP);
    let torn =
        ["--set", "tools.holder.force=400 kN", "--set", "tools.die.friction=0.3", "--set", "tools.punch.travel=25 mm"];
    let run = |more: &[&str]| stampflow(dir.path(), &[&["check", "cases/cup.toml", "--run", "--quiet"], more].concat());
    let stopped = run(&torn);
    assert_eq!(stopped.status.code(), Some(3), "{}", text(&stopped.stdout));
    assert!(text(&stopped.stdout).contains("red"));
    assert_eq!(run(&["--set", "blank.thickness=-1 mm"]).status.code(), Some(2));
}

#[test]
fn stages_are_judged_together() {
    let dir = folder(&(CUP.to_owned() + STAGES));
    let json = stampflow(dir.path(), &["check", "cases/cup.toml", "--run", "--json"]);
    assert_eq!(json.status.code(), Some(0), "{}", text(&json.stderr));
    let value: Value = serde_json::from_slice(&json.stdout).expect("JSON");
    let found = value["verdict"]["findings"].as_array().expect("an array");
    let of = |key: &str| found.iter().find(|f| f["key"] == key).and_then(|f| f["found"].as_str()).expect("a finding");
    assert!(of("stop").starts_with("stage 2 of 2: "), "{}", of("stop"));
    assert!(of("press_force").ends_with("stage 1"), "{}", of("press_force"));
}

/// Trust: by hand, ρ ln(1 + 1/ρ) of 1.5, 3 and 6 mm on a sheet of 1 mm. Membranes, which do not bend, are judged too.
#[test]
fn noses_and_shoulders_below_five_thicknesses_are_not_green() {
    let short = ["tools.punch.travel=3 mm"];
    let judged = |sets: &[&str]| findings("quickstart.toml", &[&short, sets].concat());
    let nose = |mm: f64| format!("tools.punch.flat.nose={mm} mm");
    for (ratio, expected, color) in
        [(1.5, 76.624, Light::Red), (3.0, 86.305, Light::Amber), (6.0, 92.490, Light::Green)]
    {
        for theory in ["blank.theory=bending", "blank.theory=membrane"] {
            let found = judged(&[&nose(ratio), theory]);
            assert!((value(&found, "bent_strength") - expected).abs() < 1e-3, "{found:?}");
            assert_eq!(light(&found, "bent_strength"), color, "{found:?}");
        }
    }
    let found = judged(&[&nose(6.0), "tools.die.shoulder=1.9 mm"]);
    let row = found.iter().find(|f| f.key == "bent_strength").expect("a row");
    assert_eq!(row.light, Light::Red);
    assert!(row.found().contains("die's shoulder of 1.9 mm") && row.advice.to_string().contains("t²/8R"), "{row:?}");
    // A coarse mesh does not follow the nose, and its bends alone would be none to speak of.
    let found = judged(&[&nose(1.9), "blank.elements=12", "blank.grading=uniform"]);
    assert_eq!(light(&found, "bent_strength"), Light::Red, "{found:?}");
}

/// Trust: a bend just under five thicknesses in a cup that uses a fraction of its limit: each row says its own, and the sentence
/// what is asked first.
#[test]
fn a_sharp_bend_is_not_near_to_tearing() {
    let (answer, found) = answered("quickstart.toml", &["forming_limit.hill=true", "tools.die.shoulder=4.5 mm"]);
    assert_eq!(
        [light(&found, "forming_limit"), light(&found, "bend_radius")],
        [Light::Green, Light::Amber],
        "{found:?}"
    );
    let said = answer.sentence.to_string();
    assert!(said.starts_with("it does not tear; look at Bending radius"), "{said}");
    let bend = found.iter().find(|finding| finding.key == "bend_radius").expect("a row");
    assert!(bend.limit.to_string().replace('\u{a0}', " ").contains("red below 2 t"), "{bend:?}");
    assert!(found.iter().all(|finding| !finding.limit.to_string().contains("refused")), "{found:?}");
}

/// Trust: the summary's own number, in millimetres of a sheet of 1 mm; a weak holder is lifted by the thickening flange, and
/// by more still when nothing but the tilting rim is left under it.
#[test]
fn the_lift_of_the_holder_is_one_number_wherever_it_stands() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/quickstart.toml");
    let weak = ["tools.holder.force=500 N", "tools.punch.travel=36 mm"].map(str::to_owned);
    let case = case::load(path, &weak).expect("valid");
    let solution = case.solve(&mut ());
    let all = assess::after(&solution.case, &solution.stages);
    let row = all.iter().find(|f| f.key == "holder").expect("the holder is judged");
    let warning = all.iter().find(|f| f.key == "holder_lift").expect("the holder is lifted");
    let printed = serde_json::to_value(solution.summary()).unwrap()["holder_lift_mm"].as_f64();
    assert_eq!(row.value(), warning.value());
    // Files have nine digits.
    assert!((row.value().unwrap() - printed.expect("printed")).abs() < 1e-8);
    let most = solution.stages[0].steps.iter().map(|step| -step.holder_move).fold(0.0, f64::max);
    assert!(most > row.value().unwrap() + 0.05, "{most} {row:?}");
    for finding in [row, warning] {
        assert!(finding.found().contains("lifted by 0."), "{finding:?}");
    }
    assert!(row.found().contains("MPa at first"), "{row:?}");
}

/// The verdict on a shipped case with overrides.
fn answered(name: &str, overrides: &[&str]) -> (Answer, Vec<Finding>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases").join(name);
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    let case = case::load(path, &overrides).expect("valid");
    let stages = solve(&case.stages, &mut ());
    let findings = judged(&case, &stages);
    (Answer::of(&case, &stages, &findings), findings)
}

/// Trust: by hand, the run's own largest 45.3 kN of the punch and 10 kN of a holder whose force is constant; 20 % more of it
/// are 66.4 kN.
#[test]
fn a_press_bears_the_punch_and_its_cushion() {
    let told = |overrides: &[&str]| {
        let (answer, findings) = answered("quickstart.toml", overrides);
        let number = answer.numbers.iter().find(|number| number.key == "punch_force").expect("a force").place.clone();
        (number.replace('\u{a0}', " "), light(&findings, "press_force"))
    };
    let (number, unrated) = told(&[]);
    assert!(
        number.ends_with("a press of at least 67 kN with the holder (1.2 times the load)") && unrated == Light::Grey,
        "{number}"
    );
    for (force, share, light) in [
        ("press.force=50 kN", "111 %", Light::Red),
        ("press.force=60 kN", "92 %", Light::Amber),
        ("press.force=80 kN", "69 %", Light::Green),
    ] {
        let (number, rated) = told(&[force]);
        assert!(number.contains(share) && number.ends_with("with the holder") && rated == light, "{number}");
    }
}

/// Trust: the finding's own share; a long draw of this sheet pulls harder than what any wall carries, less than some do.
#[test]
fn a_force_beyond_what_the_wall_surely_carries_may_tear_the_bottom() {
    let strong = ["blank.radius=64 mm", "tools.holder.force=14 kN", "tools.punch.travel=26 mm"];
    let (answer, findings) = answered("quickstart.toml", &strong);
    assert!(value(&findings, "bottom_tearing") > 100.0 && light(&findings, "bottom_tearing") == Light::Amber);
    assert!(answer.sentence.to_string().starts_with("it may tear at the bottom"), "{}", answer.sentence);
}

/// Trust: the findings' own numbers.
#[test]
fn a_kept_forming_limit_is_not_called_near_to_tearing() {
    let template = stampflow::author::templates::find("hemispherical-cup").expect("a template");
    let text = template.fill(&[("height", "38 mm")]).expect("a case");
    let case = case::parse(&text, "made.toml", &[]).expect("valid");
    let stages = solve(&case.stages, &mut ());
    let findings = judged(&case, &stages);
    assert_eq!([light(&findings, "thinning"), light(&findings, "forming_limit")], [Light::Amber, Light::Green]);
    let sentence = Answer::of(&case, &stages, &findings).sentence.to_string().replace('\u{a0}', " ");
    let share = |key: &str| format!("{:.0} %", value(&findings, key));
    assert!(sentence.starts_with(&format!("it thins by {} on the dome", share("thinning"))), "{sentence}");
    assert!(sentence.ends_with(&format!("the forming limit is used to {}", share("forming_limit"))), "{sentence}");
}

/// Trust: friction holds a dome's pole on its punch; what a flat punch's nose tears is not helped by it.
#[test]
fn what_to_change_goes_by_the_place() {
    let advice = |template: &str, given: &[(&str, &str)]| {
        let template = stampflow::author::templates::find(template).expect("a template");
        let case = case::parse(&template.fill(given).expect("a case"), "made.toml", &[]).expect("valid");
        let findings = judged(&case, &solve(&case.stages, &mut ()));
        findings.iter().find(|f| f.key == "forming_limit").map(|f| f.advice.to_string()).expect("a finding")
    };
    let dome = advice("hemispherical-cup", &[("material", "ap04xr"), ("height", "45 mm")]);
    assert!(dome.contains("more at the punch") && !dome.contains("nose") && !dome.contains("less holder"), "{dome}");
}

/// Trust: the user's own doing is no fault of the part.
#[test]
fn an_interrupted_run_is_not_red() {
    struct Early(usize);
    impl stampflow::solver::Observer for Early {
        fn step(&mut self, _: &stampflow::solver::solution::StepRecord) {
            self.0 -= 1;
        }
        fn wants_to_stop(&mut self) -> bool {
            self.0 == 0
        }
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/quickstart.toml");
    let case = case::load(path, &[]).expect("valid");
    let stages = solve(&case.stages, &mut Early(5));
    let findings = judged(&case, &stages);
    let answer = Answer::of(&case, &stages, &findings);
    assert_eq!((answer.light, answer.sentence.to_string().as_str()), (Light::Amber, "interrupted by the user"));
}
