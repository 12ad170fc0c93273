//! What the report is of: its title block, and the case, its file and checksum, the program.

use super::document::{Block, Row, Section};
use super::program::PROGRAM;
use super::solved::Report;
use crate::case::files::sha256;
use crate::results::summary::section_of;

/// What was given for it, and the case.
pub(super) fn block<'a>(report: &'a Report) -> impl Iterator<Item = (&'static str, &'a str)> {
    report.title_block.entries().chain([("Case", report.solution.case.name.as_str())])
}

pub(super) fn section(report: &Report) -> Section {
    let case = &report.solution.case;
    let names = case.stage_names().collect::<Vec<_>>().join(", ");
    let ended: String = match report.solution.stages.last() {
        Some(_) if report.solution.is_complete() => "complete".into(),
        Some(last) => format!("stopped early: {why}", why = last.stop.to_string()),
        None => "not begun".into(),
    };
    let rows = [
        ("Case file", case.path.display().to_string()),
        ("Set on the command line", case.overrides.join(", ")),
        ("Section", String::from(section_of(case.model().extent()))),
        ("Stages", if case.later().is_empty() { String::new() } else { names }),
        ("Run", String::from(ended)),
        ("Program", PROGRAM.to_owned()),
        ("SHA-256 of the case, settings applied", sha256([&case.text])),
    ];
    let rows = rows.into_iter().filter(|(_, value)| !value.is_empty());
    let rows = rows.map(|(label, value)| Row::plain([String::from(label), value])).collect();
    Section { heading: String::from("Case"), blocks: vec![Block::table(["What", "Which"], rows)] }
}
