//! A document as Markdown with its pictures as SVG files in a folder beside it.

use super::document::{Block, Document, KeyNumber, Row, word};
use super::program::{MARKER, written};
use crate::message::Form;
use crate::output::svg;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// The folder of the pictures of a Markdown file.
pub fn figure_folder(file: &Path) -> PathBuf {
    let stem = file.file_stem().map_or_else(|| "report".into(), |stem| stem.to_string_lossy());
    file.with_file_name(format!("{stem}_figures"))
}

/// Whether a picture in that folder has a name that [`markdown`] gives: `03-thickness.svg`.
pub fn is_figure(name: &str) -> bool {
    let number = name.split_once('-').filter(|_| name.ends_with(".svg"));
    number.is_some_and(|(number, _)| number.len() == 2 && number.bytes().all(|b| b.is_ascii_digit()))
}

/// The text, and the pictures as SVG by the names that it calls them in `folder`.
pub fn markdown(document: &Document, folder: &str) -> (String, Vec<(String, String)>) {
    let mut text = format!("<!-- {MARKER} {} -->\n\n# {}\n\n", env!("CARGO_PKG_VERSION"), escaped(&document.title));
    for [name, value] in &document.title_block {
        let _ = writeln!(text, "- {}: {}", escaped(name), escaped(value));
    }
    let mut pictures = Vec::new();
    document.front.iter().for_each(|part| block(&mut text, part, folder, &mut pictures, document.form));
    for section in &document.sections {
        let _ = writeln!(text, "\n## {}", escaped(&section.heading));
        section.blocks.iter().for_each(|part| block(&mut text, part, folder, &mut pictures, document.form));
    }
    let _ = writeln!(text, "\n{}", document.form.tell(written()));
    (text, pictures)
}

fn block(text: &mut String, block: &Block, folder: &str, pictures: &mut Vec<(String, String)>, form: Form) {
    text.push('\n');
    match block {
        Block::Paragraph(words) => _ = writeln!(text, "{}", escaped(words)),
        Block::Sentence(light, words) => _ = writeln!(text, "**{} {}**", word(*light, form), escaped(words)),
        Block::Numbers(numbers) => {
            let row = |n: &KeyNumber| Row::plain([n.label.clone(), n.value.clone(), n.detail.clone()]);
            let rows: Vec<Row> = numbers.iter().map(row).collect();
            table(text, &["Number", "Value", "Where"].map(|name| form.tell(name)), &rows);
        }
        Block::Issues(issues) => issues.iter().for_each(|issue| {
            let [judged, advice] = [issue.judged(), issue.advised()].map(|words| escaped(&form.tell(words)));
            let _ = writeln!(text, "- {} **{}**: {judged}", word(issue.light, form), escaped(&issue.label));
            if !advice.is_empty() {
                let _ = writeln!(text, "  - {advice}");
            }
        }),
        Block::List(entries) => entries.iter().for_each(|entry| _ = writeln!(text, "- {}", escaped(entry))),
        Block::Table { head, rows } => table(text, head, rows),
        Block::Motion(..) => {}
        Block::Picture(picture) => {
            let name = format!("{:02}-{}.svg", pictures.len() + 1, picture.name);
            let target = format!("{folder}/{name}").replace(' ', "%20");
            let _ = writeln!(text, "![{}]({target})", escaped(&form.tell(picture.below(pictures.len() + 1))));
            pictures.push((name, svg(&picture.chart)));
        }
    }
}

fn table(text: &mut String, head: &[String], rows: &[Row]) {
    let _ = writeln!(text, "| {} |\n|{}", head.join(" | "), "---|".repeat(head.len()));
    for row in rows {
        let indent = if row.belongs { "\u{2003}" } else { "" };
        let cells: Vec<String> = row
            .cells
            .iter()
            .enumerate()
            .map(|(i, cell)| if i == 0 { indent } else { "" }.to_owned() + &escaped(cell))
            .collect();
        let _ = writeln!(text, "| {} |", cells.join(" | "));
    }
}

/// Text that Markdown shows as it is, on one line.
fn escaped(text: &str) -> String {
    let mut safe = String::new();
    for letter in text.chars() {
        match letter {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '|' | '#' => safe.extend(['\\', letter]),
            '\n' | '\r' => safe.push(' '),
            other => safe.push(other),
        }
    }
    safe
}
