//! Where everything goes: title, legend, panels, notes, from the top down.

use super::backend::units;
use super::canvas::Canvas;
use super::letters::{NOTE, SPACING, TICK, TITLE, text_width, wrapped};
use super::panel::{Frame, has_no_axes, is_small, x_labels_height, y_labels_width};
use super::shape::sample;
use super::text::text;
use crate::plot::chart::{BLACK, Chart, GREY, Look, Panel, Series};
use std::ops::Range;

/// Around every picture.
const MARGIN: f64 = 14.0;

/// Width of a line sample in the legend.
const SAMPLE: f64 = 38.0;
/// As narrow as small panels are, and as those with axes are.
const SMALL: f64 = 230.0;
const MULTIPLE: f64 = 360.0;
/// Below every panel.
const GAP: f64 = 10.0;

/// A picture laid out.
pub(super) struct Page<'a> {
    title: Vec<String>,
    /// Legend entries with their left edge, row by row.
    legend: Vec<Vec<(&'a Series, f64)>>,
    /// Width left of every panel's axis, so that their axes stand in line.
    left: f64,
    frames: Vec<Frame>,
    /// Width of a small panel.
    small: f64,
    /// Panels that stand side by side, from the top down, with the height of each row and its labels.
    rows: Vec<(Range<usize>, f64)>,
    notes: Vec<String>,
    width: f64,
    pub(super) height: f64,
}

impl<'a> Page<'a> {
    pub(super) fn of(chart: &'a Chart, width: f64) -> Self {
        let left = chart.panels.iter().map(|p| y_labels_width(&p.ranges()[1], p)).fold(0.0, f64::max);
        let has_axes = |panel: &Panel| is_small(panel) && !has_no_axes(panel);
        let narrowest = if chart.panels.iter().any(has_axes) { MULTIPLE } else { SMALL };
        let beside = beside(width, narrowest);
        let small = (width - (beside + 1) as f64 * MARGIN) / beside as f64;
        let wide = |panel: &Panel| match (is_small(panel), has_no_axes(panel)) {
            (_, true) => small,
            (true, _) => small - left,
            _ => width - left - 2.0 * MARGIN,
        };
        let frames: Vec<Frame> = chart.panels.iter().map(|panel| Frame::of(panel, wide(panel))).collect();
        let rows = rows(&chart.panels, &frames, beside);
        let across = |text: &String, size| match text.is_empty() {
            true => Vec::new(),
            false => wrapped(text, size, width - 2.0 * MARGIN),
        };
        let title = across(&chart.title, TITLE);
        let legend = legend(chart, width);
        let notes: Vec<String> = chart.notes.iter().flat_map(|note| across(note, NOTE)).collect();
        let height = 2.0 * MARGIN
            + SPACING * (TITLE * title.len() as f64 + TICK * legend.len() as f64 + NOTE * notes.len() as f64)
            + rows.iter().map(|(_, height)| height + GAP).sum::<f64>()
            + MARGIN;
        Self { title, legend, left, frames, small, rows, notes, width, height: height.ceil() }
    }

    pub(super) fn draw(&self, chart: &Chart, canvas: &Canvas) {
        let mut y = MARGIN;
        for line in &self.title {
            text(canvas, line, TITLE, BLACK, (MARGIN, y));
            y += SPACING * TITLE;
        }
        y += 0.5 * MARGIN;
        text(canvas, &chart.legend, TICK, BLACK, (MARGIN, y));
        for row in &self.legend {
            for (series, x) in row {
                sample(canvas, series.look, (*x, y + 0.5 * TICK), (SAMPLE, 0.3 * TICK));
                let label = series.label.as_deref().unwrap_or("");
                text(canvas, label, TICK, BLACK, (x + SAMPLE + 8.0, y));
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
                if is_small(panel) {
                    let x = MARGIN + column as f64 * (self.small + MARGIN);
                    text(canvas, caption(panel), TICK, BLACK, (x, y));
                    let below = if has_no_axes(panel) { 0.0 } else { x_labels_height() };
                    let area = area(x, y + SPACING * TICK, self.small, frame.height + below);
                    frame.draw(panel, &area, self.left);
                } else {
                    frame.draw(panel, &area(MARGIN, y, self.width - 2.0 * MARGIN, *height), self.left);
                }
            }
            y += height + GAP;
        }
        for line in &self.notes {
            text(canvas, line, NOTE, GREY, (MARGIN, y));
            y += SPACING * NOTE;
        }
    }
}

/// As many small panels as stand side by side on a page of this width.
fn beside(width: f64, narrowest: f64) -> usize {
    ((width - MARGIN) / (narrowest + MARGIN)).max(1.0) as usize
}

/// Every panel in a row of its own, or so many small ones side by side; and how high each row is.
fn rows(panels: &[Panel], frames: &[Frame], beside: usize) -> Vec<(Range<usize>, f64)> {
    let mut rows: Vec<(Range<usize>, f64)> = Vec::new();
    for (i, (panel, frame)) in panels.iter().zip(frames).enumerate() {
        let caption = if is_small(panel) { SPACING * TICK } else { 0.0 };
        let labels = caption + if has_no_axes(panel) { 0.0 } else { x_labels_height() };
        let height = frame.height + labels;
        match rows.last_mut() {
            Some((row, highest)) if is_small(panel) && is_small(&panels[row.start]) && row.len() < beside => {
                row.end = i + 1;
                *highest = highest.max(height);
            }
            _ => rows.push((i..i + 1, height)),
        }
    }
    rows
}

/// What stands above a small panel.
fn caption(panel: &Panel) -> &str {
    let caption = panel.series.iter().find(|series| series.look == Look::Text && series.points.is_empty());
    caption.and_then(|series| series.label.as_deref()).unwrap_or("")
}

/// Rows of legend entries, as many side by side as fit.
fn legend(chart: &Chart, page: f64) -> Vec<Vec<(&Series, f64)>> {
    let mut rows: Vec<Vec<(&Series, f64)>> = Vec::new();
    let indent = if chart.legend.is_empty() { 0.0 } else { text_width(&chart.legend, TICK) + 14.0 };
    let left = MARGIN + indent;
    let mut x = f64::INFINITY;
    for series in chart.panels.iter().flat_map(|p| &p.series).filter(|series| series.look.is_explained()) {
        let Some(label) = &series.label else { continue };
        let width = SAMPLE + 8.0 + text_width(label, TICK);
        if x + width > page - MARGIN {
            rows.push(Vec::new());
            x = left;
        }
        rows.last_mut().expect("a row was started").push((series, x));
        x += width + 20.0;
    }
    rows
}
