//! Runs side by side, for programs.

use crate::study::versus::{Change, Versus};
use crate::units::rounded;
use serde_json::{Value, json};

/// All numbers of all runs, and how far what was measured is.
pub fn versus(versus: &Versus) -> Value {
    let members = versus.members.iter().map(|member| {
        let end = &member.outcome().end;
        json!({
            "run": member.mark,
            "name": member.name.to_string(),
            "case": member.solution.case.path,
            "overrides": member.solution.case.overrides,
            "verdict": member.light.name(),
            "red": member.red,
            "amber": member.amber,
            "end": end.kind,
            "complete": end.complete,
            "reason": end.why.to_string(),
        })
    });
    let numbers = versus.compared().into_iter().map(|compared| {
        let changes = std::iter::once(Change::None).chain(compared.changes);
        let values = compared.values.iter().zip(changes).map(|(amount, change)| {
            json!({
                "value": amount.map(|amount| rounded(amount.value)),
                "error_bar": amount.and_then(|amount| amount.bar()).map(rounded),
                "difference": change.value().map(rounded),
                "within_error": change.is_within(),
            })
        });
        json!({
            "key": compared.number.key,
            "of": compared.number.of.key(),
            "unit": compared.number.amount.unit.spelled(),
            "values": values.collect::<Vec<_>>(),
        })
    });
    let measured = versus.misfits().into_iter().map(|misfit| {
        let rms = misfit.of_members.iter().map(|found| {
            found.map(|(amount, n)| {
                json!({
                    "rms": rounded(amount.value), "unit": amount.unit.spelled(), "points": n,
                })
            })
        });
        json!({ "curve": misfit.curve, "points": misfit.points, "of_runs": rms.collect::<Vec<_>>() })
    });
    json!({
        "runs": members.collect::<Vec<_>>(),
        "numbers": numbers.collect::<Vec<_>>(),
        "measured": measured.collect::<Vec<_>>(),
    })
}
