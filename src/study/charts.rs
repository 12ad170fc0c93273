//! Charts of studies: numbers over a variable, process windows, tornado, search trials, histograms.

use super::scatter::UncertaintyResult;
use super::sweep::{Axis as SweepAxis, End, Sensitivity, Sweep};
use super::variable::Variable;
use super::{FailureMode, Run, RunTable};
use crate::plot::chart::{Annotation, AnnotationKind, Chart, Color, Panel, Scale, Series, Style};
use crate::plot::palette::{BLACK, GREY, color, pale};
use crate::table::{Axis, Spacing};
use crate::units::{Sense, Unit};
use crate::verification::Origin;
use contour::ContourBuilder;

/// Responses by their importance.
const FIRST: [(Origin, &str); 12] = [
    (Origin::Verdict, "thinning"),
    (Origin::Answer, "punch_force"),
    (Origin::Answer, "pressure"),
    (Origin::Answer, "draw_in"),
    (Origin::Verdict, "wrinkling"),
    (Origin::Answer, "part_height"),
    (Origin::Answer, "holder_force"),
    (Origin::Verdict, "forming_limit"),
    (Origin::Answer, "ring_opening"),
    (Origin::Verdict, "springback"),
    (Origin::Part, "thickest"),
    (Origin::Verdict, "energy"),
];
/// A number varies if it spans more than this share of its largest value \[–\].
const VARIES: f64 = 2e-3;
/// Least span of an axis over the largest value \[–\].
const LEAST: f64 = 0.02;
const PANELS: usize = 5;
const BINS: usize = 24;
const OWN: Style = Style::Line { color: BLACK, width: 1.6, dash: &[5.0, 4.0] };

/// Places of the most important responses that vary.
pub(super) fn deciding(runs: &RunTable, most: usize) -> Vec<usize> {
    let place = |(origin, key): (Origin, &str)| {
        runs.responses.iter().position(|r| r.number.origin == origin && r.number.quantity.key == key)
    };
    let varies = |place: &usize| {
        let values = runs.runs.iter().filter(|run| run.is_known()).map(|run| run.numbers[*place]);
        let (low, high) = span(values);
        high.abs().max(low.abs()) * VARIES < high - low
    };
    FIRST.into_iter().filter_map(place).filter(varies).take(most).collect()
}

/// Chart of a sweep over one to three axes with several values.
pub(super) fn sweep(sweep: &Sweep, runs: &RunTable) -> Option<Chart> {
    let wide: Vec<usize> = (0..sweep.axes().len()).filter(|i| sweep.axes()[*i].count() > 1).collect();
    let panels = match wide[..] {
        [x] => over_variable(&sweep.axes()[x], runs),
        [x, y] => vec![window(sweep, runs, [x, y], &|_| true, String::new())],
        [x, y, z] => {
            let axis = &sweep.axes()[z];
            let panel = |i: usize| {
                let caption = format!("{} {}", axis.variables[0].label(), axis.display(i));
                window(sweep, runs, [x, y], &|run| sweep.places(run.index)[z] == Some(i), caption)
            };
            (0..axis.count()).map(panel).collect()
        }
        _ => return None,
    };
    (!panels.is_empty()).then(|| chart(panels))
}

fn chart(mut panels: Vec<Panel>) -> Chart {
    for mode in FailureMode::ALL {
        let has =
            |panel: &Panel| panel.series.iter().any(|series| series.style == marker(mode) && !series.points.is_empty());
        if panels.iter().any(has) {
            panels[0].series.push(Series::new(mode.label(), Vec::new(), marker(mode)));
        }
    }
    Chart::new("", panels, Vec::new())
}

/// Marker of a failure mode.
fn marker(mode: FailureMode) -> Style {
    let color: Color = match mode {
        FailureMode::Tears => color(1),
        FailureMode::Wrinkles => color(0),
        FailureMode::Press => color(3),
        FailureMode::Other => color(4),
        FailureMode::NoResult => GREY,
    };
    Style::Dots { color }
}

fn markers(points: &[((f64, f64), &Run)]) -> Vec<Series> {
    let of = |mode: Option<FailureMode>| {
        points.iter().filter(move |(_, run)| run.failures.first().copied() == mode).map(|(point, _)| *point).collect()
    };
    let failed = FailureMode::ALL.map(|mode| Series::silent(of(Some(mode)), marker(mode)));
    let sound = Series::silent(of(None), Style::Dots { color: color(2) });
    failed.into_iter().chain([sound]).filter(|series| !series.points.is_empty()).collect()
}

