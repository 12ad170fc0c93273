//! Charts of studies: numbers over a variable, process windows, tornado, search trials, histograms.

use super::{run::response_key, *};
use crate::numerics::interpolated;
use crate::plot::chart::{Annotation, AnnotationKind, Color, Panel, Scale, Series, Style, bounds};
use crate::plot::{Axis, palette::BLACK, palette::GREY, palette::color, palette::pale};
use crate::units::Sense;
use contour::ContourBuilder;

const FIRST: &str = "tearing_judged thinning_judged punch_force pressure draw_in wrinkling_judged part_height \
                     holder_force forming_limit_judged ring_opening springback_judged thickest energy_judged";
/// A number varies if it spans more than this share of its largest value \[–\].
const VARIES: f64 = 2e-3;
/// Least span of an axis over the largest value \[–\].
const LEAST: f64 = 0.02;
const PANELS: usize = 5;
const BINS: usize = 24;
const DASHED: Style = Style::Line { color: BLACK, width: 1.6, dash: &[5.0, 4.0] };

pub(super) type Charts = Vec<(String, Chart)>;

pub(super) fn decisive(runs: &RunTable, most: usize) -> Vec<usize> {
    let place = |key: &str| runs.responses.iter().position(|response| response_key(response) == key);
    let varies = |place: &usize| {
        let (low, high) = bounds(runs.runs.iter().filter(|run| run.is_known()).map(|run| run.numbers[*place]));
        high.abs().max(low.abs()) * VARIES < high - low
    };
    FIRST.split_whitespace().filter_map(place).filter(varies).take(most).collect()
}

pub(super) fn chart(name: &str, title: &str, mut panels: Vec<Panel>) -> Charts {
    let mut labels = BTreeSet::new();
    for series in panels.iter_mut().flat_map(|panel| &mut panel.series) {
        series.label = series.label.take().filter(|label| labels.insert(label.clone()));
    }
    if panels.is_empty() { Vec::new() } else { vec![(name.to_owned(), Chart::new(title, panels, Vec::new()))] }
}

pub(super) fn sweep(sweep: &Sweep, runs: &RunTable) -> Charts {
    let wide: Vec<usize> = (0..sweep.axes.len()).filter(|i| sweep.axes[*i].positions.len() > 1).collect();
    let panels = match wide[..] {
        [x] => {
            let (axis, limits) = (&sweep.axes[x], |place: usize| runs.responses[place].quantity.limits);
            let numbers = decisive(runs, PANELS).into_iter().map(|place| (place, limits(place).and_then(|l| l.red)));
            let positions = axis.positions.iter().copied().zip(&runs.runs).collect();
            trends(runs, &axis.drawn, positions, numbers.collect(), axis.own.map(|own| (own, &runs.base)), None)
        }
        [x, y] => vec![window(sweep, runs, [x, y])],
        _ => Vec::new(),
    };
    let labels: Vec<String> = wide.iter().map(|i| sweep.axes[*i].drawn.label.clone()).collect();
    chart("sweep", &format!("Sweep: {}", labels.join(" × ")), panels)
}

fn markers(points: &[((f64, f64), &Run)]) -> Vec<Series> {
    let is_amber = |run: &Run| run.failures.is_empty() && run.light == Some(Light::Amber);
    let dots = |mode: Option<FailureMode>| {
        let color = mode.map_or(color(2), |mode| [color(1), color(0), color(3), color(4), GREY][mode as usize]);
        let own = points.iter().filter(|(_, run)| run.failures.first().copied() == mode && !is_amber(run));
        let label = mode.map_or("sound", FailureMode::label);
        Series::new(label, own.map(|(point, _)| *point).collect(), Style::Dots { color })
    };
    let modes = FailureMode::ALL.map(Some).into_iter().chain([None]);
    let amber = points.iter().filter(|(_, run)| is_amber(run)).map(|(point, _)| *point).collect();
    let amber = Series::new("sound, amber", amber, Style::Circles { color: color(2) });
    modes.map(dots).chain([amber]).filter(|series| !series.points.is_empty()).collect()
}

