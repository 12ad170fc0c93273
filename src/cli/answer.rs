//! The screen that answers: the verdict's sentence, what is red and amber with what to change, the key numbers.

use super::say::Shown;
use super::table::{Cell, Tone, table, toned, wrapped};
use stampflow::assess::{Answer, Finding, Kind, Light, by_advice, judgements, sentences, size_doubts};
use stampflow::case::Case;
use stampflow::study::verify::Verification;
use stampflow::units::joined;

/// Of a case: the sentence and doubts of its sizes first, then what it rests on; where it was verified, how sure that is.
pub fn answered(case: &Case, answer: &Answer, findings: &[Finding], verification: Option<&Verification>) -> Shown {
    let numbers = answer.numbers.iter().map(|number| {
        [
            Cell::plain(String::from(number.label)),
            Cell::plain(number.amount.to_string()),
            Cell::plain(number.place.clone()),
        ]
    });
    let mut shown = sentence(&case.name, answer, "");
    for doubt in size_doubts(case) {
        shown = shown + wrapped(&format!("- {}", doubt.to_string()));
    }
    shown = shown + "\n".into() + judged(findings) + table(None, numbers.collect());
    let ended = Some(answer.end.clone()).filter(|end| !end.is_empty());
    let of_bars = verification.map_or_else(Vec::new, Verification::sentences);
    let warnings = ended.into_iter().chain(sentences(findings, Kind::Warning)).chain(of_bars);
    let warnings: Vec<String> = warnings.collect();
    if !warnings.is_empty() {
        shown = shown + "\n".into();
    }
    for warning in warnings {
        shown = shown + wrapped(&format!("- {}", warning.to_string()));
    }
    let grey = judgements(findings).filter(|f| f.light == Light::Grey).map(|f| f.label.into());
    let grey = joined(grey, ", ");
    if grey.is_empty() {
        return shown;
    }
    shown + wrapped(&format!("\nNot judged, for want of what it would be held against: {grey}."))
}

/// `cup: RED – it tears in the wall`: one line where several cases are told, with `more` at its end.
pub fn sentence(case: &str, answer: &Answer, more: &str) -> Shown {
    let light = String::from(answer.light.name()).to_uppercase();
    let line = format!("{case}: {light}: {}. {more}", answer.sentence.to_string());
    toned(&line, &light, Tone::of(answer.light))
}

/// Red rows, then amber ones; what to change stands once under those that it is good for.
fn judged(findings: &[Finding]) -> Shown {
    let mut rows: Vec<[Cell; 3]> = Vec::new();
    for light in [Light::Red, Light::Amber] {
        for alike in by_advice(findings, |is| is == light) {
            rows.extend(alike.iter().map(|finding| row(finding)));
            let advice = &alike[0].advice;
            if !advice.is_empty() {
                rows.push(["", &String::from("→ change"), &advice.to_string()].map(Cell::plain));
            }
            rows.push([""; 3].map(Cell::plain));
        }
    }
    table(None, rows)
}

fn row(finding: &Finding) -> [Cell; 3] {
    // Words are no limit of a number.
    let found = match finding.value() {
        Some(_) => format!("{found}; limit: {limit}", found = finding.found(), limit = finding.limit),
        None => finding.found().clone(),
    };
    [
        Cell { text: String::from(finding.light.name()), tone: Tone::of(finding.light) },
        Cell::plain(String::from(finding.label)),
        Cell::plain(found.to_string()),
    ]
}
