//! The full verdict, line by line: a light as a sign, a word and a colour; the worst first.

use super::document::{Block, Row, Section, word};
use crate::assess::{Finding, Light, judgements};
use crate::message::Form;

/// In this order, each in the order of telling.
const ORDER: [Light; 4] = [Light::Red, Light::Amber, Light::Grey, Light::Green];

pub(super) fn section(findings: &[Finding], form: Form) -> Section {
    let of = |light| judgements(findings).filter(move |finding| finding.light == light);
    let rows = ORDER.into_iter().flat_map(of).map(|finding| Row {
        light: Some(finding.light),
        ..Row::plain([
            word(finding.light, form),
            form.tell(finding.label),
            finding.found.told(form),
            format!("{} ({})", finding.limit.told(form), finding.source.told(form)),
            finding.advice.told(form),
        ])
    });
    let head = ["Light", "Question", "Found", "Limit (source)", "What to change"];
    Section { heading: form.tell("Verdict"), blocks: vec![Block::table(head, rows.collect(), form)] }
}
