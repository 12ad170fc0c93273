//! The verdict, line by line: a light as a sign, a word and a colour.

use super::document::{Block, Row, Section};
use crate::assess::{Finding, Light, headline, judgements};

pub(super) fn section(findings: &[Finding]) -> Section {
    let rows = judgements(findings).map(|finding| Row {
        cells: vec![
            word(finding.light).to_owned(),
            finding.label.to_owned(),
            finding.found.to_string(),
            format!("{} ({})", finding.limit, finding.source),
            finding.advice.to_string(),
        ],
        light: Some(finding.light),
    });
    let head = vec!["Light", "Question", "Found", "Limit (source)", "What to change"];
    let all = Block::Paragraph(format!("{}.", headline(findings)));
    Section { heading: "Verdict".into(), blocks: vec![all, Block::Table { head, rows: rows.collect() }] }
}

/// Sign and word: the colour only repeats them.
fn word(light: Light) -> &'static str {
    match light {
        Light::Grey => "○ grey",
        Light::Green => "● green",
        Light::Amber => "▲ amber",
        Light::Red => "■ red",
    }
}
