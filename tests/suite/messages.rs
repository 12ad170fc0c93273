//! What users are told, in German and in US units: nothing stays in English or in mm.

use crate::common::few::Few;
use crate::common::shipped::shipped_case;
use stampflow::assess::{self, Answer, Finding, Kind};
use stampflow::author::templates::TEMPLATES;
use stampflow::case::{self, Case, Solution};
use stampflow::message::{Form, Language, Message, System, names};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn german() -> Language {
    Language::of("de").expect("German")
}

/// Everything that is told of a case: its check, its verdict, its summary.
fn told(solution: &Solution) -> Vec<Message> {
    let check = assess::check::report(&solution.case);
    let lines = check
        .lines
        .iter()
        .chain(&check.details)
        .flat_map(|line| [line.label.clone(), line.value.clone(), line.meaning.clone()]);
    let findings = assess::after(&solution.case, &solution.stages);
    let answer = Answer::of(&solution.case, &solution.stages, &findings);
    let numbers = answer.numbers.iter().flat_map(|number| [number.label.into(), number.about.clone()]);
    let summary = solution.summary();
    let stages = summary.stages.iter().flat_map(|stage| stage.messages());
    lines
        .chain(check.warnings.clone())
        .chain(check.notes.clone())
        .chain(numbers)
        .chain([answer.sentence.clone(), assess::headline(&findings), summary.lines.clone()])
        .chain(findings.iter().flat_map(sentences))
        .chain(stages)
        .collect()
}

fn sentences(finding: &Finding) -> [Message; 6] {
    let Finding { label, light, found, limit, source, advice, .. } = finding;
    [(*label).into(), light.name().into(), found.clone(), limit.clone(), source.clone(), advice.clone()]
}

/// Fails where German lacks a text.
fn all_german(what: &str, solution: &Solution) {
    let missing: BTreeSet<&str> = told(solution).iter().flat_map(|message| message.untranslated(german())).collect();
    assert!(missing.is_empty(), "{what}: no German for {missing:#?}");
}

fn of_template(name: &str, overrides: &[&str]) -> Case {
    let template = TEMPLATES.iter().find(|template| template.name == name).expect("a template");
    let text = template.fill(&[]).expect("a case");
    let overrides: Vec<String> = overrides.iter().map(|o| (*o).to_owned()).collect();
    case::parse(&text, "made.toml", &overrides).expect("valid")
}

/// Trust: a dozen steps of each are enough to have every row of the verdict that the kind of case has.
#[test]
fn every_shipped_case_and_every_template_is_told_in_german() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    for entry in fs::read_dir(folder).expect("the shipped cases") {
        let path = entry.expect("readable").path();
        let Some(name) = path.file_name().and_then(|name| name.to_str()?.strip_suffix(".toml")) else { continue };
        all_german(name, &shipped_case(name, &[]).solve(&mut Few(12)));
    }
    for template in TEMPLATES {
        all_german(template.name, &of_template(template.name, &[]).solve(&mut Few(12)));
    }
}

/// A cup that tears, one that is drawn through, one that finds no equilibrium, a bend that springs back against its
/// tolerance, a second draw, a warm sheet, gas, and the doubts before a run.
#[test]
fn whatever_becomes_of_a_run_is_told_in_german() {
    let torn = ["tools.holder.force=150 kN", "tools.die.friction=0.2", "forming_limit.hill=true"];
    let through = ["tools.punch.travel=40 mm", "blank.radius=45 mm", "blank.elements=40"];
    let stuck = ["solver.max_iterations=3", "solver.min_step=0.002"];
    let doubts = [
        "tools.holder.force=10 MN",
        "tools.die.shoulder=1.9 mm",
        "tools.die.friction=0.4",
        "blank.elements=20",
        "blank.radius=70 mm",
        "tools.punch.travel=1 mm",
    ];
    for overrides in [&torn[..], &through, &stuck, &doubts] {
        all_german(&overrides.join(" "), &shipped_case("quickstart", overrides).solve(&mut ()));
    }
    all_german("bulge", &shipped_case("bulge", &["blank.elements=20"]).solve(&mut ()));
    all_german("v-bend", &of_template("v-bend", &["springback.tolerance=1 deg"]).solve(&mut ()));
}

