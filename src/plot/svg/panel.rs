//! One pair of axes: ranges, ticks, labels and series.

use super::shapes::{clipped, pen};
use super::text::{LABEL, SPACING, TICK, clean, style, width};
use super::ticks::{Ticked, label, tick_count, values};
use super::{annotations::Flags, *};
use plotters::chart::{ChartBuilder, LabelAreaPosition};

const X_TICKS: usize = 8;
const NARROW_TICK: f64 = 70.0;
const TICK_MARK: f64 = 6.0;
pub(super) const X_LABELS_HEIGHT: f64 = TICK_MARK + SPACING * (TICK + LABEL) + 4.0;
const AXIS: f64 = 1.2;
const GRID: f64 = 0.8;
const GRID_COLOR: Color = (215, 215, 215);
const HEIGHTS: (f64, f64) = (290.0, 560.0);
const SMALL_HEIGHTS: (f64, f64) = (110.0, 320.0);
const BAR_HEIGHT: f64 = 18.0;
/// Points farther away than so many widths of the panel would overflow plotters' units.
const FAR: f64 = 1e3;

pub(super) struct Frame {
    pub(super) height: f64,
    x: (f64, f64),
    y: (f64, f64),
    most_ticks: usize,
    flags: Flags,
}

impl Frame {
    pub(super) fn new(panel: &Panel, width: f64) -> Self {
        let [mut x, mut y] = panel.ranges();
        let height = match panel.scale {
            Scale::Fit { height, .. } | Scale::Window { height, .. } => height,
            Scale::Bar => BAR_HEIGHT,
            Scale::Section { .. } => {
                let (least, most) = if panel.is_small { SMALL_HEIGHTS } else { HEIGHTS };
                let height = (width * (y.1 - y.0) / (x.1 - x.0)).clamp(least, most);
                // The direction with room to spare shows more surroundings, a whole section on both sides.
                let wider = ((y.1 - y.0) * width / height - (x.1 - x.0)).max(0.0);
                let before = if x.0 < 0.0 { 0.5 * wider } else { 0.0 };
                x = (x.0 - before, x.1 + wider - before);
                let more = 0.5 * ((x.1 - x.0) * height / width - (y.1 - y.0)).max(0.0);
                y = (y.0 - more, y.1 + more);
                height
            }
        };
        let flags = Flags::new(panel, x, width);
        let head = flags.height();
        let more = (y.1 - y.0) * head / height;
        let y = if panel.is_section() { (y.0 - more, y.1) } else { (y.0, y.1 + more) };
        let most_ticks = if panel.is_small { ((width / NARROW_TICK) as usize).clamp(2, X_TICKS) } else { X_TICKS };
        Self { height: height + head, x, y, most_ticks, flags }
    }

    fn x_ticks(&self, panel: &Panel) -> Vec<f64> {
        if panel.scale != Scale::Bar {
            return values(&panel.x, self.x, self.most_ticks);
        }
        let mut borders: Vec<f64> = panel.series.iter().flat_map(|series| &series.points).map(|p| p.0).collect();
        borders.sort_by(f64::total_cmp);
        borders.dedup();
        let colors = borders.len() - 1;
        let step = (self.x.1 - self.x.0) * colors.div_ceil(X_TICKS) as f64 / colors as f64;
        borders.retain(|border| (border / step).fract().abs() < 1e-6);
        borders
    }

