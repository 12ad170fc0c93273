//! Answers and comparisons for programs that read them instead of what is printed.

use serde_json::{Map, Value, json};
use stampflow::assess::{Answer, Finding, judgements};
use stampflow::compare::Comparison;
use stampflow::units::rounded;

/// A comparison with all its numbers; what was not reached is null.
pub fn comparison(case: &str, comparison: &Comparison) -> Value {
    let table = comparison.table();
    let numbers = table.columns.iter().map(|column| {
        let values = column.values.iter().map(|value| json!(rounded(*value))).collect();
        (column.header(), Value::Array(values))
    });
    json!({
        "case": case,
        "quantity": comparison.spec.against.name(),
        "reference": comparison.spec.reference,
        "source": comparison.source,
        "worst": comparison.worst(),
        "accepted": comparison.accepted(),
        "verdict": comparison.outcome(),
        "failure": comparison.is_failure(),
        "reason": comparison.spec.reason,
        "values": numbers.collect::<Map<_, _>>(),
    })
}

/// The verdict: its light and sentence, the key numbers, and every row with its number, unit and limits.
pub fn answer(answer: &Answer, findings: &[Finding]) -> serde_json::Result<Value> {
    let mut value = serde_json::to_value(answer)?;
    value["findings"] = judgements(findings).map(serde_json::to_value).collect::<Result<_, _>>()?;
    Ok(value)
}
