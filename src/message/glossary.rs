//! Words that a reader may not know, each explained once.

use super::language::{LANGUAGES, Language};
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
    /// The term of a word in any language, whatever its case and its hyphens.
    pub fn of(word: &str) -> Option<&'static Self> {
        let is_it = |name: &str| plain(name) == plain(word);
        let of_words = || terms().iter().find(|term| term.words().any(is_it));
        of_words().or_else(|| terms().iter().find(|term| term.translated().any(is_it)))
    }

    /// The terms of which it is a part: of `yield` the yield condition.
    pub fn with(word: &str) -> impl Iterator<Item = &'static Self> {
        let part = plain(word);
        let has = move |name: &str| !part.is_empty() && plain(name).contains(&part);
        terms().iter().filter(move |term| term.words().chain(term.translated()).any(&has))
    }

    /// The term that explains a row of the verdict, by the row's key.
    pub fn of_row(key: &str) -> Option<&'static Self> {
        terms().iter().find(|term| term.rows.iter().any(|row| row == key))
    }

    /// Its name in other languages.
    pub fn translated(&self) -> impl Iterator<Item = &str> {
        LANGUAGES.iter().filter_map(|(code, _, _)| Language::of(code)).map(|language| language.of_text(&self.name))
    }

    /// All English words that it is found by.
    pub fn words(&self) -> impl Iterator<Item = &str> {
        std::iter::once(&self.name).chain(&self.also).map(String::as_str)
    }
}

/// Without case, hyphens and spaces.
fn plain(word: &str) -> String {
    word.to_lowercase().replace(['-', ' ', '_'], "")
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

    #[test]
    fn a_word_is_found_by_its_name_in_another_language_and_by_its_parts() {
        assert_eq!(Term::of("Niederhalter").map(|term| term.name.as_str()), Some("holder"));
        let with = |word| Term::with(word).map(|term| term.name.as_str()).collect::<Vec<_>>();
        assert!(with("Siebel").contains(&"Siebel's pressure") && with("").is_empty());
    }
}
