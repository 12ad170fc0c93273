//! A solved case on a few pages for people: one [`Document`] of sections, written as HTML, and the same numbers as JSON.
//!
//! Each file of this folder makes one part. The document holds nothing of the clock but the wall time of the solution, so
//! two reports of one case can be compared.

mod document;
mod front;
mod html;
mod inputs;
mod plots;
mod program;
mod results;
mod sizes;
mod sketch;
mod solved;
mod solver;
mod sureness;
mod title;
mod verdict;
mod versus;
mod words;

pub use document::{Block, Document, Issue, KeyNumber, Picture, Row, Section};
pub use html::html;
pub use program::MARKER;
pub use solved::Report;

use crate::message::Form;

impl Report<'_> {
    /// The first page and all sections, in English and SI units.
    pub fn document(&self) -> Document {
        self.told(Form::default())
    }

    /// The first page and all sections as they are told in a form.
    pub fn told(&self, form: Form) -> Document {
        let report = &self.in_form(form);
        let model = self.solution.case.model();
        let mut sections = vec![verdict::section(&self.findings, form)];
        sections.extend(sureness::section(report, form));
        sections.extend(sketch::sections(report, form));
        sections.push(inputs::section(&self.check, form));
        sections.extend(results::sections(report, form));
        sections.extend(report.versus.map(|versus| versus::section(versus, form)));
        sections.extend([
            inputs::assumptions(&self.check, form),
            solver::warnings(report, form),
            solver::section(report, form),
            title::section(report, form),
            words::section(&self.findings, form),
        ]);
        Document {
            title: model.title.clone(),
            author: self.title_block.author.clone().unwrap_or_default(),
            form,
            title_block: title::block(report).map(|(name, value)| [form.tell(name), value.to_owned()]).collect(),
            front: front::blocks(report, form),
            sections,
        }
    }
}
