//! The verdict in words.

use serde_json::{Value, json};
use stampflow::assess::{Answer, Finding, Kind, judgements, sentences};
use stampflow::message::Form;

/// The sentence with its light, the numbers of the part, every row of the verdict, warnings.
pub fn json(answer: &Answer, findings: &[Finding], before: &[Finding], form: Form) -> Value {
    let numbers = answer.numbers.iter().map(|number| {
        json!({
            "key": number.key,
            "value": number.amount.value,
            "label": form.tell(number.label),
            "told": number.amount.told(form),
            "about": number.about.told(form),
        })
    });
    let rows = judgements(findings).map(|finding| {
        json!({
            "key": finding.key,
            "label": form.tell(finding.label),
            "light": finding.light.name(),
            "value": finding.value,
            "found": finding.found.told(form),
            "limit": finding.limit.told(form),
            "source": finding.source.told(form),
            "advice": finding.advice.told(form),
        })
    });
    let told = |kind| -> Vec<String> {
        let all = sentences(before, kind).into_iter().chain(sentences(findings, kind));
        all.map(|sentence| sentence.told(form)).collect()
    };
    json!({
        "light": answer.light.name(),
        "lightTold": form.tell(answer.light.name()),
        "sentence": answer.sentence.told(form),
        "end": answer.end.told(form),
        "numbers": numbers.collect::<Vec<_>>(),
        "rows": rows.collect::<Vec<_>>(),
        "warnings": told(Kind::Warning),
        "notes": told(Kind::Assumption),
    })
}
