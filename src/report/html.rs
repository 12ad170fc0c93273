//! A document as one HTML file: pictures and style inside, nothing fetched from elsewhere.

use super::document::{Block, Document, Issue, KeyNumber, Row, word};
use super::program::{MARKER, page_of, written};
use crate::assess::Light;
use crate::results::svg;
use maud::{DOCTYPE, Markup, PreEscaped, html as markup};

const STYLE: &str = include_str!("style.css");

/// The whole file.
pub fn html(document: &Document) -> String {
    let mut number = 0;
    let page = markup! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="generator" content={ (MARKER) " " (env!("CARGO_PKG_VERSION")) };
                @if !document.author.is_empty() { meta name="author" content=(document.author); }
                title { (document.title) }
                style { (PreEscaped(style())) }
            }
            body {
                main {
                    header {
                        h1 { (document.title) }
                        dl.title-block {
                            @for [name, value] in &document.title_block { div { dt { (name) } dd { (value) } } }
                        }
                    }
                    section.front { @for part in &document.front { (block(part, &mut number)) } }
                    nav {
                        h2 { (String::from("Contents")) }
                        ol {
                            @for (i, section) in document.sections.iter().enumerate() {
                                li { a href={ "#s" (i + 1) } { (section.heading) } }
                            }
                        }
                    }
                    @for (i, section) in document.sections.iter().enumerate() {
                        section id={ "s" (i + 1) } {
                            h2 { (section.heading) }
                            @for part in &section.blocks { (block(part, &mut number)) }
                        }
                    }
                }
                footer { (String::from(written())) }
            }
        }
    };
    page.into_string()
}

/// The style, with the words that stand beside page numbers.
fn style() -> String {
    let [n, all] = ["page", "pages"].map(|counter| format!("\" counter({counter}) \""));
    STYLE.replace("PAGE", &String::from(page_of(n, all)))
}

fn block(block: &Block, number: &mut usize) -> Markup {
    match block {
        Block::Paragraph(text) => markup! { p { (text) } },
        Block::Sentence(light, text) => markup! {
            p.sentence.{ "on-" (light.name()) } { span.{ (light.name()) } { (word(*light)) } " " (text) }
        },
        Block::Numbers(numbers) => markup! { dl.numbers { @for number in numbers { (key_number(number)) } } },
        Block::Issues(issues) => markup! { ul.issues { @for issue in issues { (of_issue(issue)) } } },
        Block::List(entries) => markup! { ul { @for entry in entries { li { (entry) } } } },
        Block::Table { head, rows } => table(head, rows),
        Block::Picture(picture) => {
            *number += 1;
            markup! {
                figure {
                    div.picture role="img" aria-label=(picture.caption) { (PreEscaped(inline(&svg(&picture.chart)))) }
                    figcaption { (String::from(picture.below(*number))) "." }
                }
            }
        }
    }
}

fn key_number(KeyNumber { label, value, detail }: &KeyNumber) -> Markup {
    markup! { div { dt { (label) } dd { strong { (value) } @if !detail.is_empty() { span { (detail) } } } } }
}

fn of_issue(issue: &Issue) -> Markup {
    let (Issue { light, label, .. }, advice) = (issue, String::from(issue.advised()));
    markup! {
        li {
            p { span.{ (light.name()) } { (word(*light)) } " " strong { (label) } ": " (String::from(issue.judged())) }
            @if !advice.is_empty() { p.advice { (advice) } }
        }
    }
}

/// A table with longer cells than that has no room beside each other on a phone \[letters\].
const SHORT: usize = 24;

/// On a phone the cells of tables with many columns, or with sentences in them, stand below each other under their columns'
/// names; of others value and unit stay beside each other.
fn table(head: &[String], rows: &[Row]) -> Markup {
    let is_long = |row: &Row| row.cells.iter().skip(1).any(|cell| cell.chars().count() > SHORT);
    let is_wide = head.len() > 3 || rows.iter().any(is_long);
    markup! {
        div.table {
            table.{ "columns-" (head.len()) }.wide[is_wide] {
                thead { tr { @for cell in head { th scope="col" { (cell) } } } }
                tbody {
                    @for row in rows {
                        tr.belongs[row.belongs] {
                            @for (i, (cell, name)) in row.cells.iter().zip(head).enumerate() {
                                td class=[row.light.filter(|_| i == 0).map(Light::name)] data-column=[is_wide.then_some(name)] {
                                    (cell)
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}

/// An SVG inside HTML needs no namespace, and is as wide as its place.
fn inline(svg: &str) -> String {
    svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1)
}
