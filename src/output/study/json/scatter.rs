//! What a sample says, for programs.

use crate::assess::Light;
use crate::study::scatter::{Estimate, Factor, Found, Influence, Scatter};
use crate::units::rounded;
use serde_json::{Value, json};

/// How likely each light is, how each number scatters, and what it hangs on.
pub fn scatter(scatter: &Scatter, found: &Found) -> Value {
    let numbers = found.numbers.iter().filter_map(|spread| {
        let [q05, q50, q95] = spread.quantiles()?.map(rounded);
        let (mean, deviation) = spread.moments();
        Some(json!({
            "number": spread.header,
            "runs": spread.values.len(),
            "mean": rounded(mean),
            "standard_deviation": rounded(deviation),
            "q05": q05, "q50": q50, "q95": q95,
            "influence": influence(found, &spread.influence),
        }))
    });
    let lights = found.events.iter().map(|event| {
        json!({
            "row": event.key,
            "light": event.light.name(),
            "runs": event.hits,
            "probability": estimate(event.chance),
            "influence": influence(found, &event.influence),
        })
    });
    json!({
        "answer": found.sentence().to_string(),
        "red": found.events.iter().any(|event| event.light == Light::Red && event.hits > 0),
        "runs": found.runs,
        "failed": found.failed,
        "failures": found.failures,
        "scatters": scatter.factors().iter().map(Factor::header).collect::<Vec<_>>(),
        "declared": scatter.told,
        "lights": lights.collect::<Vec<_>>(),
        "numbers": numbers.collect::<Vec<_>>(),
    })
}

fn influence(found: &Found, influence: &Influence) -> Value {
    let ranks = found.factors.iter().zip(&influence.ranks).map(|(key, rank)| (key.clone(), json!(rank.map(rounded))));
    let indices = influence.indices.as_ref().map(|indices| {
        let of = found.groups.iter().zip(indices);
        let each = of.map(|(key, index)| {
            (key.clone(), json!({ "first_order": estimate(index.first), "total": estimate(index.total) }))
        });
        Value::Object(each.collect())
    });
    json!({ "rank_correlation": Value::Object(ranks.collect()), "sobol": indices })
}

fn estimate(estimate: Estimate) -> Value {
    json!({ "value": rounded(estimate.value), "low": rounded(estimate.low), "high": rounded(estimate.high) })
}
