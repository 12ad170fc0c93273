//! A document as Markdown with its pictures as SVG files in a folder beside it.

use super::document::{Block, Document, Row};
use super::program::{MARKER, PROGRAM};
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

/// The text, and the pictures by the names that it calls them in `folder`.
pub fn markdown(document: &Document, folder: &str) -> (String, Vec<(String, String)>) {
    let mut text = format!("<!-- {MARKER} {} -->\n\n# {}\n", env!("CARGO_PKG_VERSION"), escaped(&document.title));
    let mut pictures = Vec::new();
    for section in &document.sections {
        let _ = writeln!(text, "\n## {}", escaped(&section.heading));
        for block in &section.blocks {
            text.push('\n');
            match block {
                Block::Paragraph(words) => _ = writeln!(text, "{}", escaped(words)),
                Block::List(entries) => entries.iter().for_each(|entry| _ = writeln!(text, "- {}", escaped(entry))),
                Block::Table { head, rows } => table(&mut text, head, rows),
                Block::Picture(picture) => {
                    let name = format!("{:02}-{}.svg", pictures.len() + 1, picture.name);
                    let target = format!("{folder}/{name}").replace(' ', "%20");
                    let _ = writeln!(text, "![Figure {}: {}]({target})", pictures.len() + 1, escaped(&picture.caption));
                    pictures.push((name, picture.svg.clone()));
                }
            }
        }
    }
    let _ = writeln!(text, "\nWritten by {PROGRAM}.");
    (text, pictures)
}

fn table(text: &mut String, head: &[&str], rows: &[Row]) {
    let _ = writeln!(text, "| {} |\n|{}", head.join(" | "), "---|".repeat(head.len()));
    for row in rows {
        let cells: Vec<String> = row.cells.iter().map(|cell| escaped(cell)).collect();
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
