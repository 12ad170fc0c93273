//! A document as a PDF file: A4, from the same pictures, each page numbered, contents with their pages, and nothing that is
//! cut: no picture, no row of a table.

mod colors;
mod flow;
mod layout;
mod table;
mod words;

use super::document::{Block, Document, Issue, KeyNumber, Picture, word};
use super::program::{MARKER, PROGRAM, page_of};
use crate::assess::Light;
use crate::message::Form;
use crate::output::{DRAWN, Drawing};
use crate::plot::chart::Color;
use crate::plot::pdf::{MM, Pdf};
use colors::{GREY_TEXT, RULE, of_light};
use flow::{Flow, WIDTH};
use layout::{BETWEEN, Layout, column};
use words::{Style, lines};

const TITLE: Style = Style::new(17.0).bold();
const HEADING: Style = Style::new(13.0).bold();
const TEXT: Style = Style::new(9.5);
const SMALL: Style = Style::new(8.0);
const NUMBER: Style = Style::new(12.5).bold();
/// An error bar below its number.
const BAR: Style = Style::new(9.5).bold();

/// The line below a heading, the ground of what stands out.
const BLUE: Color = (0, 114, 178);
const GROUND: Color = (244, 244, 244);

/// Largest height of a picture after the first page \[pt\].
const PICTURE: f64 = 115.0 * MM;
/// Room that a heading wants below it \[pt\].
const BELOW: f64 = 70.0;
/// Cells of the title block in a row.
const BLOCK: usize = 4;
/// How far lists and advice are indented \[pt\].
const INDENT: f64 = 12.0;

/// The whole file.
pub fn pdf(document: &Document) -> Vec<u8> {
    let mut writer = Writer { flow: Flow::new(), form: document.form, figures: 0 };
    writer.front(document);
    writer.flow.turn();
    let mut headings = Vec::new();
    let (page, tops) = writer.contents(document);
    for section in &document.sections {
        writer.heading(&section.heading, section.blocks.first());
        headings.push((section.heading.clone(), writer.flow.number(), writer.flow.y - 3.0 * HEADING.leading()));
        section.blocks.iter().for_each(|block| writer.block(block));
    }
    let mut flow = writer.flow;
    for (top, (_, number, _)) in tops.iter().zip(&headings) {
        flow.write_right(page, &(number + 1).to_string(), TEXT, *top);
    }
    let number = |n: usize, all: usize| document.form.tell(page_of(n.to_string(), all.to_string()));
    flow.number_pages(&format!("{} · {PROGRAM}", document.title), number, SMALL.in_color(GREY_TEXT));
    let file = Pdf {
        title: document.title.clone(),
        author: document.author.clone(),
        creator: format!("{MARKER} {}", env!("CARGO_PKG_VERSION")),
        language: document.form.language.code().to_owned(),
        pages: flow.pages,
        headings,
    };
    file.bytes()
}

struct Writer {
    flow: Flow,
    form: Form,
    /// How many pictures there were.
    figures: usize,
}

impl Writer {
    /// The first page: its pictures share what room the rest leaves.
    fn front(&mut self, document: &Document) {
        self.flow.words(&document.title, TITLE, 0.0);
        self.flow.skip(4.0);
        self.title_block(&document.title_block);
        let (pictures, others): (Vec<&Block>, Vec<&Block>) =
            document.front.iter().partition(|block| matches!(block, Block::Picture(_)));
        others.into_iter().for_each(|block| self.block(block));
        let pictures: Vec<&Picture> = pictures.into_iter().filter_map(Block::picture).collect();
        let layout = Layout::best(&pictures, self.flow.left(), SMALL.leading()).or_else(|| {
            self.flow.turn();
            Layout::best(&pictures, self.flow.left(), SMALL.leading())
        });
        let Some(layout) = layout else { return };
        for (row, drawings) in pictures.chunks(layout.beside).zip(layout.drawings.chunks(layout.beside)) {
            self.figures(row, drawings, layout.scale);
        }
    }