fn axis_of(axis: &SweepAxis) -> Axis {
    let label = axis.variables[0].label();
    match axis.names()[..] {
        [] => Axis::named(label, axis.unit()),
        ref names => Axis::of_names(label, names.iter().map(|name| (*name).to_owned()).collect()),
    }
}

/// The deciding numbers over one variable, with their error bands.
fn over_variable(axis: &SweepAxis, runs: &RunTable) -> Vec<Panel> {
    let positions = axis.positions();
    let mut order: Vec<usize> = (0..runs.runs.len().min(positions.len())).collect();
    order.sort_by(|a, b| positions[*a].total_cmp(&positions[*b]));
    let panel = |(i, place): (usize, usize)| {
        let response = &runs.responses[place];
        let known = order.iter().map(|i| (positions[*i], &runs.runs[*i]));
        let known: Vec<(f64, &Run)> =
            known.filter(|(_, run)| run.is_known() && run.numbers[place].is_finite()).collect();
        let curve: Vec<(f64, f64)> = known.iter().map(|(x, run)| (*x, run.numbers[place])).collect();
        let mut series = Vec::new();
        if axis.names().is_empty() {
            series.push(Series::silent(curve.clone(), Style::Line { color: color(2), width: 2.4, dash: &[] }));
        }
        let points: Vec<((f64, f64), &Run)> =
            curve.iter().zip(&known).map(|(point, (_, run))| (*point, *run)).collect();
        series.extend(markers(&points));
        if let Some((red, (low, high))) = response.limits.and_then(|limits| limits.red).zip(ends(&curve)) {
            series.push(Series::silent(vec![(low, red), (high, red)], OWN));
        }
        if let Some(own) = axis.own.filter(|_| runs.base.numbers[place].is_finite()) {
            let point = vec![(own, runs.base.numbers[place])];
            series.push(Series::silent(point, Style::Circles { color: BLACK }));
        }
        let largest = curve.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
        let y = Axis::named(response.number.quantity.label, response.number.quantity.amount.unit);
        let height = if i == 0 { 230.0 } else { 150.0 };
        let panel = Panel::fit(axis_of(axis), y, height, LEAST * largest).with(series);
        let half = |run: &Run| run.errors.get(place).copied().filter(|half| half.is_finite());
        let halves: Option<Vec<f64>> = known.iter().map(|(_, run)| half(run)).collect();
        match halves.filter(|halves| halves.len() > 1) {
            None => panel,
            Some(halves) => {
                let x: Vec<f64> = curve.iter().map(|point| point.0).collect();
                let side = |sign: f64| curve.iter().zip(&halves).map(|(p, h)| p.1 + sign * h).collect::<Vec<f64>>();
                let label = if i == 0 { "Error band" } else { "" };
                panel.with_band(label, &x, [&side(-1.0), &side(1.0)], color(2))
            }
        }
    };
    deciding(runs, PANELS).into_iter().enumerate().map(panel).collect()
}

/// Process window: contour lines of each deciding number at its limit, over the designs.
fn window(sweep: &Sweep, runs: &RunTable, [x, y]: [usize; 2], counts: &dyn Fn(&Run) -> bool, caption: String) -> Panel {
    let axes = [x, y].map(|i| &sweep.axes()[i]);
    let positions = axes.map(SweepAxis::positions);
    let [columns, rows] = axes.map(SweepAxis::count);
    let mut grid: Vec<Option<&Run>> = vec![None; columns * rows];
    let mut points = Vec::new();
    for run in runs.runs.iter().filter(|run| counts(run)) {
        let places = sweep.places(run.index);
        let (Some(i), Some(j)) = (places[x], places[y]) else { continue };
        grid[j * columns + i] = Some(run);
        points.push(((positions[0][i], positions[1][j]), run));
    }
    let mut series = markers(&points);
    let limited = runs.responses.iter().enumerate().filter_map(|(place, response)| {
        let limits = response.limits.filter(|_| response.number.origin == Origin::Verdict)?;
        Some((place, limits.red?, limits.sense))
    });
    for (n, (place, limit, sense)) in limited.enumerate() {
        let beyond = if sense == Sense::AtMost { 2.0 * limit.abs() } else { -2.0 * limit.abs() };
        let value = |run: &Option<&Run>| run.map_or(f64::NAN, |run| run.numbers[place]);
        // Runs without the number count as beyond the limit.
        let values: Vec<f64> = grid.iter().map(value).map(|v| if v.is_finite() { v } else { limit + beyond }).collect();
        for line in lines(&values, [columns, rows], limit) {
            let at = |(u, v): (f64, f64)| (between(&positions[0], u), between(&positions[1], v));
            let points: Vec<(f64, f64)> = line.into_iter().map(at).collect();
            let label = format!("{} at its limit", runs.responses[place].number.quantity.label);
            let is_first = !series.iter().any(|s: &Series| s.label.as_deref() == Some(label.as_str()));
            series.push(Series { label: is_first.then_some(label), points, style: Style::curve(n) });
        }
    }
    if let Some(own) = axes[0].own.zip(axes[1].own) {
        series.push(Series::new("the case as it stands", vec![own], Style::Triangles { color: BLACK }));
    }
    let [along, up] = positions.map(|positions| {
        let (low, high) = span(positions.iter().copied());
        let paper = 0.03 * (high - low);
        (low - paper, high + paper)
    });
    let height = if caption.is_empty() { 430.0 } else { 270.0 };
    let scale = Scale::Window { height, x: along, y: up };
    let panel = Panel::new(axis_of(axes[0]), axis_of(axes[1]), scale).with(series);
    Panel { is_small: !caption.is_empty(), caption, ..panel }
}