pub(super) fn trends(
    runs: &RunTable, x: &Axis, mut positions: Vec<(f64, &Run)>, numbers: Vec<(usize, Option<f64>)>,
    circled: Option<(f64, &Run)>, label: Option<&str>,
) -> Vec<Panel> {
    positions.sort_by(|a, b| a.0.total_cmp(&b.0));
    let panel = |(i, (place, limit)): (usize, (usize, Option<f64>))| {
        let known = positions.iter().filter_map(|(x, run)| Some(((*x, run.response(place)?), *run)));
        let points: Vec<((f64, f64), &Run)> = known.collect();
        let curve: Vec<(f64, f64)> = points.iter().map(|(point, _)| *point).collect();
        let (low, high) = bounds(curve.iter().map(|point| point.0));
        let limit = limit.filter(|_| !curve.is_empty()).map(|y| Series::silent(vec![(low, y), (high, y)], DASHED));
        let largest = curve.iter().map(|point| point.1.abs()).fold(0.0, f64::max);
        let line = (x.names.is_empty() && label.is_none()).then(|| Series::silent(curve, Style::solid(color(2), 2.4)));
        let circle = circled.and_then(|(x, run)| Some(vec![(x, run.response(place)?)]));
        let style = Style::Circles { color: BLACK };
        let circle = circle.map(|points| Series { label: label.map(str::to_owned), points, style });
        let height = if label.is_some() { 260.0 } else { [230.0, 150.0][i.min(1)] };
        let panel = Panel::fit(x.clone(), named(runs, place), height, LEAST * largest);
        panel.with(line).with(markers(&points)).with(limit).with(circle)
    };
    numbers.into_iter().enumerate().map(panel).collect()
}

fn window(sweep: &Sweep, runs: &RunTable, [x, y]: [usize; 2]) -> Panel {
    let axes = [x, y].map(|i| &sweep.axes[i]);
    let [along, up] = axes.map(|axis| &axis.positions);
    let [columns, rows] = [along, up].map(|all| (0..).map(f64::from).zip(all.iter().copied()).collect::<Vec<_>>());
    let mut grid: Vec<Option<&Run>> = vec![None; along.len() * up.len()];
    let mut points = Vec::new();
    for run in &runs.runs {
        let places = sweep.positions(run.index);
        let (Some(i), Some(j)) = (places[x], places[y]) else { continue };
        grid[j * along.len() + i] = Some(run);
        points.push(((along[i], up[j]), run));
    }
    let mut series = markers(&points);
    let judged = runs.responses.iter().enumerate().filter(|(_, response)| response.origin == Origin::Verdict);
    let limited =
        judged.filter_map(|(place, r)| Some((place, r.quantity.label, r.quantity.limits?, r.quantity.limits?.red?)));
    for (n, (place, label, limits, limit)) in limited.enumerate() {
        // Runs without the number count as beyond the limit.
        let beyond = limit + limit.abs() * if limits.sense == Sense::AtMost { 2.0 } else { -2.0 };
        let value = |run: &Option<&Run>| run.map(|run| run.numbers[place]).filter(|value| value.is_finite());
        let values: Vec<f64> = grid.iter().map(|run| value(run).unwrap_or(beyond)).collect();
        for line in contour_lines(&values, [along.len(), up.len()], limit) {
            let points = line.into_iter().map(|(u, v)| (interpolated(&columns, u), interpolated(&rows, v))).collect();
            series.push(Series::new(format!("{label} at its limit"), points, Style::curve(n)));
        }
    }
    let own = axes[0].own.zip(axes[1].own);
    series.extend(own.map(|own| Series::new("the case as it stands", vec![own], Style::Triangles { color: BLACK })));
    let [x, y] = [along, up].map(|positions| {
        let (low, high) = bounds(positions.iter().copied());
        (low - 0.03 * (high - low), high + 0.03 * (high - low))
    });
    Panel::new(axes[0].drawn.clone(), axes[1].drawn.clone(), Scale::Window { height: 430.0, x, y }).with(series)
}

