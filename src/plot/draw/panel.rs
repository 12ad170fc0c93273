//! One pair of axes: their ranges, labels and what is drawn between them.

use super::backend::units;
use super::canvas::{Canvas, NEVER};
use super::flags::Flags;
use super::letters::{LABEL, SPACING, TICK, text_width};
use super::shape::{Shape, stroke};
use super::text::style;
use super::ticks::{Ticked, decades, spread, tick, tick_count, ticks};
use crate::plot::chart::{BLACK, Color, Look, Panel, Scale};
use crate::plot::outline::clipped;
use crate::table::Axis;
use plotters::chart::{ChartBuilder, LabelAreaPosition};
use plotters::element::Rectangle;

/// Labels of the x axis at most.
const X_TICKS: usize = 8;
/// Width that a label of a narrow panel's x axis has for itself.
const NARROW_TICK: f64 = 70.0;
const TICK_MARK: f64 = 6.0;
/// Width of axes and of their grid.
const AXIS: f64 = 1.2;
const GRID: f64 = 0.8;
const GRID_COLOR: Color = (215, 215, 215);

/// Heights of sections, and of small ones.
const HEIGHTS: (f64, f64) = (290.0, 560.0);
const SMALL_HEIGHTS: (f64, f64) = (110.0, 320.0);
/// Height of a scale of colours.
const BAR: f64 = 18.0;

/// What is further away, in widths of the panel, is left out: it would overflow plotters' units.
const FAR: f64 = 1e3;

/// The rectangle and ranges of one panel.
pub(super) struct Frame {
    pub(super) height: f64,
    x: (f64, f64),
    y: (f64, f64),
    /// Values of x that are written, at most.
    most: usize,
    flags: Flags,
}

impl Frame {
    pub(super) fn of(panel: &Panel, width: f64) -> Self {
        let [mut x, mut y] = panel.ranges();
        let height = match panel.scale {
            Scale::Fit { height, .. } | Scale::Window { height, .. } | Scale::Multiple { height, .. } => height,
            Scale::Bar => BAR,
            Scale::Section { .. } | Scale::Small { .. } => {
                let (least, most) = if has_no_axes(panel) { SMALL_HEIGHTS } else { HEIGHTS };
                let height = (width * (y.1 - y.0) / (x.1 - x.0)).clamp(least, most);
                // Whichever direction has room to spare shows more of its surroundings, a whole section on both sides.
                let wider = ((y.1 - y.0) * width / height - (x.1 - x.0)).max(0.0);
                let before = if x.0 < 0.0 { 0.5 * wider } else { 0.0 };
                x = (x.0 - before, x.1 + wider - before);
                let more = 0.5 * ((x.1 - x.0) * height / width - (y.1 - y.0)).max(0.0);
                y = (y.0 - more, y.1 + more);
                height
            }
        };
        let flags = Flags::of(panel, x, width);
        // Their labels stand above all else.
        let head = flags.height();
        y.1 += (y.1 - y.0) * head / height;
        let most = if is_small(panel) { ((width / NARROW_TICK) as usize).clamp(2, X_TICKS) } else { X_TICKS };
        Self { height: height + head, x, y, most, flags }
    }

    /// Values of x that are written: round ones, of a scale of colours where colours meet.
    fn x_ticks(&self, panel: &Panel) -> Vec<f64> {
        if panel.scale != Scale::Bar {
            return labelled(&panel.x, self.x, self.most);
        }
        let mut borders: Vec<f64> = panel.series.iter().flat_map(|series| &series.points).map(|p| p.0).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        spread(&borders, X_TICKS)
    }

    /// Draws the panel into its area; `left` is the width of its y labels.
    pub(super) fn draw(&self, panel: &Panel, area: &Canvas, left: f64) {
        // Lengths of a section point down the page.
        let is_section = matches!(panel.scale, Scale::Section { .. } | Scale::Small { .. });
        let y = if is_section { (self.y.1, self.y.0) } else { self.y };
        let (left, below) = if has_no_axes(panel) { (0.0, 0.0) } else { (left, x_labels_height()) };
        let y_count = tick_count(self.height);
        let (x_ticks, y_ticks) = (self.x_ticks(panel), labelled(&panel.y, self.y, y_count));
        let mut chart = ChartBuilder::on(area)
            .set_label_area_size(LabelAreaPosition::Left, units(left))
            .set_label_area_size(LabelAreaPosition::Bottom, units(below))
            .build_cartesian_2d(Ticked::new(self.x, x_ticks.clone()), Ticked::new(y, y_ticks.clone()))
            .expect(NEVER);
        let x_tick = |x: &f64| label(&panel.x, *x, &x_ticks);
        let y_tick = |y: &f64| label(&panel.y, *y, &y_ticks);
        let mut mesh = chart.configure_mesh();
        mesh.x_labels(X_TICKS)
            .x_label_formatter(&x_tick)
            .x_desc(panel.x.text())
            .axis_desc_style(style(LABEL, BLACK))
            .label_style(style(TICK, BLACK))
            .set_all_tick_mark_size(units(TICK_MARK))
            .axis_style(stroke(BLACK, AXIS))
            .bold_line_style(stroke(GRID_COLOR, GRID))
            .max_light_lines(0);
        if panel.scale == Scale::Bar {
            mesh.disable_mesh().disable_y_axis();
        } else {
            mesh.y_labels(y_count).y_label_formatter(&y_tick).y_desc(panel.y.text());
        }
        if !has_no_axes(panel) {
            mesh.draw().expect(NEVER);
        }
        let near = |v: f64, (low, high): (f64, f64)| (v - low).abs() < FAR * (high - low);
        // One without points stands in the legend alone.
        for series in panel.series.iter().filter(|series| !series.points.is_empty()) {
            let points = match series.look {
                Look::Area { .. } | Look::Hatched { .. } => clipped(&series.points, self.x, self.y),
                _ => series.points.clone(),
            };
            let points = points.into_iter().filter(|p| near(p.0, self.x) && near(p.1, self.y)).collect();
            let shape = Shape { look: series.look, label: series.label.as_deref().unwrap_or(""), points };
            chart.draw_series([shape]).expect(NEVER);
        }
        let plot = chart.plotting_area().strip_coord_spec();
        let (width, height) = plot.dim_in_pixel();
        let up = |y: f64| (1.0 - (y - self.y.0) / (self.y.1 - self.y.0)) * self.height;
        self.flags.draw(&plot, up, self.height);
        let corners = [(0, 0), (width as i32, height as i32)];
        plot.draw(&Rectangle::new(corners, stroke(BLACK, AXIS))).expect(NEVER);
    }
}

