//! The glossary of the book is the program's: what `explain` says, in both languages, and the German that it tells.
//!
//! Between `<!-- terms -->`, `<!-- Begriffe -->` or `<!-- words -->` and the next empty line stands a table. `UPDATE=1` writes the
//! tables anew; of the words the left column is given.

use std::fs;
use stampflow::message::{Language, terms};

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

fn table(head: [&str; 4], mut rows: Vec<[String; 4]>) -> String {
    rows.sort_by_key(|row| sort_key(&row[0]));
    let lines = rows.iter().map(|row| format!("| {} |\n", row.join(" | "))).collect::<String>();
    format!("| {} |\n|---|---|---|---|\n{lines}", head.join(" | "))
}

/// The page with its tables as the program has them.
fn made_anew(page: &str) -> String {
    let also = |term: &stampflow::message::Term| term.also.join(", ");
    let english = terms().iter().map(|term| {
        [term.name.clone(), german(&term.name).to_owned(), also(term), term.meaning.clone()]
    });
    let in_german = terms().iter().map(|term| {
        [german(&term.name).to_owned(), term.name.clone(), also(term), german(&term.meaning).to_owned()]
    });
    let blocks: Vec<String> = page
        .split("\n\n")
        .map(|block| match block.split_once('\n') {
            Some(("<!-- terms -->", _)) => {
                let head = ["English", "German", "also called", "what it is"];
                format!("<!-- terms -->\n{}", table(head, english.clone().collect()).trim_end())
            }
            Some(("<!-- Begriffe -->", _)) => {
                let head = ["Deutsch", "Englisch", "auch", "was es ist"];
                format!("<!-- Begriffe -->\n{}", table(head, in_german.clone().collect()).trim_end())
            }
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
