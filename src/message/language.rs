//! Languages, each a table from the English text to its own.

use std::collections::HashMap;
use std::sync::OnceLock;

/// A language that the program speaks: English, or one of [`LANGUAGES`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Language(Option<usize>);

/// The languages besides English: code, name, and the table that is read when it is first asked for. A new one is its
/// table and a line here.
pub const LANGUAGES: &[(&str, &str, &str)] = &[("de", "Deutsch", include_str!("de.toml"))];

/// A table as its file has it.
#[derive(serde::Deserialize, Default)]
struct Words {
    /// Sign between whole and decimal digits.
    decimal: String,
    /// From the English text to the language's.
    text: HashMap<String, String>,
}

impl Language {
    /// The language of a code: `en`, `de`.
    pub fn of(code: &str) -> Option<Self> {
        if code == "en" {
            return Some(Self(None));
        }
        LANGUAGES.iter().position(|(known, _, _)| *known == code).map(|i| Self(Some(i)))
    }

    /// Its code.
    pub fn code(self) -> &'static str {
        self.0.map_or("en", |i| LANGUAGES[i].0)
    }

    /// Every English text of its table with its own; none for English.
    pub fn texts(self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.words().into_iter().flat_map(|words| &words.text).map(|(text, own)| (text.as_str(), own.as_str()))
    }

    /// The text in this language; English where its table lacks it.
    pub fn of_text(self, text: &str) -> &str {
        self.words().and_then(|words| words.text.get(text)).map_or(text, String::as_str)
    }

    /// Whether it has words for an English text that has any.
    pub(super) fn knows(self, text: &str) -> bool {
        let wordless =
            super::names(text).count() > 0 && !super::filled(text, |_| String::new()).contains(char::is_alphabetic);
        wordless || self.words().is_none_or(|words| words.text.contains_key(text))
    }

    /// A decimal number with the language's sign.
    pub fn number(self, number: &str) -> String {
        self.words().map_or_else(|| number.to_owned(), |words| number.replace('.', &words.decimal))
    }

    fn words(self) -> Option<&'static Words> {
        static WORDS: [OnceLock<Words>; LANGUAGES.len()] = [const { OnceLock::new() }; LANGUAGES.len()];
        self.0.map(|i| WORDS[i].get_or_init(|| read(LANGUAGES[i].2)))
    }
}

/// A shipped table, which a test reads.
fn read(table: &str) -> Words {
    toml::from_str(table).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::names;

    /// A table that cannot be read would be an empty one.
    #[test]
    fn every_table_is_read_and_has_the_names_of_the_english_texts() {
        for (code, _, table) in LANGUAGES {
            toml::from_str::<Words>(table).expect("a table");
            for (text, own) in Language::of(code).expect("listed").texts() {
                let sorted = |text| {
                    let mut found: Vec<&str> = names(text).collect();
                    found.sort_unstable();
                    found
                };
                assert_eq!(sorted(text), sorted(own), "{code}: {text}");
            }
        }
    }
}
