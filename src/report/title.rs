//! What the report is of: the case, its file and checksum, the program.

use super::document::{Block, Row, Section};
use super::{PROGRAM, Report};
use crate::output::Summary;
use serde_json::json;

pub(super) fn section(report: &Report) -> Section {
    let case = report.case;
    let summary = report.subjects().next().map(|subject| json!(Summary::of(&subject)));
    let said = |key: &str| summary.as_ref().and_then(|s| s[key].as_str()).unwrap_or_default().to_owned();
    let names = case.stage_names().collect::<Vec<_>>().join(", ");
    let ended = match report.passes.last() {
        Some(_) if report.is_complete() => "complete".to_owned(),
        Some(last) => format!("stopped early: {}", last.stop),
        None => "not begun".to_owned(),
    };
    let rows = [
        ("Case file", case.path.display().to_string()),
        ("Set on the command line", report.overrides.join(", ")),
        ("Section", said("section")),
        ("Stages", if case.later().is_empty() { String::new() } else { names }),
        ("Run", ended),
        ("Program", PROGRAM.to_owned()),
        ("SHA-256 of the case, settings applied", said("case_sha256")),
    ];
    let rows = rows.into_iter().filter(|(_, value)| !value.is_empty());
    let rows = rows.map(|(label, value)| Row::plain([label.to_owned(), value])).collect();
    Section { heading: "Case".into(), blocks: vec![Block::Table { head: vec!["What", "Which"], rows }] }
}
