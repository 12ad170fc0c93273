//! The screen that answers: the verdict's sentence, what is red and amber with what to change, the key numbers.

use super::say::Shown;
use super::table::{Cell, Tone, table, toned, wrapped};
use stampflow::assess::{Answer, Finding, Kind, Light, by_advice, judgements, sentences, size_doubts};
use stampflow::case::Case;
use stampflow::message::{Form, Message, message};
use stampflow::study::verify::Verification;

/// Of a case: the sentence and doubts of its sizes first, then what it rests on; where it was verified, how sure that is.
pub fn answered(
    case: &Case,
    answer: &Answer,
    findings: &[Finding],
    verification: Option<&Verification>,
    form: Form,
) -> Shown {
    let numbers = answer.numbers.iter().map(|number| {
        [
            Cell::plain(form.tell(number.label)),
            Cell::plain(number.amount.told(form)),
            Cell::plain(number.about.told(form)),
        ]
    });
    let mut shown = sentence(&case.name, answer, "", form);
    for doubt in size_doubts(case) {
        shown = shown + wrapped(&format!("- {}", doubt.told(form)));
    }
    shown = shown + "\n".into() + judged(findings, form) + table(None, numbers.collect());
    let ended = Some(answer.end.clone()).filter(|end| !end.is_empty());
    let of_bars = verification.map_or_else(Vec::new, Verification::sentences);
    let warnings = ended.into_iter().chain(sentences(findings, Kind::Warning)).chain(of_bars);
    let warnings: Vec<Message> = warnings.collect();
    if !warnings.is_empty() {
        shown = shown + "\n".into();
    }
    for warning in warnings {
        shown = shown + wrapped(&format!("- {}", warning.told(form)));
    }
    let grey = judgements(findings).filter(|f| f.light == Light::Grey).map(|f| f.label.into());
    let grey = Message::joined(grey, ", ");
    if grey.is_empty() {
        return shown;
    }
    shown
        + wrapped(
            &message!("\nNot judged, for want of what it would be held against: {labels}.", labels = grey).told(form),
        )
}

/// `cup: RED – it tears in the wall`: one line where several cases are told, with `more` at its end.
pub fn sentence(case: &str, answer: &Answer, more: &str, form: Form) -> Shown {
    let light = form.tell(answer.light.name()).to_uppercase();
    let line = format!("{case}: {light}: {}. {more}", answer.sentence.told(form));
    toned(&line, &light, Tone::of(answer.light))
}

/// Red rows, then amber ones; what to change stands once under those that it is good for.
fn judged(findings: &[Finding], form: Form) -> Shown {
    let mut rows: Vec<[Cell; 3]> = Vec::new();
    for light in [Light::Red, Light::Amber] {
        for alike in by_advice(findings, |is| is == light) {
            rows.extend(alike.iter().map(|finding| row(finding, form)));
            let advice = &alike[0].advice;
            if !advice.is_empty() {
                rows.push(["", &form.tell("→ change"), &advice.told(form)].map(Cell::plain));
            }
            rows.push([""; 3].map(Cell::plain));
        }
    }
    table(None, rows)
}

fn row(finding: &Finding, form: Form) -> [Cell; 3] {
    // Words are no limit of a number.
    let found = match finding.value {
        Some(_) => message!("{found}; limit: {limit}", found = finding.found.clone(), limit = finding.limit.clone()),
        None => finding.found.clone(),
    };
    [
        Cell { text: form.tell(finding.light.name()), tone: Tone::of(finding.light) },
        Cell::plain(form.tell(finding.label)),
        Cell::plain(found.told(form)),
    ]
}
