//! How sure the numbers are: each with its error bar, what that is made of, and whatever is no small error.

use super::document::{Block, Row, Section};
use super::solved::Report;
use crate::message::Form;
use crate::verification::{Of, Verification};

/// Of a case that was verified; from one coarser run alone it is not known what a bar is made of.
pub(super) fn section(report: &Report, form: Form) -> Option<Section> {
    let verification = report.verification?;
    let sentences = verification.sentences().into_iter().map(|sentence| form.tell(sentence));
    let mut blocks = vec![Block::List(sentences.collect())];
    let is_made_of = verification.bars.iter().any(|bar| bar.parts.len() > 1);
    if verification.bars.iter().any(|bar| bar.half.is_some()) {
        blocks.push(match is_made_of {
            true => Block::table(["Quantity", "Value", "Made of (observed order)"], rows(verification, form, 3), form),
            false => Block::table(["Quantity", "Value"], rows(verification, form, 2), form),
        });
    }
    Some(Section { heading: form.tell("How sure"), blocks })
}

/// Numbers of the part and the press, in so many columns: the verdict above has its own.
fn rows(verification: &Verification, form: Form, columns: usize) -> Vec<Row> {
    let told = verification.bars.iter().filter(|bar| bar.number.of != Of::Verdict);
    let cells = |bar: &crate::verification::Bar| {
        [form.tell(bar.number.label), form.tell(bar.amount()), form.tell(bar.made_of())].into_iter().take(columns)
    };
    told.map(|bar| Row::plain(cells(bar))).collect()
}
