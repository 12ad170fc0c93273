//! What the report is of: its title block, and the case, its file and checksum, the program.

use super::document::{Block, Row, Section};
use super::program::PROGRAM;
use super::solved::Report;
use crate::output::summary::{section_of, sha256};

/// What was given for it, and the case.
pub(super) fn block(report: &Report) -> Vec<[String; 2]> {
    let given = report.title_block.entries().map(|(name, value)| [name.to_owned(), value.to_owned()]);
    given.chain([["Case".to_owned(), report.solution.case.name.clone()]]).collect()
}

pub(super) fn section(report: &Report) -> Section {
    let case = &report.solution.case;
    let names = case.stage_names().collect::<Vec<_>>().join(", ");
    let ended = match report.solution.stages.last() {
        Some(_) if report.solution.is_complete() => "complete".to_owned(),
        Some(last) => format!("stopped early: {}", last.stop),
        None => "not begun".to_owned(),
    };
    let rows = [
        ("Case file", case.path.display().to_string()),
        ("Set on the command line", case.overrides.join(", ")),
        ("Section", section_of(case.model().extent()).to_string()),
        ("Stages", if case.later().is_empty() { String::new() } else { names }),
        ("Run", ended),
        ("Program", PROGRAM.to_owned()),
        ("SHA-256 of the case, settings applied", sha256(&case.text)),
    ];
    let rows = rows.into_iter().filter(|(_, value)| !value.is_empty());
    let rows = rows.map(|(label, value)| Row::plain([label.to_owned(), value])).collect();
    Section { heading: "Case".into(), blocks: vec![Block::Table { head: vec!["What", "Which"], rows }] }
}
