//! The verdict in words.

use crate::json::{Value, table};
use stampflow::assess::{Answer, Finding, Kind, judgements, sentences};
use stampflow::message::Form;

/// The sentence with its light, the numbers of the part, every row of the verdict, warnings.
pub fn json(answer: &Answer, findings: &[Finding], before: &[Finding], form: Form) -> Value {
    let numbers = answer.numbers.iter().map(|number| {
        table! {
            "key": number.key,
            "value": number.amount.value,
            "label": form.tell(number.label),
            "told": number.amount.told(form),
            "about": number.about.told(form),
        }
    });
    let rows = judgements(findings).map(|finding| {
        table! {
            "key": finding.key,
            "label": form.tell(finding.label),
            "light": finding.light.name(),
            "value": finding.value,
            "found": finding.found.told(form),
            "limit": finding.limit.told(form),
            "source": finding.source.told(form),
            "advice": finding.advice.told(form),
        }
    });
    let told = |kind| {
        let all = sentences(before, kind).into_iter().chain(sentences(findings, kind));
        Value::list(all.map(|sentence| sentence.told(form)))
    };
    table! {
        "light": answer.light.name(),
        "lightTold": form.tell(answer.light.name()),
        "sentence": answer.sentence.told(form),
        "end": answer.end.told(form),
        "numbers": Value::list(numbers),
        "rows": Value::list(rows),
        "warnings": told(Kind::Warning),
        "notes": told(Kind::Assumption),
    }
}
