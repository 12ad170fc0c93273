//! Printed tables: as wide as the terminal, and coloured where a human looks on.

use super::say::Shown;
use comfy_table::{Attribute, Cell, Color, ColumnConstraint, ContentArrangement, Table, presets};
use stampflow::files::visible;
use std::io::{self, IsTerminal};

/// What a row is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    Plain,
    Good,
    Bad,
    Warning,
}

impl Tone {
    fn color(self) -> Option<Color> {
        match self {
            Self::Plain => None,
            Self::Good => Some(Color::Green),
            Self::Bad => Some(Color::Red),
            Self::Warning => Some(Color::Yellow),
        }
    }
}

/// Whether to colour what goes to a stream: it is a terminal, and `NO_COLOR` is not set, or empty
/// (<https://no-color.org>).
pub fn colours(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|value| value.is_empty())
}

/// Columns in line, two spaces apart, under their headers, if any; cells of a row are toned alike from `toned` on.
///
/// On a terminal cells are wrapped to its width, with the first column whole; elsewhere every row is one line.
pub fn table<const N: usize>(headers: Option<[&str; N]>, rows: Vec<([String; N], Tone)>, toned: usize) -> Shown {
    let coloured = colours(&io::stdout());
    let mut table = Table::new();
    table.load_preset(presets::NOTHING).set_content_arrangement(ContentArrangement::Dynamic);
    if let Some(headers) = headers {
        let cells = headers.map(|header| {
            Cell::new(header).add_attributes(Some(Attribute::Bold).filter(|_| coloured).into_iter().collect())
        });
        table.set_header(cells);
    }
    for (row, tone) in rows {
        let color = tone.color().filter(|_| coloured);
        table.add_row(row.iter().enumerate().map(|(i, text)| {
            let cell = Cell::new(visible(text));
            color.filter(|_| i >= toned).map_or(cell.clone(), |color| cell.fg(color))
        }));
    }
    for (i, column) in table.column_iter_mut().enumerate() {
        column.set_padding((0, if i + 1 < N { 2 } else { 0 }));
        if i == 0 {
            column.set_constraint(ColumnConstraint::ContentWidth);
        }
    }
    Shown::coloured(table.lines().map(|line| line.trim_end().to_owned() + "\n").collect())
}

/// Text as wide as the terminal, each line's rest under its last column; elsewhere as it is.
pub fn wrapped(text: &str) -> Shown {
    if !io::stdout().is_terminal() {
        return text.into();
    }
    let width = textwrap::termwidth();
    visible(text).lines().map(|line| hanging(line, width) + "\n").collect::<String>().into()
}

fn hanging(line: &str, width: usize) -> String {
    let list = line.find("- ").filter(|at| line[..*at].trim().is_empty()).map(|at| at + 2);
    let column = line.trim_end().rfind("  ").map(|at| line[..at + 2].chars().count());
    let indent = " ".repeat(list.or(column).unwrap_or(0).min(width / 2));
    textwrap::fill(line, textwrap::Options::new(width).subsequent_indent(&indent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rest_of_a_line_hangs_under_its_last_column() {
        assert_eq!(hanging("  travel      36 mm at 1 mm/s", 22), "  travel      36 mm at\n           1 mm/s");
        assert_eq!(hanging("  - a note of some words", 14), "  - a note of\n    some words");
    }

    #[test]
    fn columns_stand_in_line_whatever_their_letters() {
        let row = |cells: [&str; 3]| (cells.map(str::to_owned), Tone::Good);
        let rows = vec![row(["ł.csv", "no data", "scatter"]), row(["  a longer name", "–", ""])];
        let text = table(Some(["case", "verdict", "reason"]), rows, 1);
        let lines: Vec<&str> = text.text().lines().collect();
        let at = |line: &str, word: &str| line[..line.find(word).unwrap()].chars().count();
        assert_eq!(at(lines[0], "verdict"), at(lines[1], "no data"));
        assert_eq!(at(lines[0], "reason"), at(lines[1], "scatter"));
        assert_eq!(lines[2], "  a longer name  –");
        assert!(!text.text().contains('\u{1b}'), "tests are no terminal");
    }
}
