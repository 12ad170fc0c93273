//! What may be asked.

use crate::numbers::Numbers;
use crate::{case, drawing, sliders, templates, trace};
use serde_json::{Value, json};
use stampflow::case::CaseError;
use stampflow::message::{Form, Language, System};

/// The answer to a question: `do` names it, and `file` are the bytes of a drawing.
pub fn answer(question: &Value, file: &[u8], numbers: &mut Numbers) -> Value {
    let answer = match text(question, "do") {
        "templates" => Ok(templates::list()),
        "fill" => templates::fill(question),
        "sliders" => Ok(sliders::of(text(question, "text"))),
        "solve" => case::solve(question, numbers),
        "drawing" => drawing::read(question, file),
        "trace" => trace::step(question, numbers),
        other => Err(Failure { what: format!("nothing is known of `{other}`"), ..Failure::default() }),
    };
    answer.unwrap_or_else(|failure| json!({ "error": failure.json() }))
}

/// A text of the question; nothing where it has none.
pub fn text<'q>(question: &'q Value, key: &str) -> &'q str {
    question[key].as_str().unwrap_or("")
}

/// In which words the answer is told.
pub fn form(question: &Value) -> Form {
    Form { language: Language::of(text(question, "language")).unwrap_or_default(), system: System::Si }
}

/// Why there is no answer.
#[derive(Default)]
pub struct Failure {
    pub what: String,
    pub help: String,
    /// Line and column from 1.
    pub at: Option<(usize, usize)>,
    /// The whole message as the command line prints it.
    pub rendered: String,
}

impl Failure {
    fn json(&self) -> Value {
        json!({
            "what": self.what,
            "help": self.help,
            "line": self.at.map(|at| at.0),
            "column": self.at.map(|at| at.1),
            "rendered": self.rendered,
        })
    }
}

impl From<CaseError> for Failure {
    fn from(error: CaseError) -> Self {
        Self {
            what: error.to_string(),
            help: error.remedy().unwrap_or_default().to_owned(),
            at: error.position(),
            rendered: error.render(false),
        }
    }
}
