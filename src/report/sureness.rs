//! How sure the numbers are: each with its error bar, what that is made of, and whatever is no small error.

use super::document::{Block, Row, Section};
use super::solved::Report;
use crate::study::verify::{Bar, Of};

/// Of a case that was verified; what a bar is made of is not known from one coarser run alone.
pub(super) fn section(report: &Report) -> Option<Section> {
    let verification = report.verification?;
    let sentences = verification.sentences().into_iter().map(|sentence| String::from(sentence));
    let mut blocks = vec![Block::List(sentences.collect())];
    // The verdict above tells its own.
    let bars: Vec<&Bar> = verification.bars.iter().filter(|bar| bar.number.of != Of::Verdict).collect();
    if bars.iter().any(|bar| bar.parts.len() > 1) {
        let rows = bars.iter().map(|bar| Row::plain(row(bar).into_iter().chain([String::from(bar.made_of())])));
        blocks.push(Block::table(["Quantity", "Value", "Unit", "Made of (observed order)"], rows.collect()));
    } else if bars.iter().any(|bar| bar.half.is_some()) {
        let rows = bars.iter().map(|bar| Row::plain(row(bar)));
        blocks.push(Block::table(["Quantity", "Value", "Unit"], rows.collect()));
    }
    Some(Section { heading: String::from("How sure"), blocks })
}

/// A number with its bar, and its unit.
fn row(bar: &Bar) -> [String; 3] {
    let (value, unit) = bar.amount().parts();
    [String::from(bar.number.label), value, unit.to_owned()]
}
