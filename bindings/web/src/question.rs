//! What may be asked.

use crate::json::{Numbers, Value, table};
use crate::{case, drawing, sliders, templates, trace};
use stampflow::case::CaseError;
use stampflow::message::{Form, Language, System};

/// Keys with their values, in the order in which they were given.
pub struct Question<'t>(Vec<(&'t str, &'t str)>);

impl<'t> Question<'t> {
    /// From a key and its value, another key and its value, each with a zero behind it.
    pub fn read(text: &'t str) -> Self {
        let mut parts = text.split('\0');
        Self(std::iter::from_fn(|| Some((parts.next()?, parts.next()?))).collect())
    }

    /// All values of a key.
    pub fn all(&self, key: &str) -> impl Iterator<Item = &'t str> {
        self.0.iter().filter(move |(name, _)| *name == key).map(|(_, value)| *value)
    }

    /// The value of a key; nothing where it has none.
    pub fn text(&self, key: &str) -> &'t str {
        self.all(key).next().unwrap_or("")
    }

    /// Whether a key is true.
    pub fn is(&self, key: &str) -> bool {
        self.text(key) == "true"
    }

    /// Keys of a table, `table.key`, with their values.
    pub fn table(&self, table: &str) -> impl Iterator<Item = (&'t str, &'t str)> {
        self.0.iter().filter_map(move |(key, value)| Some((key.strip_prefix(table)?.strip_prefix('.')?, *value)))
    }

    /// In which words the answer is told.
    pub fn form(&self) -> Form {
        Form { language: Language::of(self.text("language")).unwrap_or_default(), system: System::Si }
    }

    /// The answer: `do` names what is asked, and `file` are the bytes of a drawing.
    pub fn answer(&self, file: &[u8], numbers: &mut Numbers) -> Value {
        let answer = match self.text("do") {
            "templates" => Ok(templates::list()),
            "fill" => templates::fill(self),
            "sliders" => Ok(sliders::of(self.text("text"))),
            "solve" => case::solve(self, numbers),
            "drawing" => drawing::read(self, file),
            "trace" => trace::step(self, numbers),
            other => Err(Failure { what: format!("nothing is known of `{other}`"), ..Failure::default() }),
        };
        answer.unwrap_or_else(|failure| table! { "error": failure.json() })
    }
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
    fn json(self) -> Value {
        table! {
            "what": self.what,
            "help": self.help,
            "line": self.at.map(|at| at.0),
            "column": self.at.map(|at| at.1),
            "rendered": self.rendered,
        }
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
