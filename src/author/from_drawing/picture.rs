//! Picture of the tools that were read.

use super::{Imported, file_name};
use crate::import::Section;
use crate::plot::{Chart, SketchedTool, sketch};
use std::path::Path;

impl Imported {
    /// Picture of the tools as they are drawn.
    pub fn picture(&self, drawing: &Path) -> Chart {
        let tool = |tool: &Section| SketchedTool {
            label: format!("{}: {}", capitalised(tool.role.name()), tool.made_of),
            role: tool.role,
            profile: tool.profile.clone(),
            ends: tool.ends.clone(),
        };
        let later = self.sections.later.iter().map(|later| &later.tools);
        let operations: Vec<Vec<SketchedTool>> = std::iter::once(&self.sections.first.tools)
            .chain(later)
            .map(|all| all.iter().map(tool).collect())
            .collect();
        let caption = "Circles: where drawn lines, arcs and splines begin and end. The tools are where they are drawn; the \
                       case moves each along z to where it touches the sheet.";
        let notes = self.sections.notes.iter().map(|note| format!("{}.", capitalised(note)));
        let notes = std::iter::once(caption.to_owned()).chain(notes).collect();
        sketch(format!("{}: the tools that were read", file_name(drawing)), self.geometry, &operations, notes)
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
