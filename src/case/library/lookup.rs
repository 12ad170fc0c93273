//! The sheet that a word means: its name, a grade that it stands for, or the beginning of either.

use super::entries::{EntryFile, TEXTS, read};
use crate::units::did_you_mean;

/// Sheet of the library that a word names.
pub(super) struct Sheet {
    pub name: &'static str,
    /// Its file, as text and as read.
    pub text: &'static str,
    pub file: EntryFile,
    /// Reason of the choice, if the word is not its name.
    pub note: Option<String>,
}

/// A word without what is written in many ways: `EN AW-6016` is `enaw6016`.
fn plain(word: &str) -> String {
    word.chars().filter(|c| c.is_alphanumeric() || *c == '.').flat_map(char::to_lowercase).collect()
}

/// The sheet of a name; else the one that stands for a grade; else the only one whose name or grade begins so.
/// The error is a message and a remedy.
pub(super) fn find(word: &str) -> Result<Sheet, [String; 2]> {
    let wanted = plain(word);
    let (mut exact, mut begins) = (Vec::new(), Vec::new());
    let texts = TEXTS.iter().position(|(name, _)| *name == word).map_or(&TEXTS[..], |i| &TEXTS[i..=i]);
    for &(name, text) in texts {
        let file = read(name, text).map_err(|error| [error.to_string(), String::new()])?;
        if name == word {
            return Ok(Sheet { name, text, file, note: None });
        }
        let grades = file.stands_for.iter().flat_map(|stands| &stands.grades);
        let known: Vec<String> = grades.map(|grade| plain(grade)).chain([plain(name)]).collect();
        let note = match plain(name).starts_with(&wanted) || file.stands_for.is_none() {
            false => format!("material {word}: {name} stands for it, as `stampflow materials {name}` explains"),
            true => format!("material {word} read as {name}"),
        };
        let (is_exact, is_begin) = (known.contains(&wanted), known.iter().any(|known| known.starts_with(&wanted)));
        let sheet = Sheet { name, text, file, note: Some(note) };
        match is_exact {
            true => exact.push(sheet),
            false if is_begin && !wanted.is_empty() => begins.push(sheet),
            false => {}
        }
    }
    let mut candidates = if exact.is_empty() { begins } else { exact };
    let names: Vec<&str> = candidates.iter().map(|sheet| sheet.name).collect();
    match names[..] {
        [_] => Ok(candidates.remove(0)),
        [] => {
            let names = TEXTS.map(|(name, _)| name);
            let near = did_you_mean(word, names.iter().copied());
            let names = names.join(", ");
            let help =
                format!("{near}known materials: {names}; `stampflow materials` says which grades they stand for");
            Err([format!("the library has no material \"{word}\""), help])
        }
        _ => Err([format!("\"{word}\" may be {}", names.join(" or ")), "write the whole name".into()]),
    }
}
