//! The verdict for programs that read it instead of what is printed.

use crate::assess::{Answer, Finding, judgements};
use crate::study::verify::{Told, Verification};
use serde_json::Value;

/// Its light and sentence, the key numbers, and every row with its number, unit and limits; with error bars what those are from,
/// and what is told of them.
///
/// # Errors
/// Never: all of it has a form in JSON.
pub fn verdict(
    answer: &Answer,
    findings: &[Finding],
    verification: Option<&Verification>,
) -> serde_json::Result<Value> {
    let mut value = serde_json::to_value(answer)?;
    value["findings"] = judgements(findings).map(serde_json::to_value).collect::<Result<_, _>>()?;
    if let Some(verification) = verification {
        value["error_bars"] = serde_json::to_value(Told::from(verification))?;
    }
    Ok(value)
}
