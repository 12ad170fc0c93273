//! Picture of the tools that were read.

use super::Imported;
use crate::import::{Operation, Section, Sections};
use crate::plot::{Chart, SketchedTool, axis::capitalised, sketch};
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
        let tools = |operation: &Operation| operation.tools.iter().map(tool).collect();
        let Sections { operations, notes, .. } = &self.sections;
        let operations: Vec<Vec<SketchedTool>> = operations.iter().map(tools).collect();
        let caption = "Circles: where drawn lines, arcs and splines begin and end. The tools are where they are drawn; the \
                       case moves each along z to where it touches the sheet.";
        let notes = notes.iter().map(|note| format!("{}.", capitalised(note)));
        let title = format!("{}: the tools that were read", drawing.file_name().unwrap_or_default().display());
        sketch(title, self.geometry, &operations, std::iter::once(caption.to_owned()).chain(notes).collect())
    }
}
