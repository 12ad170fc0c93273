//! One pair of axes: their ranges, labels and what is drawn between them.

use super::shape::{draw_shape, stroke};
use super::text::{LABEL, SPACING, TICK, style, text_width};
use super::ticks::{tick, tick_count, ticks};
use super::{Canvas, NEVER, units};
use crate::output::chart::{BLACK, Look, Panel, Scale, Series};
use crate::output::outline::clipped;
use plotters::prelude::*;

const TICK_MARK: f64 = 6.0;

/// The rectangle and ranges of one panel.
pub(super) struct Frame {
    pub(super) height: f64,
    x: (f64, f64),
    y: (f64, f64),
}

impl Frame {
    pub(super) fn of(panel: &Panel, width: f64) -> Self {
        let [mut x, mut y] = panel.ranges();
        let height = match panel.scale {
            Scale::Fit { height, .. } => height,
            Scale::Section { .. } => {
                let height = (width * (y.1 - y.0) / (x.1 - x.0)).clamp(290.0, 560.0);
                // Whichever direction has room to spare shows more of its surroundings.
                x.1 = x.1.max(x.0 + (y.1 - y.0) * width / height);
                let more = 0.5 * ((x.1 - x.0) * height / width - (y.1 - y.0)).max(0.0);
                y = (y.0 - more, y.1 + more);
                height
            }
        };
        Self { height, x, y }
    }

    /// Draws the panel into its area; `left` is the width of its y labels.
    pub(super) fn draw(&self, panel: &Panel, canvas: &Canvas, area: &Canvas, left: f64) {
        // Down the page means drawing −y and labelling y.
        let sign = if matches!(panel.scale, Scale::Section { .. }) { -1.0 } else { 1.0 };
        let (bottom, top) = if sign < 0.0 { (-self.y.1, -self.y.0) } else { self.y };
        let mut chart = ChartBuilder::on(area)
            .set_label_area_size(LabelAreaPosition::Left, units(left))
            .set_label_area_size(LabelAreaPosition::Bottom, units(x_labels_height()))
            .build_cartesian_2d(self.x.0..self.x.1, bottom..top)
            .expect(NEVER);
        let to_units = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
            let plot = chart.plotting_area();
            points
                .iter()
                .filter(|p| p.0.is_finite() && p.1.is_finite())
                .map(|p| plot.map_coordinate(&(p.0, sign * p.1)))
                .map(|(x, y)| (f64::from(x), f64::from(y)))
                .collect()
        };
        let shapes: Vec<(&Series, Vec<(f64, f64)>)> = panel
            .series
            .iter()
            .map(|s| match s.look {
                Look::Area { .. } => (s, to_units(&clipped(&s.points, self.x, self.y))),
                _ => (s, to_units(&s.points)),
            })
            .collect();
        let (x_ticks, y_ticks) = (ticks(self.x, 8), ticks(self.y, tick_count(self.height)));
        chart
            .configure_mesh()
            .x_labels(8)
            .y_labels(tick_count(self.height))
            .x_label_formatter(&|v| tick(*v, &x_ticks))
            .y_label_formatter(&|v| tick(sign * v, &y_ticks))
            .x_desc(panel.x.text())
            .y_desc(panel.y.text())
            .axis_desc_style(style(LABEL, BLACK))
            .label_style(style(TICK, BLACK))
            .set_all_tick_mark_size(units(TICK_MARK))
            .axis_style(stroke(BLACK, 1.2))
            .bold_line_style(stroke((215, 215, 215), 0.8))
            .light_line_style(TRANSPARENT)
            .draw()
            .expect(NEVER);
        for (series, points) in &shapes {
            draw_shape(canvas, series.look, series.label.as_deref().unwrap_or(""), points);
        }
        let (x, y) = chart.plotting_area().get_pixel_range();
        let border = [(x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end), (x.start, y.start)];
        canvas.draw(&PathElement::new(border, stroke(BLACK, 1.2))).expect(NEVER);
    }
}

pub(super) fn x_labels_height() -> f64 {
    TICK_MARK + SPACING * (TICK + LABEL) + 4.0
}

pub(super) fn y_labels_width(range: &(f64, f64), panel: &Panel) -> f64 {
    let height = if let Scale::Fit { height, .. } = panel.scale { height } else { 400.0 };
    let values = ticks(*range, tick_count(height));
    let widest = values.iter().map(|v| text_width(&tick(*v, &values), TICK)).fold(0.0, f64::max);
    SPACING * LABEL + widest + TICK_MARK + 14.0
}
