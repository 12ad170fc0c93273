//! Where everything goes: title, legend, panels, notes, from the top down.

use super::backend::units;
use super::canvas::Canvas;
use super::letters::{NOTE, SPACING, TICK, TITLE, text_width, wrapped};
use super::panel::{Frame, x_labels_height, y_labels_width};
use super::shape::sample;
use super::text::text;
use crate::output::chart::{BLACK, Chart, GREY, Series};

/// Around every picture.
const MARGIN: f64 = 14.0;

/// Width of a line sample in the legend.
const SAMPLE: f64 = 38.0;
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
    notes: Vec<String>,
    width: f64,
    pub(super) height: f64,
}

impl<'a> Page<'a> {
    pub(super) fn of(chart: &'a Chart, width: f64) -> Self {
        let left = chart.panels.iter().map(|p| y_labels_width(&p.ranges()[1], p)).fold(0.0, f64::max);
        let frames: Vec<Frame> = chart.panels.iter().map(|p| Frame::of(p, width - left - 2.0 * MARGIN)).collect();
        let across = |text: &String, size| match text.is_empty() {
            true => Vec::new(),
            false => wrapped(text, size, width - 2.0 * MARGIN),
        };
        let title = across(&chart.title, TITLE);
        let legend = legend(chart, width);
        let notes: Vec<String> = chart.notes.iter().flat_map(|note| across(note, NOTE)).collect();
        let height = 2.0 * MARGIN
            + SPACING * (TITLE * title.len() as f64 + TICK * legend.len() as f64 + NOTE * notes.len() as f64)
            + frames.iter().map(|f| f.height + x_labels_height() + GAP).sum::<f64>()
            + MARGIN;
        Self { title, legend, left, frames, notes, width, height: height.ceil() }
    }

    pub(super) fn draw(&self, chart: &Chart, canvas: &Canvas) {
        let mut y = MARGIN;
        for line in &self.title {
            text(canvas, line, TITLE, BLACK, (MARGIN, y));
            y += SPACING * TITLE;
        }
        y += 0.5 * MARGIN;
        text(canvas, chart.legend, TICK, BLACK, (MARGIN, y));
        for row in &self.legend {
            for (series, x) in row {
                sample(canvas, series.look, (*x, y + 0.5 * TICK), (SAMPLE, 0.3 * TICK));
                let label = series.label.as_deref().unwrap_or("");
                text(canvas, label, TICK, BLACK, (x + SAMPLE + 8.0, y));
            }
            y += SPACING * TICK;
        }
        y += 0.5 * MARGIN;
        for (panel, frame) in chart.panels.iter().zip(&self.frames) {
            let height = frame.height + x_labels_height();
            let area =
                canvas.clone().shrink((units(MARGIN), units(y)), (units(self.width - 2.0 * MARGIN), units(height)));
            frame.draw(panel, &area, self.left);
            y += height + GAP;
        }
        for line in &self.notes {
            text(canvas, line, NOTE, GREY, (MARGIN, y));
            y += SPACING * NOTE;
        }
    }
}

/// Rows of legend entries, as many side by side as fit.
fn legend(chart: &Chart, page: f64) -> Vec<Vec<(&Series, f64)>> {
    let mut rows: Vec<Vec<(&Series, f64)>> = Vec::new();
    let indent = if chart.legend.is_empty() { 0.0 } else { text_width(chart.legend, TICK) + 14.0 };
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
