//! Words that a reader may not know, each explained once.

use std::sync::OnceLock;

/// A word and what it means, in English: [`Message`](super::Message) tells both in other languages.
#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Term {
    /// The word.
    pub name: String,
    /// What it is also called.
    #[serde(default)]
    pub also: Vec<String>,
    /// Keys of the verdict's rows that it explains.
    #[serde(default)]
    pub rows: Vec<String>,
    /// In a few sentences.
    pub meaning: String,
}

#[derive(serde::Deserialize)]
struct Glossary {
    term: Vec<Term>,
}

/// All words, in the order of their file.
pub fn terms() -> &'static [Term] {
    static TERMS: OnceLock<Vec<Term>> = OnceLock::new();
    TERMS.get_or_init(|| {
        toml::from_str::<Glossary>(include_str!("glossary.toml")).map_or_else(|_| Vec::new(), |glossary| glossary.term)
    })
}

impl Term {
    /// The term of a word, whatever its case and its hyphens.
    pub fn of(word: &str) -> Option<&'static Self> {
        let plain = |word: &str| word.to_lowercase().replace(['-', ' ', '_'], "");
        let is_it = |name: &String| plain(name) == plain(word);
        terms().iter().find(|term| is_it(&term.name) || term.also.iter().any(is_it))
    }

    /// The term that explains a row of the verdict, by the row's key.
    pub fn of_row(key: &str) -> Option<&'static Self> {
        terms().iter().find(|term| term.rows.iter().any(|row| row == key))
    }

    /// All words that it is found by.
    pub fn words(&self) -> impl Iterator<Item = &str> {
        std::iter::once(&self.name).chain(&self.also).map(String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_found_and_means_one_thing() {
        assert!(terms().len() > 30, "the file is read");
        for term in terms() {
            assert!(term.meaning.ends_with('.'), "{}", term.name);
            for word in term.words() {
                assert_eq!(Term::of(&word.to_uppercase()).map(|found| &found.name), Some(&term.name), "{word}");
            }
        }
    }
}
