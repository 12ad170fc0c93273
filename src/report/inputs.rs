//! What was given and what follows from it, as the check of a case has it.

use super::document::{Block, Row, Section};
use crate::assess::check::{Check, Line};
use crate::message::Form;

pub(super) fn section(check: &Check, form: Form) -> Section {
    let table = |head, lines: &[Line]| {
        let rows =
            lines.iter().map(|line| Row::plain([&line.label, &line.value, &line.meaning].map(|text| text.told(form))));
        Block::table([head, "Value", "Meaning"], rows.collect(), form)
    };
    let blocks = vec![table("Input", &check.lines), table("Sheet, mesh and solver", &check.details)];
    Section { heading: form.tell("Inputs"), blocks }
}

/// Declared assumptions, and what was assumed while reading.
pub(super) fn assumptions(check: &Check, form: Form) -> Section {
    let none = || Block::Paragraph(form.tell("None are declared."));
    let block = if check.notes.is_empty() {
        none()
    } else {
        Block::List(check.notes.iter().map(|note| note.told(form)).collect())
    };
    Section { heading: form.tell("Assumptions"), blocks: vec![block] }
}