fn contour_lines(values: &[f64], [columns, rows]: [usize; 2], level: f64) -> Vec<Vec<(f64, f64)>> {
    let Ok(lines) = ContourBuilder::new(columns, rows, true).lines(values, &[level]) else { return Vec::new() };
    let (right, top) = ((columns - 1) as f64, (rows - 1) as f64);
    // The builder closes lines along the border of the grid.
    let is_inside = |(u, v): &(f64, f64)| *u > 0.0 && *u < right && *v > 0.0 && *v < top;
    let is_border = |a: &(f64, f64), b: &(f64, f64)| !is_inside(a) && !is_inside(b) && (a.0 == b.0 || a.1 == b.1);
    let mut all = Vec::new();
    for ring in lines.into_iter().flat_map(|line| line.into_inner().0.0) {
        let points: Vec<(f64, f64)> =
            ring.coords().map(|c| ((c.x - 0.5).clamp(0.0, right), (c.y - 0.5).clamp(0.0, top))).collect();
        all.extend(points.chunk_by(|a, b| !is_border(a, b)).filter(|line| line.len() > 1).map(<[_]>::to_vec));
    }
    all
}

pub(super) fn tornado(sweep: &Sweep, runs: &RunTable) -> Charts {
    let panel = |place: usize| {
        let all: Vec<_> = sweep.sensitivities(runs, place).into_iter().take(12).collect();
        let own = all.first()?.own;
        let (low, high) = bounds(all.iter().flat_map(|s| s.extremes.map(|end| end.number)).chain([own]));
        let room = 0.25 * (high - low);
        let (mut series, mut labels) = (Vec::new(), Vec::new());
        for (y, s) in (0..all.len()).rev().map(|y| y as f64).zip(&all) {
            for (end, fill) in s.extremes.into_iter().zip([pale(color(0)), color(1)]) {
                if end.number != own {
                    series.push(bar((own, end.number), (y - 0.34, y + 0.34), fill, (70, 70, 70)));
                    let kind = if end.number < own { AnnotationKind::End } else { AnnotationKind::Start };
                    let fails = if end.is_sound { "" } else { " (fails)" };
                    let text = sweep.axes[s.axis].labels[end.place].clone() + fails;
                    labels.push(Annotation { at: (end.number, y), text, kind });
                }
            }
        }
        let up = (-0.6, all.len() as f64 - 0.4);
        series.push(Series::silent(vec![(own, up.0), (own, up.1)], DASHED));
        let names = all.iter().rev().map(|s| sweep.axes[s.axis].drawn.label.clone()).collect();
        let scale = Scale::Window { height: 34.0 * all.len() as f64 + 12.0, x: (low - room, high + room), y: up };
        Some(Panel::new(named(runs, place), Axis::of_names("", names), scale).with(series).annotated(labels))
    };
    chart("sweep", "Changes by one key at a time", decisive(runs, 4).into_iter().filter_map(panel).collect())
}

fn bar(x: (f64, f64), y: (f64, f64), fill: Color, edge: Color) -> Series {
    Series::silent(vec![(x.0, y.0), (x.1, y.0), (x.1, y.1), (x.0, y.1)], Style::Area { fill, edge: Some(edge) })
}

pub(super) fn scatter(runs: &RunTable, spreads: &[Spread]) -> Charts {
    let panel = |place: usize| {
        let values = &spreads.iter().find(|spread| spread.response == place)?.values;
        let (low, high) = (values[0], values[values.len() - 1]);
        let width = (high - low) / BINS as f64;
        let mut counts = [0.0; BINS];
        values.iter().for_each(|value| counts[(((value - low) / width) as usize).min(BINS - 1)] += 1.0);
        let from = |i: usize| low + i as f64 * width;
        let bins = counts.iter().enumerate();
        let bars = bins.map(|(i, count)| bar((from(i), from(i + 1)), (0.0, *count), pale(color(0)), color(0)));
        let top = counts.iter().copied().fold(0.0, f64::max);
        let limits = runs.responses[place].quantity.limits.map_or([None; 2], |limits| [limits.amber, limits.red]);
        let limits = limits.into_iter().flatten().filter(|limit| (low - width..=high + width).contains(limit));
        let lines = limits.map(|limit| Series::silent(vec![(limit, 0.0), (limit, top)], DASHED));
        Some(Panel::fit(named(runs, place), Axis::named("Parts", Unit::None), 180.0, 1.0).with(bars).with(lines))
    };
    chart("scatter", "Scatter of the results", decisive(runs, 4).into_iter().filter_map(panel).collect())
}

fn named(runs: &RunTable, place: usize) -> Axis {
    let quantity = &runs.responses[place].quantity;
    Axis::named(quantity.label, quantity.amount.unit)
}
