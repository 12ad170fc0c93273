//! What was given and what follows from it, as the check of a case has it.

use super::document::{Block, Row, Section};
use crate::assess::check::Check;
use crate::message::Form;

pub(super) fn section(check: &Check) -> Section {
    let rows =
        check.lines.iter().map(|line| Row::plain([&line.label, &line.value, &line.meaning].map(ToString::to_string)));
    let head = vec!["Input", "Value", "Unit and meaning"];
    Section { heading: "Inputs".into(), blocks: vec![Block::Table { head, rows: rows.collect() }] }
}

/// Declared assumptions, and what was assumed while reading.
pub(super) fn assumptions(check: &Check, form: Form) -> Section {
    let none = || Block::Paragraph("None are declared.".into());
    let block = if check.notes.is_empty() {
        none()
    } else {
        Block::List(check.notes.iter().map(|note| note.told(form)).collect())
    };
    Section { heading: "Assumptions".into(), blocks: vec![block] }
}
