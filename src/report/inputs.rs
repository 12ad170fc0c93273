//! What was given and what follows from it, as the check of a case has it.

use super::document::{Block, Row, Section};
use crate::assess::check::{Check, Line};

pub(super) fn section(check: &Check) -> Section {
    let table = |head, lines: &[Line]| {
        let rows =
            lines.iter().map(|line| Row::plain([&line.label, &line.value, &line.meaning].map(|text| text.to_string())));
        Block::table([head, "Value", "Meaning"], rows.collect())
    };
    let blocks = vec![table("Input", &check.lines), table("Sheet, mesh and solver", &check.details)];
    Section { heading: String::from("Inputs"), blocks }
}

/// Declared assumptions, and what was assumed while reading.
pub(super) fn assumptions(check: &Check) -> Section {
    let none = || Block::Paragraph(String::from("None are declared."));
    let block = if check.notes.is_empty() {
        none()
    } else {
        Block::List(check.notes.iter().map(|note| note.to_string()).collect())
    };
    Section { heading: String::from("Assumptions"), blocks: vec![block] }
}
