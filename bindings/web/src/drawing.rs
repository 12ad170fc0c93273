//! A case around the tools of a drawing.

use crate::request::Failure;
use serde_json::{Value, json};
use stampflow::author::{Import, ImportFailure};
use stampflow::import::Options;
use stampflow::model::Geometry;
use std::path::Path;

/// Text of a case, with placeholders for what no drawing says, and how the drawing was understood.
pub fn read(name: &str, plane_strain: bool, file: &[u8]) -> Result<Value, Failure> {
    let geometry = if plane_strain { Geometry::PlaneStrain } else { Geometry::Axisymmetric };
    let options = Options::default();
    let import = Import { options, geometry, material: None, thickness: None, blank: None, travel: None };
    let imported = import.read(file, Path::new(name))?;
    Ok(json!({ "text": imported.text, "notes": imported.notes }))
}

impl From<ImportFailure> for Failure {
    fn from(failure: ImportFailure) -> Self {
        match failure {
            ImportFailure::Drawing(error) => {
                let rendered = error.to_string();
                Self { what: error.what, help: error.help, line: error.line, column: error.line.map(|_| 1), rendered }
            }
            ImportFailure::Sheet(error) | ImportFailure::Case(error) => error.into(),
        }
    }
}
