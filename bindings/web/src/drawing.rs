//! A case file around the tools of a drawing.

use crate::request::Failure;
use serde_json::{Value, json};
use stampflow::author::{Draft, Drawn};
use stampflow::import::{self, ImportError, Options, Section};
use stampflow::model::Geometry;

/// The text of a case, with placeholders for what no drawing says, and how the drawing was understood.
pub fn read(name: &str, plane_strain: bool, file: &[u8]) -> Result<Value, Failure> {
    let sections = import::read(file, &Options::default()).map_err(|error| refused(&error))?;
    let stage = |number: u32| format!("op{number}");
    let title = format!("Tools of {name}");
    let draft = Draft {
        title: &title,
        geometry: if plane_strain { Geometry::PlaneStrain } else { Geometry::Axisymmetric },
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
    Ok(json!({ "text": written, "notes": sections.notes }))
}

fn drawn(tools: &[Section]) -> Vec<Drawn<'_>> {
    tools.iter().map(|tool| (tool.role, &tool.profile, tool.made_of.as_str())).collect()
}

fn refused(error: &ImportError) -> Failure {
    let ImportError { what, help, line } = error;
    let column = line.map(|_| 1);
    Failure { what: what.clone(), help: help.clone(), line: *line, column, rendered: error.to_string() }
}