/// Contour lines of values on a grid, in grid coordinates from 0.
fn lines(values: &[f64], [columns, rows]: [usize; 2], level: f64) -> Vec<Vec<(f64, f64)>> {
    let builder = ContourBuilder::new(columns, rows, true);
    let Ok(lines) = builder.lines(values, &[level]) else { return Vec::new() };
    let rings = lines.into_iter().flat_map(|line| line.into_inner().0.0);
    let (right, top) = ((columns - 1) as f64, (rows - 1) as f64);
    // The builder closes lines along the border of the grid.
    let is_inside = |(u, v): &(f64, f64)| *u > 0.0 && *u < right && *v > 0.0 && *v < top;
    rings
        .flat_map(|ring| {
            let points: Vec<(f64, f64)> =
                ring.coords().map(|c| ((c.x - 0.5).clamp(0.0, right), (c.y - 0.5).clamp(0.0, top))).collect();
            let is_border =
                |a: &(f64, f64), b: &(f64, f64)| !is_inside(a) && !is_inside(b) && (a.0 == b.0 || a.1 == b.1);
            let stretches: Vec<Vec<(f64, f64)>> =
                points.chunk_by(|a, b| !is_border(a, b)).map(<[(f64, f64)]>::to_vec).collect();
            stretches
        })
        .filter(|line| line.len() > 1)
        .collect()
}

/// Value between the entries of a list at a fractional place.
fn between(values: &[f64], place: f64) -> f64 {
    let below = (place.floor().max(0.0) as usize).min(values.len() - 1);
    let above = (below + 1).min(values.len() - 1);
    values[below] + (place - below as f64) * (values[above] - values[below])
}

/// Bars of every variable's effect on the deciding numbers, the largest on top.
pub(super) fn tornado(sweep: &Sweep, runs: &RunTable) -> Option<Chart> {
    let panel = |place: usize| {
        let all: Vec<Sensitivity> = sweep.sensitivities(runs, place).into_iter().take(12).collect();
        let own = all.first()?.own;
        let number = &runs.responses[place].number;
        let (low, high) = span(all.iter().flat_map(|s| s.ends.iter().map(|end| end.number)).chain([own]));
        let room = 0.25 * (high - low);
        let count = all.len();
        let (mut series, mut labels) = (Vec::new(), Vec::new());
        for (i, s) in all.iter().enumerate() {
            let y = (count - 1 - i) as f64;
            let Some([least, most]) = s.extremes() else { continue };
            for (end, fill) in [(least, pale(color(0))), (most, color(1))] {
                if end.number != own {
                    let outline = [(own, -0.34), (end.number, -0.34), (end.number, 0.34), (own, 0.34)];
                    let outline = outline.map(|(x, dy)| (x, y + dy)).to_vec();
                    series.push(Series::silent(outline, Style::Area { fill, edge: Some((70, 70, 70)) }));
                    let kind = if end.number < own { AnnotationKind::End } else { AnnotationKind::Start };
                    labels.push(Annotation::new(kind, end_label(sweep, s, end), (end.number, y)));
                }
            }
        }
        series.push(Series::silent(vec![(own, -0.6), (own, count as f64 - 0.4)], OWN));
        let names = all.iter().rev().map(|s| sweep.axes()[s.axis].variables[0].label()).collect();
        let height = 34.0 * count as f64 + 12.0;
        let scale = Scale::Window { height, x: (low - room, high + room), y: (-0.6, count as f64 - 0.4) };
        let x = Axis::named(number.quantity.label, number.quantity.amount.unit);
        Some(Panel::new(x, Axis::of_names("", names), scale).with(series).annotated(labels))
    };
    let panels: Vec<Panel> = deciding(runs, 4).into_iter().filter_map(panel).collect();
    (!panels.is_empty()).then(|| chart(panels))
}

