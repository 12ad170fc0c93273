//! Requests of the page, and why one fails.

use crate::sliders::Sliders;
use crate::{solve, trace};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use stampflow::author::Import;
use stampflow::author::templates::{Choice, TEMPLATES, Template, find};
use stampflow::case::files::Memory;
use stampflow::case::{Case, CaseError, library, parse_with};
use stampflow::import::{ImportError, Options};
use stampflow::model::Geometry;
use std::collections::BTreeMap;
use std::path::Path;

/// A request; `do` is its kind.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
pub enum Request {
    /// Templates with their options, and the names of all sheets.
    Templates,
    /// Text of a template's case.
    Fill { name: String, given: BTreeMap<String, String> },
    /// Sliders of a case's text.
    Sliders { text: String },
    /// A solved case.
    Solve {
        #[serde(flatten)]
        case: CaseText,
        #[serde(default)]
        coarse: bool,
    },
    /// One step, iteration by iteration, with each matrix.
    Trace {
        #[serde(flatten)]
        case: CaseText,
        step: usize,
    },
    /// A case around the tools of a DXF drawing.
    Drawing { name: String },
}

/// A case as text, with the files beside it.
#[derive(Deserialize)]
pub struct CaseText {
    text: String,
    #[serde(default)]
    name: String,
    #[serde(default)]
    overrides: Vec<String>,
    #[serde(default)]
    files: BTreeMap<String, String>,
}

impl CaseText {
    /// Reads the case.
    pub fn case(&self) -> Result<Case, Failure> {
        let mut files = Memory::default();
        for (path, text) in &self.files {
            files.insert(path, text.as_str());
        }
        let name = if self.name.is_empty() { "case.toml" } else { &self.name };
        Ok(parse_with(&self.text, name, &self.overrides, &files)?)
    }
}

impl Request {
    /// The answer; `file` are the bytes of a drawing.
    pub fn answer(&self, file: &[u8]) -> Result<Value, Failure> {
        match self {
            Self::Templates => Ok(templates()),
            Self::Fill { name, given } => {
                let given: Vec<(&str, &str)> = given.iter().map(|(key, value)| (&key[..], &value[..])).collect();
                Ok(json!({ "text": find(name)?.fill(&given)? }))
            }
            Self::Sliders { text } => Ok(json!(Sliders::of_case(text))),
            Self::Solve { case, coarse } => Ok(solve::solve(case.case()?, *coarse)),
            Self::Trace { case, step } => trace::step(&case.case()?, *step)
                .map_err(|missing| Failure { what: missing.to_string(), ..Failure::default() }),
            Self::Drawing { name } => drawing(name, file),
        }
    }
}

fn templates() -> Value {
    let option = |choice: &Choice| json!({ "key": choice.key, "default": choice.default, "about": choice.about });
    let template = |template: &Template| {
        let options: Vec<Value> = template.options().map(option).collect();
        json!({ "name": template.name, "about": template.about, "options": options })
    };
    json!({
        "templates": TEMPLATES.iter().map(template).collect::<Vec<_>>(),
        "sheets": library::names().collect::<Vec<_>>(),
    })
}

/// Text of a case around the tools of a drawing, with placeholders, and how the drawing was understood.
fn drawing(name: &str, file: &[u8]) -> Result<Value, Failure> {
    let (options, geometry) = (Options::default(), Geometry::Axisymmetric);
    let import = Import { options, geometry, material: None, thickness: None, blank: None, travel: None };
    let imported = import.read(file, Path::new(name))?;
    Ok(json!({ "text": imported.text, "notes": imported.notes }))
}

/// Why there is no answer.
#[derive(Default, Serialize)]
pub struct Failure {
    pub what: String,
    pub help: String,
    /// From 1.
    pub line: Option<usize>,
    /// From 1.
    pub column: Option<usize>,
    /// The whole message as the command line prints it.
    pub rendered: String,
}

impl From<CaseError> for Failure {
    fn from(error: CaseError) -> Self {
        let at = error.position();
        Self {
            what: error.to_string(),
            help: error.remedy().unwrap_or_default().to_owned(),
            line: at.map(|at| at.0),
            column: at.map(|at| at.1),
            rendered: error.render(false),
        }
    }
}

impl From<ImportError> for Failure {
    fn from(error: ImportError) -> Self {
        let rendered = error.to_string();
        Self { what: error.what, help: error.help, line: error.line, column: error.line.map(|_| 1), rendered }
    }
}