    fn title_block(&mut self, entries: &[[String; 2]]) {
        let columns = entries.len().clamp(1, BLOCK);
        let wide = WIDTH / columns as f64;
        for row in entries.chunks(columns) {
            let values: Vec<Vec<String>> = row.iter().map(|[_, value]| lines(value, TEXT, wide - 8.0)).collect();
            let most = values.iter().map(Vec::len).max().unwrap_or(1) as f64;
            let height = SMALL.leading() + most * TEXT.leading() + 5.0;
            let top = self.flow.y;
            for (i, ([name, _], value)) in row.iter().zip(values).enumerate() {
                let x = i as f64 * wide;
                self.flow.frame((x, top), (wide, height), GREY_TEXT);
                self.flow.write(name, SMALL.in_color(GREY_TEXT), x + 4.0, top + 2.0);
                for (j, line) in value.iter().enumerate() {
                    self.flow.write(line, TEXT, x + 4.0, top + 2.0 + SMALL.leading() + j as f64 * TEXT.leading());
                }
            }
            self.flow.skip(height);
        }
        self.flow.skip(8.0);
    }

    /// A line for each section; its page is written when it is known: the page of the list, and where each line stands.
    fn contents(&mut self, document: &Document) -> (usize, Vec<f64>) {
        self.heading(&self.form.tell("Contents"), None);
        let mut tops = Vec::new();
        for section in &document.sections {
            let line = lines(&section.heading, TEXT, 0.85 * WIDTH).swap_remove(0);
            self.flow.write(&line, TEXT, 0.0, self.flow.y);
            tops.push(self.flow.y);
            self.flow.skip(TEXT.leading());
            self.flow.rule(self.flow.y, RULE, 0.3);
        }
        self.flow.skip(6.0);
        (self.flow.number(), tops)
    }

    /// With room for something below it.
    fn heading(&mut self, text: &str, first: Option<&Block>) {
        let first = first.and_then(Block::picture).map_or(BELOW, |picture| height(&Drawing::of(&picture.chart, DRAWN)));
        self.flow.reserve(2.0 * HEADING.leading() + first);
        self.flow.skip(10.0);
        self.flow.words(text, HEADING, 0.0);
        self.flow.rule(self.flow.y + 1.0, BLUE, 1.2);
        self.flow.skip(6.0);
    }

    fn block(&mut self, block: &Block) {
        match block {
            Block::Paragraph(text) => {
                self.flow.words(text, TEXT, 0.0);
                self.flow.skip(5.0);
            }
            Block::Sentence(light, text) => self.sentence(*light, text),
            Block::Numbers(numbers) => self.numbers(numbers),
            Block::Issues(issues) => issues.iter().for_each(|issue| self.issue(issue)),
            Block::List(entries) => entries.iter().for_each(|entry| {
                let all = lines(entry, TEXT, WIDTH - INDENT).len() as f64;
                self.flow.reserve((all * TEXT.leading()).min(BELOW));
                self.flow.write("–", TEXT, 0.0, self.flow.y);
                self.flow.words(entry, TEXT, INDENT);
                self.flow.skip(2.0);
            }),
            Block::Table { head, rows } => table::draw(&mut self.flow, head, rows),
            Block::Motion(..) => {}
            Block::Picture(picture) => {
                let drawing = Drawing::of(&picture.chart, DRAWN);
                let height = height(&drawing);
                self.flow.reserve(height + 2.0 * SMALL.leading());
                self.figures(&[picture], std::slice::from_ref(&drawing), height / drawing.height);
            }
        }
    }

    /// Pictures side by side, so many times as large as they are laid out, each with its caption below.
    fn figures(&mut self, pictures: &[&Picture], drawings: &[Drawing], scale: f64) {
        let grey = SMALL.in_color(GREY_TEXT);
        let wide = column(pictures.len());
        let high = drawings.iter().map(|drawing| scale * drawing.height).fold(0.0, f64::max);
        let top = self.flow.y;
        let mut bottom = top;
        for (i, (picture, drawing)) in pictures.iter().zip(drawings).enumerate() {
            self.figures += 1;
            let x = i as f64 * (wide + BETWEEN);
            self.flow.drawing(drawing, (x + 0.5 * (wide - scale * drawing.width), top), scale);
            let caption = self.form.tell(picture.below(self.figures)) + ".";
            for (j, line) in lines(&caption, grey, wide).iter().enumerate() {
                self.flow.write(line, grey, x, top + high + j as f64 * grey.leading());
                bottom = f64::max(bottom, top + high + (j + 1) as f64 * grey.leading());
            }
        }
        self.flow.skip(bottom - top + 6.0);
    }