fn end_label(sweep: &Sweep, sensitivity: &Sensitivity, end: End) -> String {
    let value = sweep.axes()[sensitivity.axis].display(end.place);
    if end.is_sound { value } else { format!("{value} (fails)") }
}

/// Trials of a search: the asked quantities, or the most important number, over the variable.
pub(super) fn search(
    variable: &Variable,
    spacing: Spacing,
    runs: &RunTable,
    limits: &[(usize, f64)],
    best: Option<usize>,
) -> Option<Chart> {
    let (unit, factor) = variable.axis_unit();
    let mut asked: Vec<(usize, Option<f64>)> = limits.iter().map(|(place, limit)| (*place, Some(*limit))).collect();
    if asked.is_empty() {
        asked.extend(deciding(runs, 1).into_iter().map(|place| (place, None)));
    }
    let panel = |(place, limit): (usize, Option<f64>)| {
        let number = &runs.responses[place].number;
        let known = runs.runs.iter().filter(|run| run.is_known() && run.numbers[place].is_finite());
        let points: Vec<((f64, f64), &Run)> =
            known.map(|run| ((factor * run.value(0), run.numbers[place]), run)).collect();
        let curve: Vec<(f64, f64)> = points.iter().map(|(point, _)| *point).collect();
        let mut series = markers(&points);
        if let Some((limit, (low, high))) = limit.zip(ends(&curve)) {
            series.push(Series::silent(vec![(low, limit), (high, limit)], OWN));
        }
        if let Some(run) = best.map(|best| &runs.runs[best]) {
            let point = vec![(factor * run.value(0), run.numbers[place])];
            series.push(Series::new("Result", point, Style::Circles { color: BLACK }));
        }
        let largest = curve.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
        let x = Axis::named(variable.label(), unit).spaced(spacing);
        let y = Axis::named(number.quantity.label, number.quantity.amount.unit);
        Panel::fit(x, y, 260.0, LEAST * largest).with(series)
    };
    let panels: Vec<Panel> = asked.into_iter().map(panel).collect();
    (!panels.is_empty()).then(|| chart(panels))
}

/// Histograms of the deciding numbers with their limits.
pub(super) fn scatter(runs: &RunTable, result: &UncertaintyResult) -> Option<Chart> {
    let panel = |place: usize| {
        let spread = result.spreads.iter().find(|spread| spread.response == place)?;
        let (low, high) = span(spread.values.iter().copied());
        let width = (high - low) / BINS as f64;
        if width <= 0.0 {
            return None;
        }
        let mut counts = [0.0; BINS];
        for value in &spread.values {
            counts[(((value - low) / width) as usize).min(BINS - 1)] += 1.0;
        }
        let bar = |(i, count): (usize, &f64)| {
            let (from, to) = (low + i as f64 * width, low + (i + 1) as f64 * width);
            let outline = vec![(from, 0.0), (to, 0.0), (to, *count), (from, *count)];
            Series::silent(outline, Style::Area { fill: pale(color(0)), edge: Some(color(0)) })
        };
        let mut series: Vec<Series> = counts.iter().enumerate().map(bar).collect();
        let top = counts.iter().copied().fold(0.0, f64::max);
        let response = &runs.responses[place];
        for limit in response.limits.iter().flat_map(|limits| [limits.amber, limits.red]).flatten() {
            if (low - width..=high + width).contains(&limit) {
                series.push(Series::silent(vec![(limit, 0.0), (limit, top)], OWN));
            }
        }
        let x = Axis::named(response.number.quantity.label, response.number.quantity.amount.unit);
        Some(Panel::fit(x, Axis::named("Parts", Unit::None), 180.0, 1.0).with(series))
    };
    let panels: Vec<Panel> = deciding(runs, 4).into_iter().filter_map(panel).collect();
    (!panels.is_empty()).then(|| chart(panels))
}

fn span(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

fn ends(curve: &[(f64, f64)]) -> Option<(f64, f64)> {
    (!curve.is_empty()).then(|| span(curve.iter().map(|point| point.0)))
}
