//! Tables: columns as wide as their words want, rows that are never cut, the head again on each page.

use super::colors::{GREY_TEXT, RULE, of_light};
use super::flow::{Flow, WIDTH};
use super::words::{Style, lines, widest_word};
use crate::report::document::Row;

const HEAD: Style = Style::new(8.0).in_color(GREY_TEXT);
const CELL: Style = Style::new(8.5);
/// Between columns, and above and below the words of a row \[pt\].
const GAP: f64 = 8.0;
const PAD: f64 = 2.2;
/// How far what belongs to the row above is indented \[pt\].
const INDENT: f64 = 10.0;

/// Draws a table from where the page is filled to.
pub(super) fn draw(flow: &mut Flow, head: &[String], rows: &[Row]) {
    let widths = widths(head, rows);
    let [head_height, first] =
        [height(head.iter().map(String::as_str), HEAD, &widths), rows.first().map_or(0.0, |row| of(row, &widths))];
    flow.reserve(head_height + first);
    draw_head(flow, head, &widths, head_height);
    for row in rows {
        let height = of(row, &widths);
        if height > flow.left() {
            flow.turn();
            draw_head(flow, head, &widths, head_height);
        }
        let (mut x, top) = (0.0, flow.y);
        for (i, (cell, width)) in row.cells.iter().zip(&widths).enumerate() {
            let style = match row.light.filter(|_| i == 0) {
                Some(light) => CELL.in_color(of_light(light)).bold(),
                None => CELL,
            };
            let indent = if i == 0 && row.belongs { INDENT } else { 0.0 };
            draw_cell(flow, cell, style, (x + indent, top + PAD), width - indent);
            x += width + GAP;
        }
        flow.skip(height);
        flow.rule(flow.y, RULE, 0.4);
    }
    flow.skip(8.0);
}

fn draw_head(flow: &mut Flow, head: &[String], widths: &[f64], height: f64) {
    let (mut x, top) = (0.0, flow.y);
    for (cell, width) in head.iter().zip(widths) {
        draw_cell(flow, cell, HEAD, (x, top + PAD), *width);
        x += width + GAP;
    }
    flow.skip(height);
    flow.rule(flow.y, GREY_TEXT, 0.8);
}

fn draw_cell(flow: &mut Flow, cell: &str, style: Style, (x, top): (f64, f64), width: f64) {
    for (i, line) in lines(cell, style, width).iter().enumerate() {
        flow.write(line, style, x, top + i as f64 * style.leading());
    }
}

fn of(row: &Row, widths: &[f64]) -> f64 {
    height(row.cells.iter().map(String::as_str), CELL, widths)
}

/// Of a row \[pt\].
fn height<'a>(cells: impl Iterator<Item = &'a str>, style: Style, widths: &[f64]) -> f64 {
    let indented = |i: usize| if i == 0 { INDENT } else { 0.0 };
    let cells = cells.zip(widths).enumerate();
    let most = cells.map(|(i, (cell, width))| lines(cell, style, width - indented(i)).len()).max().unwrap_or(1);
    most as f64 * style.leading() + 2.0 * PAD
}

/// Each column has room for its widest word, and of what is left as much as its cells want of it.
fn widths(head: &[String], rows: &[Row]) -> Vec<f64> {
    let room = WIDTH - GAP * (head.len() - 1) as f64;
    // No column takes more than half of it from the others.
    let most = 0.5 * room;
    let of = |i: usize, measure: &dyn Fn(&str, Style) -> f64| {
        let cells = rows.iter().filter_map(|row| row.cells.get(i)).map(|cell| measure(cell, CELL.bold()));
        cells.fold(measure(&head[i], HEAD), f64::max) + INDENT + 1.0
    };
    let columns = 0..head.len();
    let least: Vec<f64> = columns.clone().map(|i| of(i, &widest_word).min(2.0 * most / head.len() as f64)).collect();
    let wanted: Vec<f64> = columns.map(|i| of(i, &|text, style| style.width(text)).min(most).max(least[i])).collect();
    let (sure, all): (f64, f64) = (least.iter().sum(), wanted.iter().sum());
    if all <= room {
        // The last column takes what none needs.
        let mut widths = wanted;
        widths[head.len() - 1] += room - all;
        return widths;
    }
    let share = ((room - sure) / (all - sure)).max(0.0);
    least.iter().zip(&wanted).map(|(least, wanted)| least + share * (wanted - least)).collect()
}
