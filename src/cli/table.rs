//! Printed tables and texts: as wide as the terminal, 80 columns elsewhere; coloured on terminals only.

use super::say::Shown;
use comfy_table::{Attribute, Color, ColumnConstraint, ContentArrangement, Table, presets};
use stampflow::assess::Light;
use stampflow::case::files::visible;
pub use stampflow::study::Cell;
use std::io::{self, IsTerminal};

/// Columns without a terminal.
const WIDTH: usize = 80;
/// Columns of a wide terminal: longer lines are hard to read.
const WIDEST: usize = 120;

/// Colour of a light in tables and as an escape code; `None` without colours.
fn color(light: Light) -> Option<(Color, u8)> {
    let color = match light {
        Light::Grey => None,
        Light::Green => Some((Color::Green, 32)),
        Light::Amber => Some((Color::Yellow, 33)),
        Light::Red => Some((Color::Red, 31)),
    };
    color.filter(|_| colours(&io::stdout()))
}

/// Whether a stream takes colours: a terminal without `NO_COLOR` (<https://no-color.org>).
pub fn colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

fn width() -> usize {
    if io::stdout().is_terminal() { textwrap::termwidth().min(WIDEST) } else { WIDTH }
}

/// Table with columns two spaces apart, wrapped to the width with the first column whole.
pub fn table<const N: usize>(headers: Option<[&str; N]>, rows: Vec<[Cell; N]>) -> Shown {
    table_of(headers.map(|headers| headers.to_vec()), rows.into_iter().map(Vec::from).collect())
}

/// Like [`table`], for any number of columns.
pub fn table_of(headers: Option<Vec<&str>>, rows: Vec<Vec<Cell>>) -> Shown {
    let count = headers.as_ref().map(Vec::len).or(rows.first().map(Vec::len)).unwrap_or(0);
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic);
    table.set_width(width() as u16);
    if let Some(headers) = headers {
        let bold = Some(Attribute::Bold).filter(|_| colours(&io::stdout()));
        let header = |header| comfy_table::Cell::new(header).add_attributes(bold.into_iter().collect());
        table.set_header(headers.into_iter().map(header));
    }
    for row in rows {
        table.add_row(row.into_iter().map(|cell| {
            let shown = comfy_table::Cell::new(visible(&cell.to_string()));
            let color = if let Cell::Light(light, _) = cell { color(light) } else { None };
            color.map_or(shown.clone(), |(color, _)| shown.fg(color))
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

/// Text with the first occurrence of a word in the colour of a light.
pub fn toned(text: &str, word: &str, light: Light) -> Shown {
    let text = wrapped(text);
    let Some((_, code)) = color(light) else { return text };
    Shown::coloured(text.text().replacen(word, &format!("\u{1b}[1;{code}m{word}\u{1b}[0m"), 1))
}

fn hanging(line: &str, width: usize) -> String {
    let list = line.find("- ").filter(|at| line[..*at].trim().is_empty()).map(|at| at + 2);
    let column = line.trim_end().rfind("  ").map(|at| line[..at + 2].chars().count());
    let indent = " ".repeat(list.or(column).unwrap_or(0).min(width / 2));
    textwrap::fill(line, textwrap::Options::new(width).subsequent_indent(&indent))
}
