//! How sure the numbers are: each with its error bar, what that is made of, and whatever is no small error.

use super::document::{Block, Row, Section};
use super::solved::Report;
use crate::message::Form;
use crate::study::verify::{Bar, Of};

/// Of a case that was verified; what a bar is made of is not known from one coarser run alone.
pub(super) fn section(report: &Report, form: Form) -> Option<Section> {
    let verification = report.verification?;
    let sentences = verification.sentences().into_iter().map(|sentence| form.tell(sentence));
    let mut blocks = vec![Block::List(sentences.collect())];
    // The verdict above tells its own.
    let bars: Vec<&Bar> = verification.bars.iter().filter(|bar| bar.number.of != Of::Verdict).collect();
    if bars.iter().any(|bar| bar.parts.len() > 1) {
        let rows = bars.iter().map(|bar| Row::plain(row(bar, form).into_iter().chain([form.tell(bar.made_of())])));
        blocks.push(Block::table(["Quantity", "Value", "Unit", "Made of (observed order)"], rows.collect(), form));
    } else if bars.iter().any(|bar| bar.half.is_some()) {
        let rows = bars.iter().map(|bar| Row::plain(row(bar, form)));
        blocks.push(Block::table(["Quantity", "Value", "Unit"], rows.collect(), form));
    }
    Some(Section { heading: form.tell("How sure"), blocks })
}

/// A number with its bar, and its unit.
fn row(bar: &Bar, form: Form) -> [String; 3] {
    let (value, unit) = bar.amount().parts();
    [form.tell(bar.number.label), value, unit.to_owned()]
}
