//! Printed texts and tables: as wide as the terminal, 80 columns elsewhere; coloured on terminals only.

use super::*;
use comfy_table::{Attribute, Color, ColumnConstraint, ContentArrangement, Table, presets};
use serde::Serialize;
pub use stampflow::study::Cell;
use std::{io, io::Write, ops::Add};

/// Columns without a terminal, and of a wide one: longer lines are hard to read.
const WIDTH: usize = 80;
const WIDEST: usize = 120;

/// Text for a screen; control characters of titles, names and values are written as codes, but for colours of its own.
#[derive(Default)]
pub struct ScreenText(pub String);

impl<T: AsRef<str>> From<T> for ScreenText {
    fn from(text: T) -> Self {
        Self(visible(text.as_ref()).into_owned())
    }
}

impl<T: Into<ScreenText>> Add<T> for ScreenText {
    type Output = Self;

    fn add(self, more: T) -> Self {
        Self(self.0 + &more.into().0)
    }
}

/// Prints whole lines; a reader that has gone away (`| head`) is no error.
pub fn print(text: impl Into<ScreenText>) -> Result<Code> {
    match print_lines(&mut io::stdout().lock(), &text.into()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(Code::Done),
    }
}

pub fn print_json(value: &impl Serialize) -> Result<Code> {
    print(serde_json::to_string_pretty(value)?)
}

pub fn emit(is_json: bool, value: Value, text: impl FnOnce() -> ScreenText) -> Result<Code> {
    if is_json { print_json(&value) } else { print(text()) }
}

pub fn with(mut value: Value, more: Value) -> Value {
    if let (Value::Object(own), Value::Object(more)) = (&mut value, more) {
        own.extend(more);
    }
    value
}

pub fn warn(text: impl Into<ScreenText>) {
    let _ = print_lines(&mut io::stderr().lock(), &text.into());
}

fn print_lines(stream: &mut impl Write, ScreenText(text): &ScreenText) -> io::Result<()> {
    write!(stream, "{text}{}", if text.is_empty() || text.ends_with('\n') { "" } else { "\n" })
}

const COLORS: [Option<u8>; 4] = [None, Some(2), Some(3), Some(1)];

fn color(light: Light) -> Option<u8> {
    COLORS[light as usize].filter(|_| has_colours(&io::stdout()))
}

/// Whether a stream takes colours: a terminal without `NO_COLOR` (<https://no-color.org>).
pub fn has_colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

fn width() -> usize {
    if io::stdout().is_terminal() { textwrap::termwidth().min(WIDEST) } else { WIDTH }
}

/// Table with columns two spaces apart, wrapped to the width with the first column whole; headers may be none.
pub fn table<Row: IntoIterator<Item: Into<Cell>>>(
    headers: &[impl AsRef<str>], rows: impl IntoIterator<Item = Row>,
) -> ScreenText {
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(width() as u16);
    if !headers.is_empty() {
        let bold = Some(Attribute::Bold).filter(|_| has_colours(&io::stdout()));
        let cells = headers.iter().map(|header| comfy_table::Cell::new(header.as_ref()));
        table.set_header(cells.map(|cell| cell.add_attributes(bold.into_iter().collect())));
    }
    for row in rows {
        table.add_row(row.into_iter().map(Into::into).map(|cell| {
            let text = comfy_table::Cell::new(visible(&cell.to_string()));
            let color = if let Cell::Light(light, _) = cell { color(light) } else { None };
            color.map_or(text.clone(), |color| text.fg(Color::AnsiValue(8 + color)))
        }));
    }
    let last = table.column_count().saturating_sub(1);
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, if i < last { 2 } else { 0 }));
        if i == 0 {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
    }
    ScreenText(table.lines().map(|line| line.trim_end().to_owned() + "\n").collect())
}

pub fn rows<Row: IntoIterator<Item: Into<Cell>>>(rows: impl IntoIterator<Item = Row>) -> ScreenText {
    table::<Row>(&[""; 0], rows)
}

pub fn wrapped(text: impl AsRef<str>) -> ScreenText {
    let (text, width) = (visible(text.as_ref()), width());
    let lines = text.lines().map(|line| {
        let list = line.find("- ").filter(|at| line[..*at].trim().is_empty()).map(|at| at + 2);
        let column = line.trim_end().rfind("  ").map(|at| line[..at + 2].chars().count());
        let indent = " ".repeat(list.or(column).unwrap_or(0).min(width / 2));
        textwrap::fill(line, textwrap::Options::new(width).subsequent_indent(&indent)) + "\n"
    });
    ScreenText(lines.collect())
}

pub fn list(lines: impl IntoIterator<Item = impl AsRef<str>>) -> ScreenText {
    wrapped(lines.into_iter().map(|line| format!("- {}\n", line.as_ref())).collect::<String>())
}

pub fn highlighted(text: &str, word: &str, light: Light) -> ScreenText {
    let coloured = color(light).map_or(word.to_owned(), |color| format!("\u{1b}[1;3{color}m{word}\u{1b}[0m"));
    ScreenText(wrapped(text).0.replacen(word, &coloured, 1))
}
