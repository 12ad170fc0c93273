//! Draws a [`Chart`] as SVG.
//!
//! plotters rounds to whole units, so the canvas is [`FINE`] times larger than the picture, and the SVG's size is
//! then written back with a view box. Lengths below are in px of the picture unless they say "units".

use super::chart::{BLACK, Chart, Color, GREY, Look, Panel, Scale, Series};
use super::font::{self, FAMILY};
use super::outline::{clipped, dashed};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{BoldPoints, Ranged};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use plotters::style::Color as _;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Canvas units per px.
const FINE: f64 = 8.0;
/// Width of every picture; its height follows from what it holds.
pub const WIDTH: f64 = 800.0;
const MARGIN: f64 = 14.0;
const TITLE: f64 = 21.0;
const LABEL: f64 = 19.0;
/// Ticks and legend.
const TICK: f64 = 17.0;
const NOTE: f64 = 13.5;
/// Line spacing over font size.
const SPACING: f64 = 1.3;
/// Width of a line sample in the legend.
const SAMPLE: f64 = 38.0;
/// Below every panel.
const GAP: f64 = 10.0;
const TICK_MARK: f64 = 6.0;

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Nothing fails on the way into a string with a font that is built in.
const NEVER: &str = "drawing into memory with a built-in font";

/// The picture as a standalone SVG, [`WIDTH`] px wide.
pub fn svg(chart: &Chart) -> String {
    font::register();
    let page = Page::of(chart);
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, (units(WIDTH) as u32, units(page.height) as u32));
        let canvas = canvas.into_drawing_area();
        canvas.fill(&WHITE).expect(NEVER);
        page.draw(chart, &canvas);
        canvas.present().expect(NEVER);
    }
    // The first tag states the size in units: state it in px, and let lines join and fonts fall back smoothly.
    let body = svg.split_once('>').map_or("", |(_, body)| body);
    let family = format!("font-family=\"{FAMILY}\"");
    format!(
        "<svg width=\"{WIDTH}\" height=\"{}\" viewBox=\"0 0 {} {}\" stroke-linejoin=\"round\" \
         xmlns=\"http://www.w3.org/2000/svg\">{}",
        page.height,
        units(WIDTH),
        units(page.height),
        body.replace(&family, &format!("font-family=\"{FAMILY}, Verdana, sans-serif\""))
    )
}

/// Where everything goes.
struct Page<'a> {
    title: Vec<String>,
    /// Legend entries with their left edge, row by row.
    legend: Vec<Vec<(&'a Series, f64)>>,
    /// Width left of every panel's axis, so that their axes stand in line.
    left: f64,
    frames: Vec<Frame>,
    notes: Vec<String>,
    height: f64,
}

/// The rectangle and ranges of one panel.
struct Frame {
    height: f64,
    x: (f64, f64),
    y: (f64, f64),
}

impl<'a> Page<'a> {
    fn of(chart: &'a Chart) -> Self {
        let left = chart.panels.iter().map(|p| y_labels_width(&p.ranges()[1], p)).fold(0.0, f64::max);
        let frames: Vec<Frame> = chart.panels.iter().map(|p| Frame::of(p, WIDTH - left - 2.0 * MARGIN)).collect();
        let title = wrapped(&chart.title, TITLE, WIDTH - 2.0 * MARGIN);
        let legend = legend(chart);
        let notes: Vec<String> =
            chart.notes.iter().flat_map(|note| wrapped(note, NOTE, WIDTH - 2.0 * MARGIN)).collect();
        let height = 2.0 * MARGIN
            + SPACING * (TITLE * title.len() as f64 + TICK * legend.len() as f64 + NOTE * notes.len() as f64)
            + frames.iter().map(|f| f.height + x_labels_height() + GAP).sum::<f64>()
            + MARGIN;
        Self { title, legend, left, frames, notes, height: height.ceil() }
    }

    fn draw(&self, chart: &Chart, canvas: &Canvas) {
        let mut y = MARGIN;
        for line in &self.title {
            text(canvas, line, TITLE, BLACK, (MARGIN, y));
            y += SPACING * TITLE;
        }
        y += 0.5 * MARGIN;
        text(canvas, chart.legend, TICK, BLACK, (MARGIN, y));
        for row in &self.legend {
            for (series, x) in row {
                sample(canvas, series.look, (*x, y + 0.5 * TICK));
                text(canvas, series.label.as_deref().unwrap_or(""), TICK, BLACK, (x + SAMPLE + 8.0, y));
            }
            y += SPACING * TICK;
        }
        y += 0.5 * MARGIN;
        for (panel, frame) in chart.panels.iter().zip(&self.frames) {
            let height = frame.height + x_labels_height();
            let area = canvas.clone().shrink((units(MARGIN), units(y)), (units(WIDTH - 2.0 * MARGIN), units(height)));
            draw_panel(canvas, &area, panel, frame, self.left);
            y += height + GAP;
        }
        for line in &self.notes {
            text(canvas, line, NOTE, GREY, (MARGIN, y));
            y += SPACING * NOTE;
        }
    }
}