    pub(super) fn draw(&self, panel: &Panel, area: &Canvas, left: f64) {
        let is_section = panel.is_section();
        let y = if is_section { (self.y.1, self.y.0) } else { self.y };
        let (left, below) = if panel.has_no_axes() { (0.0, 0.0) } else { (left, X_LABELS_HEIGHT) };
        let y_count = tick_count(self.height);
        let (x_ticks, y_ticks) = (self.x_ticks(panel), values(&panel.y, self.y, y_count));
        let mut chart = ChartBuilder::on(area)
            .set_label_area_size(LabelAreaPosition::Left, units(left))
            .set_label_area_size(LabelAreaPosition::Bottom, units(below))
            .build_cartesian_2d(Ticked(self.x, x_ticks.clone()), Ticked(y, y_ticks.clone()))
            .expect(IN_MEMORY);
        let x_tick = |x: &f64| clean(&label(&panel.x, *x, &x_ticks));
        let y_tick = |y: &f64| clean(&label(&panel.y, *y, &y_ticks));
        let mut mesh = chart.configure_mesh();
        mesh.x_labels(X_TICKS)
            .x_label_formatter(&x_tick)
            .x_desc(clean(&panel.x.text()))
            .axis_desc_style(style(LABEL, BLACK))
            .label_style(style(TICK, BLACK))
            .set_all_tick_mark_size(units(TICK_MARK))
            .axis_style(pen(BLACK, AXIS))
            .bold_line_style(pen(GRID_COLOR, GRID))
            .max_light_lines(0);
        if panel.scale == Scale::Bar {
            mesh.disable_mesh().disable_y_axis();
        } else {
            mesh.y_labels(y_count).y_label_formatter(&y_tick).y_desc(clean(&panel.y.text()));
        }
        if !panel.has_no_axes() {
            mesh.draw().expect(IN_MEMORY);
        }
        let plot = chart.plotting_area().strip_coord_spec();
        let (width, height) = plot.dim_in_pixel();
        let (width, height) = (f64::from(width) / FINE, f64::from(height) / FINE);
        let share = |v: f64, (low, high): (f64, f64)| (v - low) / (high - low);
        let y_px = |v: f64| height * if is_section { share(v, self.y) } else { 1.0 - share(v, self.y) };
        let to_px = |p: (f64, f64)| (width * share(p.0, self.x), y_px(p.1));
        let near = |v: f64, range: (f64, f64)| share(v, range).abs() < FAR;
        for series in &panel.series {
            let is_area = matches!(series.style, Style::Area { .. });
            let points = if is_area { clipped(&series.points, self.x, self.y) } else { series.points.clone() };
            let points = points.into_iter().filter(|p| near(p.0, self.x) && near(p.1, self.y)).map(to_px);
            let points: Vec<(f64, f64)> = points.collect();
            if !points.is_empty() {
                shapes::draw(&plot, series.style, &points);
            }
        }
        self.flags.draw(&plot, y_px, height, is_section);
        annotations::draw(&plot, panel, to_px);
        shapes::line(&plot, &[(0.0, 0.0), (width, 0.0), (width, height), (0.0, height), (0.0, 0.0)], BLACK, AXIS);
    }
}

pub(super) fn y_labels_width(panel: &Panel) -> f64 {
    let [x, y] = panel.ranges();
    let height = match panel.scale {
        Scale::Fit { height, .. } | Scale::Window { height, .. } => height,
        // No labels beside it, but half of the first one below.
        Scale::Bar => return 0.5 * width(&label(&panel.x, x.0, &[x.0]), TICK),
        Scale::Section { .. } if panel.is_small => return 0.0,
        Scale::Section { .. } => 400.0,
    };
    let values = values(&panel.y, y, tick_count(height));
    let widest = values.iter().map(|v| width(&label(&panel.y, *v, &values), TICK)).fold(0.0, f64::max);
    SPACING * LABEL + widest + TICK_MARK + 14.0
}

#[cfg(test)]
#[test]
fn points_that_can_be_drawn_lie_inside_the_axes() {
    use crate::plot::chart::{Chart, Series};
    let axis = crate::plot::Axis::named("X", crate::table::Unit::Mm);
    let points = vec![(0.0, 0.0), (f64::NAN, 1.0), (5.0, -2.0), (1e308, -1e308), (f64::INFINITY, 0.0), (10.0, 4.0)];
    let panel = Panel::fit(axis.clone(), axis, 200.0, 0.0).with([Series::silent(points, Style::solid((9, 9, 9), 2.0))]);
    let svg = super::svg(&Chart::new("", vec![panel], Vec::new()));
    let line = svg.lines().find(|line| line.contains("#090909")).expect("the line is drawn");
    let points = line.split("points=\"").nth(1).expect("points").split('"').next().expect("an end");
    let numbers: Vec<f64> = points.split([' ', ',']).filter_map(|number| number.parse().ok()).collect();
    assert!(numbers.len() == 6 && numbers.iter().all(|v| (0.0..6400.0).contains(v)), "{numbers:?}");
}
