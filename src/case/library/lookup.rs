//! The sheet that a word means: its name, a grade that it stands for, or the beginning of either.

use super::entries::{EntryFile, TEXTS, read};
use crate::case::CaseError;
use crate::units::did_you_mean;

/// A sheet of the library that was found.
pub(super) struct Found {
    /// Its name.
    pub name: &'static str,
    /// Its file, as text and as read.
    pub text: &'static str,
    pub file: EntryFile,
    /// Reason of the choice, if the word is not its name.
    pub note: Option<String>,
}

/// Error of a word that names no sheet, with a remedy.
pub(super) struct Unknown {
    pub what: String,
    pub help: String,
}

impl From<Unknown> for CaseError {
    fn from(Unknown { what, help }: Unknown) -> Self {
        Self::bare(what, help)
    }
}

/// A word without what is written in many ways: `EN AW-6016` is `enaw6016`.
fn plain(word: &str) -> String {
    word.chars().filter(|c| c.is_alphanumeric() || *c == '.').flat_map(char::to_lowercase).collect()
}

/// The sheet of a name; else the one that stands for a grade; else the only one whose name or grade begins so.
pub(super) fn find(word: &str) -> Result<Found, Unknown> {
    let broken = |error: CaseError| Unknown { what: error.to_string(), help: String::new() };
    if let Some((name, text)) = TEXTS.iter().find(|(name, _)| *name == word) {
        return Ok(Found { name, text, file: read(name, text).map_err(broken)?, note: None });
    }
    let wanted = plain(word);
    let (mut exact, mut begins) = (Vec::new(), Vec::new());
    for (name, text) in TEXTS {
        let file = read(name, text).map_err(broken)?;
        let grades = file.stands_for.iter().flat_map(|stands| &stands.grades);
        let known: Vec<String> = grades.map(|grade| plain(grade)).chain([plain(name)]).collect();
        let is_name = plain(name) == wanted;
        let note = match (&file.stands_for, is_name || plain(name).starts_with(&wanted)) {
            (Some(_), false) => {
                format!("material {word}: {name} stands for it, as `stampflow materials {name}` explains")
            }
            _ => format!("material {word} read as {name}"),
        };
        let found = Found { name, text, file, note: Some(note) };
        if known.contains(&wanted) {
            exact.push(found);
        } else if !wanted.is_empty() && known.iter().any(|known| known.starts_with(&wanted)) {
            begins.push(found);
        }
    }
    let mut candidates = if exact.is_empty() { begins } else { exact };
    match (candidates.pop(), candidates.is_empty()) {
        (Some(only), true) => Ok(only),
        (Some(last), false) => {
            let names: Vec<&str> = candidates.iter().chain([&last]).map(|found| found.name).collect();
            let what = format!("\"{word}\" may be {}", names.join(" or "));
            Err(Unknown { what, help: "write the whole name".into() })
        }
        (None, _) => Err(unknown(word)),
    }
}

fn unknown(word: &str) -> Unknown {
    let names = TEXTS.map(|(name, _)| name);
    let near = did_you_mean(word, names.iter().copied());
    let help =
        format!("{near}known materials: {}; `stampflow materials` says which grades they stand for", names.join(", "));
    Unknown { what: format!("the library has no material \"{word}\""), help }
}
