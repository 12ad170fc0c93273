//! HTML of the report: pictures and style inside, nothing fetched from elsewhere; a browser prints it on A4 pages.

use super::*;
use crate::case::Case;
use crate::model::Geometry;
use crate::plot::{chart::Scale, svg, svg_on_paper};
use crate::results::REPORT_MARKER;
use maud::{DOCTYPE, PreEscaped};

const STYLE: &str = include_str!("style.css");
/// Longest cell that has room beside others on a phone \[letters\].
const SHORT: usize = 24;
const KEYS: [&str; 7] = ["press", "friction", "material", "forming_limit", "springback", "stop", "finished"];
/// Half the width between the margins of A4 \[mm\].
const COLUMN: f64 = 88.0;
/// Largest height of curves in it \[px of a picture 800 wide\].
const CURVES: f64 = 330.0;

/// Heading and content.
pub(super) type Section = (String, Markup);

#[derive(Default)]
pub(super) struct Row {
    pub cells: Vec<String>,
    /// Colour of the first cell, whose word says the same.
    pub light: Option<Light>,
    /// True if it belongs to the row above and is indented.
    pub belongs: bool,
}

impl<const N: usize> From<[String; N]> for Row {
    fn from(cells: [String; N]) -> Self {
        Self { cells: cells.into(), ..Self::default() }
    }
}

impl Report<'_> {
    /// The whole page.
    pub fn html(&self) -> String {
        let title = &self.solution.case.model().title;
        let case = &self.solution.case;
        let thickness = Amount::size(case.model().blank.thickness);
        let sheet = joined([case.sources.sheet.clone().unwrap_or_default(), format!("{thickness} thick")], ", ");
        let finished = joined([case.finished.to_string(), drawn_section(case)], ", ");
        let own = [("Sheet", sheet.as_str()), ("Finished part", &finished), ("Case", &case.name)];
        let block = self.title_block.entries().chain(own).filter(|(_, value)| !value.is_empty());
        let mut folded = vec![sections::verdict(self)];
        folded.extend(sections::error_bars(self));
        folded.extend(part::sections(self));
        folded.extend(results::sections(self));
        folded.push(sections::solver(self));
        let page = html! {
            (DOCTYPE)
            html lang="en" {
                head {
                    meta charset="utf-8";
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    meta name="generator" content={ (REPORT_MARKER) " " (env!("CARGO_PKG_VERSION")) };
                    @if let Some(author) = &self.title_block.author { meta name="author" content=(author); }
                    title { (title) }
                    style { (PreEscaped(STYLE)) }
                }
                body {
                    main {
                        header {
                            h1 { (title) }
                            dl.title-block { @for (name, value) in block { div { dt { (name) } dd { (value) } } } }
                        }
                        section.page.front { (front::content(self)) }
                        section.page { h2 { "Part and stages" } (part::content(self)) }
                        section.page { h2 { "Inputs and sources" } (sections::inputs(self)) }
                        @for (heading, content) in self.versus.map(sections::versus).iter() {
                            section { h2 { (heading) } (content) }
                        }
                        @for (heading, content) in &folded { details { summary { h2 { (heading) } } (content) } }
                    }
                    footer { "Written by " (PROGRAM) "." }
                }
            }
        };
        page.into_string()
    }
}

/// Sizes of a section that a holder lets the punch draw: `60 mm wide inside, 40 mm deep inside, 1000 mm long`.
fn drawn_section(case: &Case) -> String {
    let model = case.model();
    let is_drawn = model.geometry == Geometry::PlaneStrain && model.tool(Role::Holder).is_some();
    let Some(punch) = model.tool(Role::Punch).filter(|_| is_drawn) else { return String::new() };
    let depth = Some(model.travel).filter(|_| !model.stop.drawn_through);
    let sizes = [(Some(2.0 * extent(punch).1), "wide inside"), (depth, "deep inside"), (model.depth, "long")];
    joined(sizes.into_iter().filter_map(|(size, of)| Some(format!("{} {of}", Amount::size(size?)))), ", ")
}

pub(super) fn figure(chart: &Chart, caption: &str) -> Markup {
    drawn(&svg(chart), caption)
}

pub(super) fn figure_in_column(mut chart: Chart, caption: &str) -> Markup {
    for panel in &mut chart.panels {
        if let Scale::Fit { height, .. } = &mut panel.scale {
            *height = height.min(CURVES);
        }
    }
    drawn(&svg_on_paper(&chart, COLUMN), caption)
}

fn drawn(svg: &str, caption: &str) -> Markup {
    // Inside HTML an SVG needs no namespace.
    let picture = svg.replacen(" xmlns=\"http://www.w3.org/2000/svg\"", "", 1);
    html! { figure {
        div.picture role="img" aria-label=(caption) { (PreEscaped(picture)) }
        figcaption { (caption) "." }
    } }
}

/// Text for readers who have neither the case file nor the program: without its marks, and without commands.
pub(super) fn in_words(text: &str) -> String {
    let mut words = String::new();
    for (i, part) in text.split('`').enumerate() {
        if i % 2 == 1 && part.starts_with("stampflow ") {
            words.truncate(words.trim_end_matches([':', ' ']).len());
        } else {
            words += part;
        }
    }
    KEYS.iter().fold(words.replace(" ()", ""), |words, key| words.replace(&format!("[{key}]"), key))
}

/// Table; on a phone the cells of wide ones stand below each other under their columns' names.
pub(super) fn table<R: Into<Row>>(head: &[&str], rows: impl IntoIterator<Item = R>) -> Markup {
    let rows: Vec<Row> = rows.into_iter().map(Into::into).collect();
    let is_long = |row: &Row| row.cells.iter().skip(1).any(|cell| cell.chars().count() > SHORT);
    let is_wide = head.len() > 3 || rows.iter().any(is_long);
    html! {
        div.table { table.{ "columns-" (head.len()) }.wide[is_wide] {
            thead { tr { @for cell in head { th scope="col" { (cell) } } } }
            tbody { @for row in &rows { tr.belongs[row.belongs] {
                @for (i, (cell, name)) in row.cells.iter().zip(head).enumerate() {
                    td class=[row.light.filter(|_| i == 0).map(Light::name)] data-column=[is_wide.then_some(name)] {
                        (in_words(cell))
                    }
                }
            } } }
        } }
    }
}

pub(super) fn list(entries: &[String], none: &str) -> Markup {
    html! {
        @if entries.is_empty() { p { (none) } } @else { ul { @for entry in entries { li { (in_words(entry)) } } } }
    }
}

/// Sign and word of a light: the colour only repeats them.
pub(super) fn word(light: Light) -> String {
    let sign = ['○', '●', '▲', '■'][light as usize];
    format!("{sign} {}", light.name())
}
