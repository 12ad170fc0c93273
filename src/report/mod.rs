//! A solved case on a few pages for people: one [`Document`] of sections, written as HTML or as Markdown, and the same
//! numbers as JSON.
//!
//! Each file of this folder makes one part. The document holds nothing of the clock but the wall time of the solution, so
//! two reports of one case can be compared.

mod document;
mod html;
mod inputs;
mod markdown;
mod program;
mod results;
mod sketch;
mod solved;
mod solver;
mod title;
mod verdict;

pub use document::{Block, Document, Picture, Row, Section};
pub use html::html;
pub use markdown::{figure_folder, is_figure, markdown};
pub use program::MARKER;
pub use solved::Report;

impl Report<'_> {
    /// All sections.
    pub fn document(&self) -> Document {
        let model = self.solution.case.model();
        let mut sections = vec![
            title::section(self),
            verdict::section(&self.findings),
            sketch::section(model, &self.dimensions),
            inputs::section(&self.check),
        ];
        sections.extend(results::sections(self));
        sections.extend([inputs::assumptions(&self.check), solver::warnings(self), solver::section(self)]);
        Document { title: model.title.clone(), sections }
    }
}