impl Frame {
    fn of(panel: &Panel, width: f64) -> Self {
        let [mut x, mut y] = panel.ranges();
        let height = match panel.scale {
            Scale::Fit { height } => height,
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
}

fn draw_panel(canvas: &Canvas, area: &Canvas, panel: &Panel, frame: &Frame, left: f64) {
    // Down the page means drawing −y and labelling y.
    let sign = if matches!(panel.scale, Scale::Section { .. }) { -1.0 } else { 1.0 };
    let (bottom, top) = if sign < 0.0 { (-frame.y.1, -frame.y.0) } else { frame.y };
    let mut chart = ChartBuilder::on(area)
        .set_label_area_size(LabelAreaPosition::Left, units(left))
        .set_label_area_size(LabelAreaPosition::Bottom, units(x_labels_height()))
        .build_cartesian_2d(frame.x.0..frame.x.1, bottom..top)
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
    let shapes: Vec<(Look, Vec<(f64, f64)>)> = panel
        .series
        .iter()
        .map(|s| match s.look {
            Look::Area { .. } => (s.look, to_units(&clipped(&s.points, frame.x, frame.y))),
            _ => (s.look, to_units(&s.points)),
        })
        .collect();
    let (x_ticks, y_ticks) = (ticks(frame.x, 8), ticks(frame.y, tick_count(frame.height)));
    chart
        .configure_mesh()
        .x_labels(8)
        .y_labels(tick_count(frame.height))
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
    for (look, points) in &shapes {
        draw_shape(canvas, *look, points);
    }
    let (x, y) = chart.plotting_area().get_pixel_range();
    let border = [(x.start, y.start), (x.end, y.start), (x.end, y.end), (x.start, y.end), (x.start, y.start)];
    canvas.draw(&PathElement::new(border, stroke(BLACK, 1.2))).expect(NEVER);
}

/// A series or a legend sample, points in units.
fn draw_shape(canvas: &Canvas, look: Look, points: &[(f64, f64)]) {
    let whole = |points: &[(f64, f64)]| -> Vec<(i32, i32)> {
        points.iter().map(|p| (p.0.round() as i32, p.1.round() as i32)).collect()
    };
    match look {
        Look::Line { color, width, dash } => {
            let pattern: Vec<f64> = dash.iter().map(|d| d * FINE).collect();
            for piece in dashed(points, &pattern) {
                canvas.draw(&PathElement::new(whole(&piece), stroke(color, width))).expect(NEVER);
            }
        }
        Look::Circles { color } => {
            for at in whole(points) {
                canvas.draw(&Circle::new(at, units(5.0), WHITE.filled())).expect(NEVER);
                canvas.draw(&Circle::new(at, units(5.0), stroke(color, 2.2))).expect(NEVER);
            }
        }
        Look::Area { fill, edge } => {
            let mut outline = whole(points);
            canvas.draw(&Polygon::new(outline.clone(), rgb(fill).filled())).expect(NEVER);
            if let Some(edge) = edge {
                outline.extend(outline.first().copied());
                canvas.draw(&PathElement::new(outline, stroke(edge, 0.8))).expect(NEVER);
            }
        }
    }
}

/// What a series looks like, in the legend; `at` is the middle of its left end.
fn sample(canvas: &Canvas, look: Look, at: (f64, f64)) {
    let (x, y) = (at.0 * FINE, at.1 * FINE);
    let (w, h) = (SAMPLE * FINE, 0.3 * TICK * FINE);
    let points = match look {
        Look::Line { .. } => vec![(x, y), (x + w, y)],
        Look::Circles { .. } => vec![(x + 0.5 * w, y)],
        Look::Area { .. } => {
            vec![(x, y - h), (x + w, y - h), (x + w, y + h), (x, y + h)]
        }
    };
    draw_shape(canvas, look, &points);
}

/// Rows of legend entries, as many side by side as fit.
fn legend(chart: &Chart) -> Vec<Vec<(&Series, f64)>> {
    let mut rows: Vec<Vec<(&Series, f64)>> = Vec::new();
    let indent = if chart.legend.is_empty() { 0.0 } else { text_width(chart.legend, TICK) + 14.0 };
    let left = MARGIN + indent;
    let mut x = f64::INFINITY;
    for series in chart.panels.iter().flat_map(|p| &p.series) {
        let Some(label) = &series.label else { continue };
        let width = SAMPLE + 8.0 + text_width(label, TICK);
        if x + width > WIDTH - MARGIN {
            rows.push(Vec::new());
            x = left;
        }
        rows.last_mut().expect("a row was started").push((series, x));
        x += width + 20.0;
    }
    rows
}

fn x_labels_height() -> f64 {
    TICK_MARK + SPACING * (TICK + LABEL) + 4.0
}

fn y_labels_width(range: &(f64, f64), panel: &Panel) -> f64 {
    let height = if let Scale::Fit { height } = panel.scale { height } else { 400.0 };
    let values = ticks(*range, tick_count(height));
    let widest = values.iter().map(|v| text_width(&tick(*v, &values), TICK)).fold(0.0, f64::max);
    SPACING * LABEL + widest + TICK_MARK + 14.0
}

fn tick_count(height: f64) -> usize {
    ((height / 45.0) as usize).clamp(4, 8)
}

/// The values that plotters will label.
fn ticks(range: (f64, f64), most: usize) -> Vec<f64> {
    RangedCoordf64::from(range.0..range.1).key_points(BoldPoints(most))
}

/// A tick's label: as many decimals as the ticks beside it need, digits in groups of three from 10 000 on.
fn tick(value: f64, all: &[f64]) -> String {
    let decimals = |v: &f64| {
        let text = format!("{v:.6}");
        let tail = text.rsplit_once('.').map_or("", |(_, tail)| tail.trim_end_matches('0'));
        tail.len()
    };
    let text = format!("{:.*}", all.iter().map(decimals).max().unwrap_or(0), value + 0.0);
    let text = if text.trim_start_matches(['-', '0', '.']).is_empty() { text.replace('-', "") } else { text };
    let (whole, tail) = text.split_once('.').map_or((text.as_str(), ""), |(whole, tail)| (whole, tail));
    let digits = whole.trim_start_matches('-');
    let mut grouped = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && digits.len() > 4 && (digits.len() - i) % 3 == 0 {
            grouped.push('\u{2009}');
        }
        grouped.push(digit);
    }
    let minus = if whole.starts_with('-') { "−" } else { "" };
    let point = if tail.is_empty() { "" } else { "." };
    format!("{minus}{grouped}{point}{tail}")
}

/// Lines no wider than `width`, broken between words.
fn wrapped(paragraph: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in paragraph.split_whitespace() {
        let line = lines.last_mut().expect("there is a line");
        let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
        if line.is_empty() || text_width(&longer, size) <= width {
            *line = longer;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

fn text_width(text: &str, size: f64) -> f64 {
    let (width, _) = style(size, BLACK).font.box_size(text).expect(NEVER);
    f64::from(width) / FINE
}

fn text(canvas: &Canvas, text: &str, size: f64, color: Color, at: (f64, f64)) {
    let style = style(size, color).pos(Pos::new(HPos::Left, VPos::Top));
    canvas.draw(&Text::new(text, (units(at.0), units(at.1)), style)).expect(NEVER);
}

/// plotters sizes a font by its line, 1.24 times the em that is meant here.
fn style(size: f64, color: Color) -> TextStyle<'static> {
    FontDesc::new(FontFamily::Name(FAMILY), 1.24 * size * FINE, FontStyle::Normal).color(&rgb(color))
}

fn stroke(color: Color, width: f64) -> ShapeStyle {
    rgb(color).stroke_width(units(width) as u32)
}

fn rgb(color: Color) -> RGBColor {
    RGBColor(color.0, color.1, color.2)
}

fn units(px: f64) -> i32 {
    (px * FINE).round() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_share_their_decimals_and_group_thousands() {
        let all = [0.0, 0.05, 0.1];
        assert_eq!(all.map(|v| tick(v, &all)), ["0.00", "0.05", "0.10"]);
        assert_eq!(tick(-20_000.0, &[0.0, 10_000.0]), "−20\u{2009}000");
        assert_eq!(tick(5000.0, &[5000.0]), "5000");
        assert_eq!(tick(0.1 + 0.2, &[0.1 + 0.2]), "0.3");
        assert_eq!(tick(-0.0, &[0.0]), "0");
    }

    #[test]
    fn long_notes_are_wrapped_between_words() {
        font::register();
        let note = "word ".repeat(60);
        let lines = wrapped(&note, NOTE, 300.0);
        assert!(lines.len() > 3 && lines.iter().all(|line| text_width(line, NOTE) <= 300.0));
        assert_eq!(lines.join(" "), note.trim());
    }
}
