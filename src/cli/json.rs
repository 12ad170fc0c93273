//! Comparisons and error bars for programs that read them instead of what is printed.

use serde_json::{Map, Value, json};
use stampflow::results::comparison::Comparison;
use stampflow::results::error_bars::Number;
use stampflow::study::verify::Verification;
use stampflow::units::{ErrorBar, rounded};

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
        "numbers": verification.bars.numbers.iter().map(number).collect::<Vec<_>>(),
        "told": verification.bars.notes,
        "runs": runs.collect::<Vec<_>>(),
    })
}

fn number(number: &Number) -> Value {
    let quantity = &number.quantity;
    let parts = number.contributions.iter().map(|part| {
        json!({
            "direction": part.direction.replace([' ', '-'], "_"),
            "share": rounded(part.share),
            "error": rounded(part.error),
            "order": part.order.map(rounded),
            "extrapolated": part.extrapolated,
        })
    });
    json!({
        "key": quantity.key,
        "value": rounded(quantity.value()),
        "unit": quantity.amount.unit.spelled(),
        "error_bar": number.half().map(rounded),
        "why_none": if let ErrorBar::Missing(why) = &quantity.error { Some(why) } else { None },
        "parts": parts.collect::<Vec<_>>(),
    })
}