/// Trust: these words stand in nearly every English sentence and in no German one.
#[test]
fn a_verdict_in_german_has_no_english_words_and_one_in_us_units_no_millimetres() {
    let solution = shipped_case("quickstart", &["forming_limit.hill=true", "press.force=1 MN"]).solve(&mut ());
    let findings = assess::after(&solution.case, &solution.stages);
    let tell = |form: Form| {
        let sentences = findings.iter().flat_map(sentences).map(|message| message.told(form));
        sentences.collect::<Vec<_>>().join("\n")
    };
    let german = tell(Form { language: german(), ..Form::default() });
    let words = german.split(|c: char| !c.is_alphabetic());
    let english: Vec<&str> = words
        .filter(|word| ["the", "of", "and", "is", "are", "with", "from", "than", "which"].contains(word))
        .collect();
    assert!(english.is_empty(), "{english:?} in\n{german}");
    assert!(german.contains("Ausdünnung") && german.contains("\u{a0}%") && german.contains(','), "{german}");

    let us = tell(Form { system: System::Us, ..Form::default() });
    assert!([" in", " US tonf", " psi"].iter().all(|unit| us.contains(&unit.replace(' ', "\u{a0}"))), "{us}");
    assert!(![" mm", " kN", " MPa"].iter().any(|unit| us.contains(&unit.replace(' ', "\u{a0}"))), "{us}");
    let check = assess::check::report(&solution.case).told(Form { system: System::Us, ..Form::default() });
    assert!(check.contains("\u{a0}in") && check.contains("\u{a0}psi"), "{check}");
    let summary = solution.summary().told(Form { language: self::german(), ..Form::default() });
    assert!(summary.contains("Größte Stempelkraft") && summary.contains("45,3\u{a0}kN"), "{summary}");
}

/// The verdict and the summary tell one number in one form.
#[test]
fn a_number_is_told_alike_wherever_it_stands() {
    let solution = shipped_case("quickstart", &["tools.punch.travel=10 mm"]).solve(&mut ());
    let findings = assess::after(&solution.case, &solution.stages);
    let found = |key: &str| findings.iter().find(|finding| finding.key == key).expect(key).found.to_string();
    let summary = solution.summary().to_string();
    let line = |label: &str| summary.lines().find_map(|line| line.trim().strip_prefix(label)).expect(label).trim();
    let punch = line("Peak punch force").split(" at ").next().expect("a force");
    assert!(found("press_force").contains(&format!("punch {punch}")), "{} {summary}", found("press_force"));
    let height = line("at s0, initially from the axis");
    assert!(found("thinning").ends_with(&format!("s0 = {height}")), "{} {summary}", found("thinning"));
    assert!(found("bend_radius").starts_with(line("Smallest bending radius")), "{} {summary}", found("bend_radius"));
}

#[test]
fn limits_are_numbers_on_the_side_of_their_lights() {
    let solution = shipped_case("quickstart", &["forming_limit.hill=true"]).solve(&mut ());
    let findings = assess::after(&solution.case, &solution.stages);
    let rows = || findings.iter().filter(|finding| finding.kind == Kind::Judgement);
    let with_limits = rows().filter(|finding| finding.limits.is_some()).count();
    assert!(with_limits > 10, "{with_limits}");
    for (finding, limits) in rows().filter_map(|finding| Some((finding, finding.limits?))) {
        let value = finding.value.expect("a number beside its limits");
        let beyond = |limit: Option<f64>| {
            limit.is_some_and(|limit| match limits.sense {
                assess::Sense::AtMost => value > limit,
                assess::Sense::AtLeast => value < limit,
            })
        };
        if finding.light == assess::Light::Green {
            assert!(!beyond(limits.amber) && !beyond(limits.red), "{finding:?}");
        }
        assert_eq!(finding.light == assess::Light::Red, beyond(limits.red), "{finding:?}");
    }
}

