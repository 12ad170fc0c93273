//! A comparison for programs that read it instead of the printed table.

use serde_json::{Map, Value, json};
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
