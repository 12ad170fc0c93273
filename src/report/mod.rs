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

pub use document::{Block, Document, Issue, KeyNumber, Picture, Row, Section};
pub use html::html;
pub use program::MARKER;
pub use solved::Report;

impl Report<'_> {
    /// The first page and all sections.
    pub fn document(&self) -> Document {
        let report = self;
        let model = self.solution.case.model();
        let mut sections = vec![verdict::section(&self.findings)];
        sections.extend(sureness::section(report));
        sections.extend(sketch::sections(report));
        sections.push(inputs::section(&self.check));
        sections.extend(results::sections(report));
        sections.extend(report.versus.map(|versus| versus::section(versus)));
        sections.extend([
            inputs::assumptions(&self.check),
            solver::warnings(report),
            solver::section(report),
            title::section(report),
        ]);
        Document {
            title: model.title.clone(),
            author: self.title_block.author.clone().unwrap_or_default(),
            title_block: title::block(report).map(|(name, value)| [String::from(name), value.to_owned()]).collect(),
            front: front::blocks(report),
            sections,
        }
    }
}
