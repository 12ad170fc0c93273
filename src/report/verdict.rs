//! The full verdict, line by line: a light as a sign, a word and a colour; the worst first.

use super::document::{Block, Row, Section, word};
use crate::assess::{Finding, Light, judgements};

/// In this order, each in the order of telling.
const ORDER: [Light; 4] = [Light::Red, Light::Amber, Light::Grey, Light::Green];

pub(super) fn section(findings: &[Finding]) -> Section {
    let of = |light| judgements(findings).filter(move |finding| finding.light == light);
    let rows = ORDER.into_iter().flat_map(of).map(|finding| Row {
        light: Some(finding.light),
        ..Row::plain([
            word(finding.light),
            String::from(finding.label),
            finding.found(),
            format!("{} ({})", finding.limit.to_string(), finding.source.to_string()),
            finding.advice.to_string(),
        ])
    });
    let head = ["Light", "Question", "Found", "Limit (source)", "What to change"];
    Section { heading: String::from("Verdict"), blocks: vec![Block::table(head, rows.collect())] }
}
