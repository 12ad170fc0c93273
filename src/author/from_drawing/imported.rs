//! From the bytes of a drawing to a case: what `stampflow import` writes and Python solves.

use super::draft::{Draft, Drawn};
use crate::assess::SIZE_CHECKS;
use crate::case::{Case, CaseError, library};
use crate::import::{self, ImportError, Options, Section, Sections};
use crate::model::Geometry;
use std::path::Path;

/// How a drawing is read, and what is known besides it.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// How it is to be understood.
    pub options: Options,
    /// What its section stands for.
    pub geometry: Geometry,
    /// A sheet of the library, by its name or a grade that it stands for; a placeholder where `None`.
    pub material: Option<String>,
    /// Of the sheet \[mm\]; a placeholder where `None`.
    pub thickness: Option<f64>,
    /// Radius or half-length \[mm\]; a placeholder where `None`.
    pub blank: Option<f64>,
    /// Of the punch \[mm\]; a placeholder where `None`.
    pub travel: Option<f64>,
}

/// A case that was made from a drawing.
#[derive(Clone, Debug)]
pub struct Imported {
    /// The tools as they are drawn.
    pub sections: Sections,
    /// The case file's text.
    pub text: String,
    /// The case; `None` where no punch is drawn, so that the user has to give one.
    pub case: Option<Case>,
    /// How large the tools are.
    pub size: String,
    /// How the drawing was understood, what follows from it in the case, and what is doubted.
    pub notes: Vec<String>,
}

/// Why no case is made from a drawing.
#[derive(Debug, thiserror::Error)]
pub enum ImportFailure {
    /// The drawing cannot be read.
    #[error(transparent)]
    Drawing(#[from] ImportError),
    /// There is no such sheet.
    #[error(transparent)]
    Sheet(CaseError),
    /// The tools make no case.
    #[error(transparent)]
    Case(CaseError),
}

impl Import {
    /// Makes a case of the bytes of a DXF file.
    ///
    /// # Errors
    /// When the drawing cannot be read, there is no such sheet, or the tools make no case.
    pub fn read(&self, bytes: &[u8], drawing: &Path) -> Result<Imported, ImportFailure> {
        let sections = import::read(bytes, &self.options)?;
        let name = drawing.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        self.material.as_deref().map(library::material).transpose().map_err(ImportFailure::Sheet)?;
        let title = format!("Tools of {name}");
        let draft = self.draft(&title, &sections);
        let text = draft.toml();
        let case = draft.case(&text, &drawing.display().to_string()).map_err(ImportFailure::Case)?;
        let (size, mut notes, mut doubts) = (draft.size(), sections.notes.clone(), draft.doubts());
        if let Some(case) = &case {
            // A drawing in a wrong unit makes a case in a wrong unit: that is said once.
            if doubts.is_empty() {
                let of_case = SIZE_CHECKS.iter().filter_map(|check| check(case.model()));
                doubts.extend(of_case.map(|finding| finding.sentence()));
            }
            notes.extend(case.derived.iter().map(ToString::to_string));
        }
        notes.extend(doubts);
        Ok(Imported { sections, text, case, size, notes })
    }

    fn draft<'a>(&'a self, title: &'a str, sections: &'a Sections) -> Draft<'a> {
        let later = sections.later.iter();
        Draft {
            title,
            geometry: self.geometry,
            name: sections.number.map(stage).or_else(|| (!sections.later.is_empty()).then(|| "first".to_owned())),
            tools: drawn(&sections.tools),
            later: later.map(|l| (l.number.map_or_else(String::new, stage), drawn(&l.tools))).collect(),
            material: self.material.as_deref(),
            thickness: self.thickness,
            blank: self.blank,
            travel: self.travel,
            notes: &sections.notes,
        }
    }
}

/// The name of an operation's stage.
fn stage(number: u32) -> String {
    format!("op{number}")
}

fn drawn(tools: &[Section]) -> Vec<Drawn<'_>> {
    tools.iter().map(|tool| (tool.role, &tool.profile, tool.made_of.as_str())).collect()
}
