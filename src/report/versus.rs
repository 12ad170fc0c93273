//! Comparison with other runs and measurements: pictures of all, and the table of their differences.

use super::page::{Section, figure, list, table, word};
use crate::plot::Chart;
use crate::study::Cell;
use crate::study::compare::SideBySide;
use maud::html;

pub(super) fn section(all: &SideBySide) -> Section {
    let differences = all.table();
    let text = |cell: &Cell| match cell {
        Cell::Light(light, _) => word(*light),
        cell => cell.to_string(),
    };
    let rows: Vec<[String; 4]> = differences.rows.iter().map(|row| [0, 1, 2, 3].map(|i| text(&row[i]))).collect();
    let content = html! {
        (list(&all.legend(), ""))
        (table(&["Quantity", "Run", "Value", "Difference"], rows))
        @for (_, about, chart) in all.charts() {
            (figure(&Chart { title: String::new(), ..chart }, about))
        }
    };
    Section::new("Compared", content)
}