/// The files of `src/` but the messages' own, without their tests.
fn sources() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut folders, mut files): (Vec<PathBuf>, Vec<(String, String)>) = (vec![root.clone()], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("readable") {
            let path = entry.expect("readable").path();
            let inside = path.strip_prefix(&root).expect("below src").to_string_lossy().into_owned();
            if path.is_dir() && inside != "message" {
                folders.push(path);
            } else if inside.ends_with(".rs") && !inside.ends_with("tests.rs") {
                let text = fs::read_to_string(&path).expect("readable");
                files.push((inside, text.split("#[cfg(test)]").next().expect("a first part").to_owned()));
            }
        }
    }
    files
}

/// The string literals of a source, each with the code before it on its line and the one above.
fn literals(source: &str) -> Vec<(&str, String)> {
    let (mut found, mut at) = (Vec::new(), 0);
    while let Some(c) = source[at..].chars().next() {
        let rest = &source[at..];
        if rest.starts_with("//") {
            at += rest.find('\n').unwrap_or(rest.len());
        } else if rest.starts_with("'\"'") || rest.starts_with("'\\") {
            at += 2 + rest[2..].find('\'').expect("a character's end") + 1;
        } else if let Some(raw) = rest.strip_prefix("r#\"") {
            at += 3 + raw.find("\"#").expect("a raw string's end") + 2;
        } else if c == '"' {
            let (text, length) = unescaped(&rest[1..]);
            found.push((source[..at].trim_end(), text));
            at += 1 + length + 1;
        } else {
            at += c.len_utf8();
        }
    }
    found
}

/// A literal's text up to its closing quote, and its length in the source.
fn unescaped(source: &str) -> (String, usize) {
    let (mut text, mut chars) = (String::new(), source.char_indices().peekable());
    while let Some((i, c)) = chars.next() {
        match c {
            '"' => return (text, i),
            '\\' => match chars.next().expect("an escape").1 {
                'n' => text.push('\n'),
                't' => text.push('\t'),
                // A long literal goes on at the next word.
                '\n' => while chars.next_if(|(_, c)| c.is_whitespace()).is_some() {},
                other => text.push(other),
            },
            c => text.push(c),
        }
    }
    panic!("a literal without an end")
}

/// Whether there are words in it beside its names.
fn has_words(text: &str) -> bool {
    names(text)
        .fold(text.to_owned(), |text, name| text.replace(&format!("{{{name}}}"), ""))
        .contains(char::is_alphabetic)
}

/// Trust: every `message!` of the program, and of the rooms that only speak to users every literal with a space in it.
#[test]
fn every_sentence_of_the_program_has_its_german() {
    const SPOKEN: [&str; 4] = ["assess/", "solution/stop.rs", "output/summary/", "measure/events.rs"];
    let known: BTreeSet<&str> = german().texts().map(|(text, _)| text).collect();
    let mut missing = BTreeSet::new();
    for (path, source) in sources() {
        let spoken = SPOKEN.iter().any(|room| path.starts_with(room));
        for (before, text) in literals(&source) {
            let is_sentence = before.ends_with("message!(");
            let is_spoken = spoken && text.trim().contains(' ') && !before.ends_with("format!(");
            // Labels of the summary begin with spaces where they belong to the line above.
            let wanted = if is_sentence { text.as_str() } else { text.trim() };
            if (is_sentence || is_spoken) && has_words(wanted) && !known.contains(wanted) {
                missing.insert(format!("{path}: {wanted}"));
            }
        }
    }
    assert!(missing.is_empty(), "no German for {missing:#?}");
}

#[test]
fn every_german_text_is_one_of_the_programs() {
    let said: String = sources().iter().flat_map(|(_, source)| literals(source)).map(|(_, text)| text + "\n").collect();
    let glossary = include_str!("../../src/message/glossary.toml");
    let dead: Vec<&str> = german()
        .texts()
        .map(|(text, _)| text)
        .filter(|text| !said.contains(text) && !glossary.contains(text))
        .collect();
    assert!(dead.is_empty(), "nothing says {dead:#?}");
}
