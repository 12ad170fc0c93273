//! A document as one HTML file: pictures and style inside, nothing fetched from elsewhere.

use super::document::{Block, Document, Picture, Row};
use super::program::{MARKER, PROGRAM};
use crate::assess::Light;
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
                title { (document.title) }
                style { (PreEscaped(STYLE)) }
            }
            body {
                main {
                    h1 { (document.title) }
                    @for section in &document.sections {
                        section {
                            h2 { (section.heading) }
                            @for part in &section.blocks { (block(part, &mut number)) }
                        }
                    }
                }
                footer { "Written by " (PROGRAM) "." }
            }
        }
    };
    page.into_string()
}

fn block(block: &Block, number: &mut usize) -> Markup {
    match block {
        Block::Paragraph(text) => markup! { p { (text) } },
        Block::List(entries) => markup! { ul { @for entry in entries { li { (entry) } } } },
        Block::Table { head, rows } => table(head, rows),
        Block::Picture(Picture { caption, svg, .. }) => {
            *number += 1;
            markup! {
                figure {
                    div.picture role="img" aria-label=(caption) { (PreEscaped(inline(svg))) }
                    figcaption { "Figure " (number) ": " (caption) "." }
                }
            }
        }
    }
}

/// Rows with lights are stacked on a phone, each cell under its column's name.
fn table(head: &[&str], rows: &[Row]) -> Markup {
    let findings = rows.iter().any(|row| row.light.is_some());
    markup! {
        div.table {
            table.{ "columns-" (head.len()) }.findings[findings] {
                thead { tr { @for cell in head { th scope="col" { (cell) } } } }
                tbody {
                    @for row in rows {
                        tr {
                            @for (i, (cell, name)) in row.cells.iter().zip(head).enumerate() {
                                td class=[row.light.filter(|_| i == 0).map(Light::name)] data-column=[findings.then_some(name)] {
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
