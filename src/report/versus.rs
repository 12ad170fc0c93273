//! Comparison with other runs and measurements: pictures of all, and the table of their differences.

use super::page::{Section, figure, list, table, word};
use crate::output::study::versus::pictures;
use crate::plot::Chart;
use crate::study::versus::{COLUMNS, Versus};
use maud::html;

pub(super) fn section(versus: &Versus) -> Section {
    let mut rows = Vec::new();
    for line in versus.lines() {
        for (i, (entry, member)) in line.of_runs.into_iter().zip(&versus.members).enumerate() {
            let value = entry.light.map_or_else(|| entry.value.to_string(), word);
            let first = if i == 0 { line.label.to_string() } else { String::new() };
            rows.push([first, member.mark.clone(), value, entry.change.to_string()]);
        }
    }
    let content = html! {
        (list(&versus.legend(), ""))
        (table(&COLUMNS, rows))
        @for picture in pictures(versus, false) {
            (figure(&Chart { title: String::new(), ..picture.chart }, &picture.about))
        }
    };
    Section::new("Compared", content)
}
