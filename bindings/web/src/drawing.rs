//! A case file around the tools of a drawing.

use crate::json::{Value, table};
use crate::question::{Failure, Question};
use stampflow::author::{Draft, Drawn};
use stampflow::import::{self, ImportError, Options, Section};
use stampflow::model::Geometry;

/// The text of a case, with placeholders for what no drawing says, and how the drawing was understood.
pub fn read(question: &Question, file: &[u8]) -> Result<Value, Failure> {
    let name = question.text("name");
    let sections = import::read(file, &Options::default()).map_err(|error| refused(&error))?;
    let stage = |number: u32| format!("op{number}");
    let title = format!("Tools of {name}");
    let draft = Draft {
        title: &title,
        geometry: match question.text("geometry") {
            "plane_strain" => Geometry::PlaneStrain,
            _ => Geometry::Axisymmetric,
        },
        name: sections.number.map(stage).or_else(|| (!sections.later.is_empty()).then(|| "first".to_owned())),
        tools: drawn(&sections.tools),
        later: sections
            .later
            .iter()
            .map(|later| (later.number.map_or_else(String::new, stage), drawn(&later.tools)))
            .collect(),
        material: None,
        thickness: None,
        blank: None,
        travel: None,
        notes: &sections.notes,
    };
    let written = draft.toml();
    draft.case(&written, name)?;
    Ok(table! { "text": written, "notes": Value::list(sections.notes.iter().map(String::as_str)) })
}

fn drawn(tools: &[Section]) -> Vec<Drawn<'_>> {
    tools.iter().map(|tool| (tool.role, &tool.profile, tool.made_of.as_str())).collect()
}

fn refused(error: &ImportError) -> Failure {
    let ImportError { what, help, line } = error;
    let at = line.map(|line| (line, 1));
    Failure { what: what.clone(), help: help.clone(), at, rendered: error.to_string() }
}
