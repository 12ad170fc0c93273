//! How the numbers were found: mesh, steps, norms; and what the solver and the check warn of.

use super::document::{Block, Row, Section};
use super::solved::Report;
use crate::assess::Kind;
use crate::results::summary::{Figure, Group, Summary};

pub(super) fn section(report: &Report) -> Section {
    let mut blocks = Vec::new();
    for (i, (_, summary)) in report.stages.iter().enumerate() {
        let stage = report.stage(i);
        if !stage.is_empty() {
            blocks.push(Block::Paragraph(format!("Stage {name}", name = stage.trim_end_matches(": "))));
        }
        blocks.push(figures(summary, |group| group == Group::Solution));
    }
    Section { heading: String::from("Solver"), blocks }
}

/// A table of the summary's lines that are about something; what belongs to the line above is indented.
pub(super) fn figures(summary: &Summary, is_wanted: fn(Group) -> bool) -> Block {
    let row = |f: Figure| Row {
        belongs: f.label.starts_with(' '),
        ..Row::plain([f.label.trim_start().to_owned(), f.value, f.unit.to_owned()])
    };
    let wanted = summary.figures().filter(|figure| is_wanted(figure.group));
    Block::table(["Quantity", "Value", "Unit"], wanted.map(row).collect())
}

/// What the check says before and the solver after the run.
pub(super) fn warnings(report: &Report) -> Section {
    let warnings = report.findings.iter().filter(|finding| finding.kind == Kind::Warning);
    let stage = |i: Option<usize>| i.map_or(String::new(), |i| report.stage(i));
    let all: Vec<String> = warnings.map(|finding| stage(finding.stage) + &finding.sentence().to_string()).collect();
    let none = || Block::Paragraph(String::from("None."));
    let block = if all.is_empty() { none() } else { Block::List(all) };
    Section { heading: String::from("Warnings"), blocks: vec![block] }
}