    /// On a ground of its own, beside a bar in its light's colour.
    fn sentence(&mut self, light: Light, text: &str) {
        let (style, x, mark) = (Style::new(11.0).bold(), 12.0, word(light, self.form));
        let all = lines(&format!("{mark} {text}"), style, WIDTH - 2.0 * x);
        let height = all.len() as f64 * style.leading() + 10.0;
        self.flow.reserve(height);
        let top = self.flow.y;
        self.flow.bar((0.0, top), (WIDTH, height), GROUND);
        self.flow.bar((0.0, top), (4.0, height), of_light(light));
        self.flow.write(&mark, style.in_color(of_light(light)), x, top + 5.0);
        for (i, line) in all.iter().enumerate() {
            let behind = if i == 0 { style.width(&mark) } else { 0.0 };
            let words = if i == 0 { line.trim_start_matches(&mark) } else { line };
            self.flow.write(words, style, x + behind, top + 5.0 + i as f64 * style.leading());
        }
        self.flow.skip(height + 7.0);
    }

    fn issue(&mut self, issue: &Issue) {
        let Issue { light, label, .. } = issue;
        let head = format!("{} {label}", word(*light, self.form));
        let style = TEXT.in_color(of_light(*light)).bold();
        let below = [issue.judged(), issue.advised()].map(|words| self.form.tell(words));
        let all: usize =
            below.iter().filter(|text| !text.is_empty()).map(|t| lines(t, TEXT, WIDTH - INDENT).len()).sum();
        self.flow.reserve((1 + all) as f64 * TEXT.leading());
        self.flow.words(&head, style, 0.0);
        below.iter().filter(|text| !text.is_empty()).for_each(|text| self.flow.words(text, TEXT, INDENT));
        self.flow.skip(4.0);
    }

    /// Boxes beside each other.
    fn numbers(&mut self, numbers: &[KeyNumber]) {
        let gap = 5.0;
        let wide = (WIDTH - gap * (numbers.len().max(1) - 1) as f64) / numbers.len().max(1) as f64;
        let grey = SMALL.in_color(GREY_TEXT);
        let boxes: Vec<_> = numbers
            .iter()
            .map(|n| {
                (lines(&n.label, grey, wide - 8.0), valued(&n.value, wide - 8.0), lines(&n.detail, SMALL, wide - 8.0))
            })
            .collect();
        let barred = boxes.iter().any(|b| b.1.1.is_some());
        let values = NUMBER.leading() + if barred { BAR.leading() } else { 0.0 };
        let labels = boxes.iter().map(|b| b.0.len()).max().unwrap_or(0) as f64 * grey.leading();
        let details = boxes.iter().map(|b| b.2.len()).max().unwrap_or(0) as f64 * SMALL.leading();
        let height = labels + values + details + 8.0;
        self.flow.reserve(height);
        let top = self.flow.y;
        for (i, (label, (value, bar), detail)) in boxes.iter().enumerate() {
            let x = i as f64 * (wide + gap);
            self.flow.frame((x, top), (wide, height), RULE);
            for (j, line) in label.iter().enumerate() {
                self.flow.write(line, grey, x + 4.0, top + 3.0 + j as f64 * grey.leading());
            }
            self.flow.write(value, NUMBER, x + 4.0, top + 3.0 + labels);
            if let Some(bar) = bar {
                self.flow.write(bar, BAR, x + 4.0, top + 3.0 + labels + NUMBER.leading());
            }
            for (j, line) in detail.iter().enumerate() {
                let down = top + 3.0 + labels + values + j as f64 * SMALL.leading();
                self.flow.write(line, SMALL, x + 4.0, down);
            }
        }
        self.flow.skip(height + 8.0);
    }
}

/// A number, and its error bar with the unit on a line of its own where both do not fit beside each other.
fn valued(value: &str, width: f64) -> (&str, Option<&str>) {
    match value.find(" ±").filter(|_| NUMBER.width(value) > width) {
        Some(at) => (&value[..at], Some(value[at..].trim_start())),
        None => (value, None),
    }
}

/// As high as it is between the margins, or as is left for a picture \[pt\].
fn height(drawing: &Drawing) -> f64 {
    (drawing.height / drawing.width * WIDTH).min(PICTURE)
}
