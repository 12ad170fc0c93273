//! Comparisons and error bars for programs that read them instead of what is printed.

use serde_json::{Map, Value, json};
use stampflow::results::comparison::Comparison;
use stampflow::study::verify::{Bar, Verification};
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
        "quantity": comparison.spec.against.quantity().name(),
        "reference": comparison.spec.reference,
        "source": comparison.source(),
        "worst": comparison.worst(),
        "accepted": comparison.accepted(),
        "verdict": comparison.outcome(),
        "failure": comparison.is_failure(),
        "reason": comparison.spec.reason,
        "values": numbers.collect::<Map<_, _>>(),
    })
}

/// Every number with its error bar and what that is made of, what is told beside, and every run.
pub fn verification(verification: &Verification) -> Value {
    let runs = verification.outcomes.iter().map(|run| {
        json!({
            "direction": run.direction.map(|direction| direction.key()),
            "times": run.times,
            "stages": run.end.stages,
            "end": run.end.kind,
            "complete": run.end.complete,
        })
    });
    json!({
        "numbers": verification.bars.iter().map(bar).collect::<Vec<_>>(),
        "told": verification.told.iter().map(ToString::to_string).collect::<Vec<_>>(),
        "runs": runs.collect::<Vec<_>>(),
    })
}

/// A number with its error bar; null where it has none.
pub fn bar(bar: &Bar) -> Value {
    let amount = bar.number.amount;
    let parts = bar.parts.iter().map(|part| {
        json!({
            "direction": part.direction.key(),
            "share": rounded(part.share),
            "error": rounded(part.estimate.error),
            "order": part.estimate.order.map(rounded),
            "extrapolated": part.estimate.extrapolated,
        })
    });
    json!({
        "key": bar.number.key,
        "value": rounded(amount.value),
        "unit": amount.unit.spelled(),
        "error_bar": bar.half.map(rounded),
        "why_none": Some(bar.why.to_string()).filter(|why| !why.is_empty()),
        "parts": parts.collect::<Vec<_>>(),
    })
}
