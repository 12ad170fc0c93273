//! Page layout: title, legend, panels and notes from the top down.

use super::panel::{Frame, X_LABELS_HEIGHT, y_labels_width};
use super::shapes::sample;
use super::text::{NOTE, SPACING, TICK, TITLE, wrapped};
use super::*;

const MARGIN: f64 = 14.0;
const GAP: f64 = 10.0;
const SAMPLE: f64 = 38.0;
const AFTER_SAMPLE: f64 = 8.0;
const AFTER_LABEL: f64 = 20.0;
const SMALL: f64 = 230.0;
const SMALL_WITH_AXES: f64 = 360.0;

pub(super) fn draw(chart: &Chart, width: f64, canvas: &Canvas) -> f64 {
    let mut y = MARGIN;
    let paragraph = |text: &str, size: f64, color, y: &mut f64| {
        for line in wrapped(text, size, width - 2.0 * MARGIN).iter().filter(|_| !text.is_empty()) {
            text::draw(canvas, line, size, color, (MARGIN, *y));
            *y += SPACING * size;
        }
    };
    paragraph(&chart.title, TITLE, BLACK, &mut y);
    y = legend(chart, width, y + 0.5 * MARGIN, canvas) + 0.5 * MARGIN;
    y = panels(&chart.panels, width, y, canvas);
    chart.notes.iter().for_each(|note| paragraph(note, NOTE, GREY, &mut y));
    (y + MARGIN).ceil()
}

fn legend(chart: &Chart, page: f64, top: f64, canvas: &Canvas) -> f64 {
    text::draw(canvas, &chart.legend, TICK, BLACK, (MARGIN, top));
    let (mut x, mut below) = (f64::INFINITY, top);
    for series in chart.panels.iter().flat_map(|panel| &panel.series) {
        let Some(label) = &series.label else { continue };
        let width = SAMPLE + AFTER_SAMPLE + text::width(label, TICK);
        if x + width > page - MARGIN {
            below += SPACING * TICK;
            x = MARGIN + if chart.legend.is_empty() { 0.0 } else { text::width(&chart.legend, TICK) + MARGIN };
        }
        let y = below - SPACING * TICK;
        sample(canvas, series.style, (x, y + 0.5 * TICK), (SAMPLE, 0.3 * TICK));
        text::draw(canvas, label, TICK, BLACK, (x + SAMPLE + AFTER_SAMPLE, y));
        x += width + AFTER_LABEL;
    }
    below
}

fn panels(panels: &[Panel], width: f64, top: f64, canvas: &Canvas) -> f64 {
    let left = panels.iter().map(y_labels_width).fold(0.0, f64::max);
    let has_axes = panels.iter().any(|panel| panel.is_small && !panel.has_no_axes());
    let columns = ((width - MARGIN) / ((if has_axes { SMALL_WITH_AXES } else { SMALL }) + MARGIN)).max(1.0) as usize;
    let small_width = (width - (columns + 1) as f64 * MARGIN) / columns as f64;
    let (mut y, mut below, mut column) = (top, top, columns);
    for panel in panels {
        if !panel.is_small || column == columns {
            (y, column) = (below, 0);
        }
        let outer = if panel.is_small { small_width } else { width - 2.0 * MARGIN };
        let frame = Frame::new(panel, if panel.has_no_axes() { outer } else { outer - left });
        let caption = if panel.is_small { SPACING * TICK } else { 0.0 };
        let height = frame.height + if panel.has_no_axes() { 0.0 } else { X_LABELS_HEIGHT };
        let x = MARGIN + column as f64 * (small_width + MARGIN);
        if panel.is_small {
            text::draw(canvas, &panel.caption, TICK, BLACK, (x, y));
        }
        frame.draw(panel, &canvas.clone().shrink((units(x), units(y + caption)), (units(outer), units(height))), left);
        column = if panel.is_small { column + 1 } else { columns };
        below = below.max(y + caption + height + GAP);
    }
    below
}
