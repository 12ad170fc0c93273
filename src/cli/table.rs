//! Printed tables and texts: as wide as the terminal, 80 columns elsewhere; coloured on terminals only.

use super::say::Shown;
use comfy_table::{Attribute, Color, ColumnConstraint, ContentArrangement, Table, presets};
use stampflow::assess::Light;
use stampflow::case::files::visible;
use std::io::{self, IsTerminal};

/// Columns without a terminal.
const WIDTH: usize = 80;
/// Columns of a wide terminal: longer lines are hard to read.
const WIDEST: usize = 120;

/// Colour of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    Plain,
    Good,
    Bad,
    Warning,
}

impl Tone {
    pub fn of(light: Light) -> Self {
        match light {
            Light::Grey => Self::Plain,
            Light::Green => Self::Good,
            Light::Amber => Self::Warning,
            Light::Red => Self::Bad,
        }
    }

    fn color(self) -> Option<Color> {
        match self {
            Self::Plain => None,
            Self::Good => Some(Color::Green),
            Self::Bad => Some(Color::Red),
            Self::Warning => Some(Color::Yellow),
        }
    }
}

#[derive(Clone, Debug)]
pub struct Cell {
    pub text: String,
    pub tone: Tone,
}

impl Cell {
    pub fn plain(text: impl Into<String>) -> Self {
        Self { text: text.into(), tone: Tone::Plain }
    }
}

/// Whether a stream takes colours: a terminal without `NO_COLOR` (<https://no-color.org>).
pub fn colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

/// Columns of the output stream.
pub fn width() -> usize {
    if io::stdout().is_terminal() { textwrap::termwidth().min(WIDEST) } else { WIDTH }
}

/// Table with columns two spaces apart, wrapped to the width with the first column whole.
pub fn table<const N: usize>(headers: Option<[&str; N]>, rows: Vec<[Cell; N]>) -> Shown {
    table_of(headers.map(|headers| headers.to_vec()), rows.into_iter().map(Vec::from).collect())
}

/// Like [`table`], for any number of columns.
pub fn table_of(headers: Option<Vec<&str>>, rows: Vec<Vec<Cell>>) -> Shown {
    let count = headers.as_ref().map(Vec::len).or(rows.first().map(Vec::len)).unwrap_or(0);
    let coloured = colours(&io::stdout());
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(width() as u16);
    if let Some(headers) = headers {
        let bold = Some(Attribute::Bold).filter(|_| coloured);
        table.set_header(
            headers.into_iter().map(|header| comfy_table::Cell::new(header).add_attributes(bold.into_iter().collect())),
        );
    }
    for row in rows {
        table.add_row(row.into_iter().map(|Cell { text, tone }| {
            let cell = comfy_table::Cell::new(visible(&text));
            tone.color().filter(|_| coloured).map_or(cell.clone(), |color| cell.fg(color))
        }));
    }
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, if i + 1 < count { 2 } else { 0 }));
        if i == 0 {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
    }
    Shown::coloured(table.lines().map(|line| line.trim_end().to_owned() + "\n").collect())
}

/// Text wrapped to the width, each line's rest under its last column.
pub fn wrapped(text: &str) -> Shown {
    visible(text).lines().map(|line| hanging(line, width()) + "\n").collect::<String>().into()
}

/// Text with the first occurrence of a word in a tone.
pub fn toned(text: &str, word: &str, tone: Tone) -> Shown {
    let text = wrapped(text);
    match tone.color().filter(|_| colours(&io::stdout())) {
        Some(color) => {
            let code = if color == Color::Red {
                31
            } else if color == Color::Green {
                32
            } else {
                33
            };
            Shown::coloured(text.text().replacen(word, &format!("\u{1b}[1;{code}m{word}\u{1b}[0m"), 1))
        }
        None => text,
    }
}

fn hanging(line: &str, width: usize) -> String {
    let list = line.find("- ").filter(|at| line[..*at].trim().is_empty()).map(|at| at + 2);
    let column = line.trim_end().rfind("  ").map(|at| line[..at + 2].chars().count());
    let indent = " ".repeat(list.or(column).unwrap_or(0).min(width / 2));
    textwrap::fill(line, textwrap::Options::new(width).subsequent_indent(&indent))
}
