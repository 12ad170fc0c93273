//! The words of the verdict, each explained once.

use super::document::{Block, Row, Section};
use crate::assess::{Finding, judgements};
use crate::message::{Form, Term};

/// Of every row that has a word to explain, in the order of telling.
pub(super) fn section(findings: &[Finding], form: Form) -> Section {
    let mut terms: Vec<&'static Term> = Vec::new();
    for term in judgements(findings).filter_map(|finding| Term::of_row(finding.key)) {
        if !terms.iter().any(|known| known.name == term.name) {
            terms.push(term);
        }
    }
    let rows =
        terms.into_iter().map(|term| Row::plain([&term.name, &term.meaning].map(|text| form.tell(text.as_str()))));
    Section { heading: form.tell("Words"), blocks: vec![Block::table(["Word", "Meaning"], rows.collect(), form)] }
}