/// Whether a panel stands beside others.
pub(super) fn is_small(panel: &Panel) -> bool {
    matches!(panel.scale, Scale::Small { .. } | Scale::Multiple { .. })
}

/// Whether it is a picture without axes.
pub(super) fn has_no_axes(panel: &Panel) -> bool {
    matches!(panel.scale, Scale::Small { .. })
}

/// Values that are written along an axis: round ones, or where its names stand.
fn labelled(axis: &Axis, range: (f64, f64), most: usize) -> Vec<f64> {
    match axis.names() {
        [] if axis.spacing().is_logarithmic() => decades(range, most),
        [] => ticks(range, most),
        names => (0..names.len()).map(|i| i as f64).collect(),
    }
}

/// What is written at a value.
fn label(axis: &Axis, value: f64, all: &[f64]) -> String {
    match axis.names() {
        [] if axis.spacing().is_logarithmic() => {
            let value = axis.spacing().value(value);
            tick(value, &[value])
        }
        [] => tick(value, all),
        names => names.get(value.round() as usize).cloned().unwrap_or_default(),
    }
}

pub(super) fn x_labels_height() -> f64 {
    TICK_MARK + SPACING * (TICK + LABEL) + 4.0
}

pub(super) fn y_labels_width(range: &(f64, f64), panel: &Panel) -> f64 {
    let height = match panel.scale {
        Scale::Fit { height, .. } | Scale::Window { height, .. } | Scale::Multiple { height, .. } => height,
        Scale::Section { .. } => 400.0,
        // No labels beside it, but half of the first one below.
        Scale::Bar => {
            let first = panel.ranges()[0].0;
            return 0.5 * text_width(&label(&panel.x, first, &[first]), TICK);
        }
        Scale::Small { .. } => return 0.0,
    };
    let values = labelled(&panel.y, *range, tick_count(height));
    let widest = values.iter().map(|v| text_width(&label(&panel.y, *v, &values), TICK)).fold(0.0, f64::max);
    SPACING * LABEL + widest + TICK_MARK + 14.0
}

#[cfg(test)]
mod tests {
    use super::super::drawing::Drawing;
    use super::super::mark::Mark;
    use crate::plot::chart::{Chart, Look, Panel, Scale, Series};
    use crate::table::{Column, Unit};

    /// Trust: points that lie inside by hand; what is no number, or too large for one axis with them, is left out.
    #[test]
    fn what_can_be_drawn_is_drawn_inside_the_axes() {
        let axis = Column::new("x", "X", Unit::Mm, vec![]).axis();
        let points = vec![(0.0, 0.0), (f64::NAN, 1.0), (5.0, -2.0), (1e308, -1e308), (f64::INFINITY, 0.0), (10.0, 4.0)];
        for scale in [Scale::Fit { height: 200.0, least: 0.0 }, Scale::Section { x: (0.0, 10.0), y: (-2.0, 4.0) }] {
            let series = vec![Series::silent(points.clone(), Look::Line { color: (9, 9, 9), width: 2.0, dash: &[] })];
            let panels = vec![Panel { x: axis.clone(), y: axis.clone(), series, scale }];
            let drawing =
                Drawing::of(&Chart { title: String::new(), legend: String::new(), panels, notes: vec![] }, 800.0);
            let line = drawing.marks.iter().find_map(|mark| match mark {
                Mark::Line { pieces, color: (9, 9, 9), width } if *width == 2.0 => Some(&pieces[0]),
                _ => None,
            });
            let line = line.expect("the line is drawn");
            assert!(line.len() == 3 && line.iter().all(|p| p.0 > 0.0 && p.0 < 800.0 && p.1 > 0.0), "{line:?}");
            let down = line[1].1 > line[0].1;
            assert!(down == matches!(scale, Scale::Fit { .. }) && line[1].0 > line[0].0, "{line:?}");
        }
    }
}
