//! What a search has found, for programs.

use crate::study::search::{Answer, Best, Found, Quest, Wish};
use crate::study::verify::Verification;
use crate::study::{Row, Span, Vary};
use crate::units::rounded;
use serde_json::{Map, Value, json};
use std::ops::RangeInclusive;

/// Where a condition ends, or a number has a value: values in the unit of the key, numbers in those of their columns, those of
/// the answer's run with error bars.
pub fn found(quest: &Quest, answer: &Answer, bars: Option<&Verification>) -> Value {
    let bracket = &answer.bracket;
    let range = |range: &RangeInclusive<f64>| json!([range.start(), range.end()]);
    let found = match bracket.found {
        Found::Between(_) => "between",
        Found::Everywhere(_) => "everywhere",
        Found::Nowhere => "nowhere",
        Found::Open(_) => "open",
        Found::Failed => "failed",
        Found::Interrupted => "interrupted",
    };
    let tolerance = match bracket.found {
        Found::Between([inner, outer]) => Some(rounded((outer - inner).abs())),
        _ => None,
    };
    let run = |at: usize| run(answer.value(at), &answer.rows[at], bars.filter(|_| Some(at) == answer.best));
    json!({
        "key": quest.span.key(),
        "unit": quest.span.unit(),
        "found": found,
        "value": answer.best.map(|run| answer.value(run)),
        "tolerance": tolerance,
        "wanted": answer.wanted.map(rounded),
        "best": answer.best.map(run),
        "other": answer.other.map(run),
        "draw_ratios": answer.draw_ratios.map(|ratios| ratios.map(rounded)),
        "stretches": bracket.stretches.iter().map(range).collect::<Vec<_>>(),
        "mixed": bracket.mixed.as_ref().map(range),
        "runs": answer.rows.len(),
        "failed": answer.failed.iter().map(|(why, count)| json!({ "why": why, "runs": count })).collect::<Vec<_>>(),
    })
}

/// The best of several keys, likewise.
pub fn best(wish: &Wish, found: &Best, bars: Option<&Verification>) -> Value {
    let keys = wish.spans.iter().flat_map(Span::keys).map(Vary::header);
    let values = found.best.map(|best| {
        let values = found.rows[best].design.values.iter().map(|value| json!(value.number));
        keys.zip(values).collect::<Map<_, _>>()
    });
    json!({
        "number": wish.number.text,
        "values": values,
        "best": found.best.map(|best| run(f64::NAN, &found.rows[best], bars)),
        "binding": found.binding,
        "runs": found.rows.len(),
    })
}

/// A run with its lights and numbers.
fn run(value: f64, row: &Row, bars: Option<&Verification>) -> Value {
    let solved = row.result.as_ref().ok();
    let numbers = solved.into_iter().flat_map(|solved| &solved.outcome.numbers).map(|number| {
        let bar = bars.and_then(|bars| bars.bar(number.of, number.key)).and_then(|bar| bar.half).map(rounded);
        json!({
            "told_by": number.of.key(),
            "key": number.key,
            "value": rounded(number.amount.value),
            "unit": number.amount.unit.spelled(),
            "error_bar": bar,
        })
    });
    json!({
        "value": value,
        "light": solved.map(|solved| solved.light.name()),
        "red": solved.map(|solved| &solved.red),
        "amber": solved.map(|solved| &solved.amber),
        "end": solved.map(|solved| solved.outcome.end.kind),
        "numbers": numbers.collect::<Vec<_>>(),
    })
}
