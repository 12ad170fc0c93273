//! Requests of the page, and why one fails.

use crate::{solve, trace};
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use stampflow::author::Import;
use stampflow::author::templates::{Choice, TEMPLATES, Template, find};
use stampflow::case::{Case, CaseError, files::Memory, library, parse_with};
use stampflow::import::{DrawingUnit, ImportError, Options};
use stampflow::model::Model;
use std::{collections::BTreeMap, path::Path};
use toml_edit::DocumentMut;

/// A request; `do` is its kind.
#[derive(Deserialize)]
#[serde(tag = "do", rename_all = "snake_case")]
pub enum Request {
    /// Templates with their options, and the names of all sheets.
    Templates,
    /// Text of a template's case.
    Fill { name: String, given: BTreeMap<String, String> },
    /// Numbers of a case's text at dotted paths, and those of its method.
    Numbers {
        #[serde(flatten)]
        case: CaseText,
        paths: Vec<String>,
    },
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
    /// Thickness points of an element in an iteration with one of the matrices, of the step that was traced last.
    Points { way: usize, iteration: usize, element: usize },
    /// A case around the tools of a DXF drawing, in a unit where its header has none or another.
    Drawing { name: String, unit: Option<String> },
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

    /// Number or text at each path; `None` where there is none.
    fn numbers(&self, paths: &[String]) -> Vec<Option<Value>> {
        let document = self.text.parse::<DocumentMut>().unwrap_or_default();
        let number = |path: &String| {
            let item = path.split('.').try_fold(document.as_item(), |item, key| item.get(key))?;
            let number = item.as_float().or(item.as_integer().map(|whole| whole as f64));
            number.map(Value::from).or(item.as_str().map(Value::from))
        };
        paths.iter().map(number).collect()
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
            Self::Numbers { case, paths } => {
                Ok(json!({ "numbers": case.numbers(paths), "method": case.case().ok().map(method) }))
            }
            Self::Solve { case, coarse } => Ok(solve::solve(case.case()?, *coarse)),
            Self::Trace { case, step } => {
                trace::step(&case.case()?, *step).map_err(|missing| Failure::new(missing.to_string()))
            }
            &Self::Points { way, iteration, element } => {
                trace::points(way, iteration, element).ok_or_else(|| Failure::new("take the step again".to_owned()))
            }
            Self::Drawing { name, unit } => drawing(name, unit.as_deref(), file),
        }
    }
}

/// Numbers of the method by their paths, stresses in GPa.
fn method(case: Case) -> Value {
    let Model { blank, settings, .. } = case.model();
    json!({
        "blank.elements": blank.elements,
        "blank.layers": blank.layers,
        "solver.max_step": settings.max_step,
        "solver.cutoff_strain": settings.cutoff_strain,
        "solver.contact_stiffness": 1e-3 * settings.contact_stiffness,
        "solver.contact_smoothing": settings.contact_smoothing,
    })
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
        "units": DrawingUnit::ALL,
    })
}

/// Text of a case around the tools of a drawing, with placeholders, and how the drawing was understood.
fn drawing(name: &str, unit: Option<&str>, file: &[u8]) -> Result<Value, Failure> {
    let unit = unit.map(str::parse).transpose().map_err(Failure::new)?;
    let options = Options { unit, ..Options::default() };
    let import = Import { options, ..Import::default() };
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

impl Failure {
    fn new(what: String) -> Self {
        Self { what, ..Self::default() }
    }
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
