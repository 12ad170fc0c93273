//! The glossary of the book is the program's: what `explain` says, in both languages, and the German that it tells.
//!
//! Between `<!-- terms -->`, `<!-- Begriffe -->` or `<!-- words -->` and the next empty line stands a table. `UPDATE=1` writes the
//! tables anew; of the words the left column is given.

use stampflow::message::{Language, Term, terms};
use std::fs;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/glossary.md");

/// The program's German for an English text that it has.
fn german(text: &str) -> &str {
    let german = Language::of("de").expect("spoken");
    assert!(german.texts().any(|(known, _)| known == text), "src/message/de.toml has no {text:?}");
    german.of_text(text)
}

/// As a dictionary sorts it.
fn sort_key(word: &str) -> String {
    word.to_lowercase().replace('ä', "a").replace('ö', "o").replace('ü', "u").replace('ß', "ss")
}

fn table(head: [&str; 3], mut rows: Vec<[String; 3]>) -> String {
    rows.sort_by_key(|row| sort_key(&row[0]));
    let lines: Vec<String> = rows.iter().map(|row| format!("| {} |", row.join(" | "))).collect();
    format!("| {} |\n|---|---|---|\n{}", head.join(" | "), lines.join("\n"))
}

/// What a term means, and the other words for it.
fn meaning(text: &str, also: &str, words: &[String]) -> String {
    if words.is_empty() { text.to_owned() } else { format!("{text} *{also}: {}.*", words.join(", ")) }
}

/// The page with its tables as the program has them.
fn made_anew(page: &str) -> String {
    let english = || {
        let row =
            |term: &Term| [term.name.clone(), german(&term.name).into(), meaning(&term.meaning, "Also", &term.also)];
        table(["English", "German", "what it is"], terms().iter().map(row).collect())
    };
    let in_german = || {
        let row = |term: &Term| {
            [german(&term.name).into(), term.name.clone(), meaning(german(&term.meaning), "Auch", &term.also)]
        };
        table(["Deutsch", "Englisch", "was es ist"], terms().iter().map(row).collect())
    };
    let blocks: Vec<String> = page
        .split("\n\n")
        .map(|block| match block.split_once('\n') {
            Some((mark @ "<!-- terms -->", _)) => format!("{mark}\n{}", english()),
            Some((mark @ "<!-- Begriffe -->", _)) => format!("{mark}\n{}", in_german()),
            Some(("<!-- words -->", rows)) => {
                let mut lines: Vec<String> = rows.lines().take(2).map(str::to_owned).collect();
                for row in rows.lines().skip(2) {
                    let word = row.split('|').nth(1).expect("a cell").trim();
                    lines.push(format!("| {word} | {} |", german(word)));
                }
                format!("<!-- words -->\n{}", lines.join("\n"))
            }
            _ => block.to_owned(),
        })
        .collect();
    blocks.join("\n\n")
}

/// Trust: the glossary that `stampflow explain` tells from, and the table of its German.
#[test]
fn the_glossary_of_the_book_is_the_programs_own() {
    let page = fs::read_to_string(PAGE).expect("shipped");
    let anew = made_anew(&page);
    if std::env::var_os("UPDATE").is_some() {
        fs::write(PAGE, &anew).expect("writable");
    }
    for term in terms() {
        assert!(anew.contains(&format!("| {} | {} |", term.name, german(&term.name))), "{} is not in it", term.name);
    }
    let differs = page.lines().zip(anew.lines()).find(|(shown, made)| shown != made);
    assert!(page == anew, "run with UPDATE=1 where that is meant: {differs:#?}");
}
