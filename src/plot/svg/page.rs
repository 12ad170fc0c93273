//! Page layout: title, legend, panels and notes from the top down.

use super::panel::{Frame, x_labels_height, y_labels_width};
use super::shapes::sample;
use super::text::{self, NOTE, SPACING, TICK, TITLE, wrapped};
use super::{Canvas, units};
use crate::plot::chart::{Chart, Panel, Series};
use crate::plot::palette::{BLACK, GREY};
use std::ops::Range;

/// Space around every picture, and below every panel.
const MARGIN: f64 = 14.0;
const GAP: f64 = 10.0;
/// Width of a legend sample, the space behind it, and the space behind its label.
const SAMPLE: f64 = 38.0;
const AFTER_SAMPLE: f64 = 8.0;
const AFTER_LABEL: f64 = 20.0;
/// Least width of small panels without axes and with axes.
const SMALL: f64 = 230.0;
const SMALL_WITH_AXES: f64 = 360.0;

/// Picture laid out.
pub(super) struct Page<'a> {
    title: Vec<String>,
    /// Legend entries with their left edge, row by row.
    legend: Vec<Vec<(&'a Series, f64)>>,
    /// Width left of every panel's y axis, so that the axes stand in line.
    left: f64,
    frames: Vec<Frame>,
    small_width: f64,
    /// Panels side by side, from the top down, with the height of each row.
    rows: Vec<(Range<usize>, f64)>,
    notes: Vec<String>,
    width: f64,
    pub(super) height: f64,
}

impl<'a> Page<'a> {
    pub(super) fn new(chart: &'a Chart, width: f64) -> Self {
        let left = chart.panels.iter().map(y_labels_width).fold(0.0, f64::max);
        let has_axes = chart.panels.iter().any(|panel| panel.is_small && !panel.has_no_axes());
        let narrowest = if has_axes { SMALL_WITH_AXES } else { SMALL };
        let columns = ((width - MARGIN) / (narrowest + MARGIN)).max(1.0) as usize;
        let small_width = (width - (columns + 1) as f64 * MARGIN) / columns as f64;
        let inner_width = |panel: &Panel| match (panel.is_small, panel.has_no_axes()) {
            (_, true) => small_width,
            (true, _) => small_width - left,
            _ => width - left - 2.0 * MARGIN,
        };
        let frames: Vec<Frame> = chart.panels.iter().map(|panel| Frame::new(panel, inner_width(panel))).collect();
        let rows = rows(&chart.panels, &frames, columns);
        let lines = |text: &String, size| match text.is_empty() {
            true => Vec::new(),
            false => wrapped(text, size, width - 2.0 * MARGIN),
        };
        let title = lines(&chart.title, TITLE);
        let legend = legend(chart, width);
        let notes: Vec<String> = chart.notes.iter().flat_map(|note| lines(note, NOTE)).collect();
        let height = 3.0 * MARGIN
            + SPACING * (TITLE * title.len() as f64 + TICK * legend.len() as f64 + NOTE * notes.len() as f64)
            + rows.iter().map(|(_, height)| height + GAP).sum::<f64>();
        Self { title, legend, left, frames, small_width, rows, notes, width, height: height.ceil() }
    }

    pub(super) fn draw(&self, chart: &Chart, canvas: &Canvas) {
        let mut y = MARGIN;
        for line in &self.title {
            text::draw(canvas, line, TITLE, BLACK, (MARGIN, y));
            y += SPACING * TITLE;
        }
        y += 0.5 * MARGIN;
        text::draw(canvas, &chart.legend, TICK, BLACK, (MARGIN, y));
        for row in &self.legend {
            for (series, x) in row {
                sample(canvas, series.style, (*x, y + 0.5 * TICK), (SAMPLE, 0.3 * TICK));
                let label = series.label.as_deref().unwrap_or("");
                text::draw(canvas, label, TICK, BLACK, (x + SAMPLE + AFTER_SAMPLE, y));
            }
            y += SPACING * TICK;
        }
        y += 0.5 * MARGIN;
        let area = |x: f64, y: f64, width: f64, height: f64| {
            canvas.clone().shrink((units(x), units(y)), (units(width), units(height)))
        };
        for (row, height) in &self.rows {
            for (column, i) in row.clone().enumerate() {
                let (panel, frame) = (&chart.panels[i], &self.frames[i]);
                if panel.is_small {
                    let x = MARGIN + column as f64 * (self.small_width + MARGIN);
                    text::draw(canvas, &panel.caption, TICK, BLACK, (x, y));
                    let height = frame.height + labels_height(panel);
                    frame.draw(panel, &area(x, y + SPACING * TICK, self.small_width, height), self.left);
                } else {
                    frame.draw(panel, &area(MARGIN, y, self.width - 2.0 * MARGIN, *height), self.left);
                }
            }
            y += height + GAP;
        }
        for line in &self.notes {
            text::draw(canvas, line, NOTE, GREY, (MARGIN, y));
            y += SPACING * NOTE;
        }
    }
}

fn labels_height(panel: &Panel) -> f64 {
    if panel.has_no_axes() { 0.0 } else { x_labels_height() }
}

/// Puts every panel in a row of its own, small ones side by side; also gives the height of each row.
fn rows(panels: &[Panel], frames: &[Frame], columns: usize) -> Vec<(Range<usize>, f64)> {
    let mut rows: Vec<(Range<usize>, f64)> = Vec::new();
    for (i, (panel, frame)) in panels.iter().zip(frames).enumerate() {
        let caption = if panel.is_small { SPACING * TICK } else { 0.0 };
        let height = frame.height + caption + labels_height(panel);
        match rows.last_mut() {
            Some((row, highest)) if panel.is_small && panels[row.start].is_small && row.len() < columns => {
                row.end = i + 1;
                *highest = highest.max(height);
            }
            _ => rows.push((i..i + 1, height)),
        }
    }
    rows
}

/// Rows of legend entries.
fn legend(chart: &Chart, page: f64) -> Vec<Vec<(&Series, f64)>> {
    let mut rows: Vec<Vec<(&Series, f64)>> = Vec::new();
    let heading = if chart.legend.is_empty() { 0.0 } else { text::width(&chart.legend, TICK) + MARGIN };
    let mut x = f64::INFINITY;
    for series in chart.panels.iter().flat_map(|p| &p.series) {
        let Some(label) = &series.label else { continue };
        let width = SAMPLE + AFTER_SAMPLE + text::width(label, TICK);
        if x + width > page - MARGIN {
            rows.push(Vec::new());
            x = MARGIN + heading;
        }
        rows.last_mut().expect("a row was started").push((series, x));
        x += width + AFTER_LABEL;
    }
    rows
}
