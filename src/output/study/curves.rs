//! A study of one axis: the numbers that decide over it, with their error bands, the zones, and where the case stands.

use super::zones::{AMBER, OWN, entry, ground, lines};
use crate::assess::Light;
use crate::plot::chart::{Chart, Look, Panel, Scale, Series, color};
use crate::study::{Found, Results, Window, Zone};
use crate::table::Axis;

/// Panels at most.
const MOST: usize = 5;
/// Height of the first and of the others \[px\].
const HEIGHTS: [f64; 2] = [230.0, 150.0];
/// Paper before the first design and behind the last, over the panel.
const PAPER: f64 = 0.025;
/// The y axis of a number spans this share of its largest or more \[–\]: a curve that is level looks so.
const LEAST: f64 = 0.02;

/// Panels below each other.
pub(super) fn chart(results: &Results, window: &Window, title: String, notes: Vec<String>) -> Chart {
    let zones: Vec<Zone> = Zone::ALL.into_iter().filter(|zone| is_met(results, *zone)).collect();
    let places = results.deciding(MOST);
    let panels = places.iter().enumerate().map(|(i, place)| panel(results, window, (*place, i == 0), &zones));
    Chart { title, legend: String::new(), panels: panels.collect(), notes }
}

fn is_met(results: &Results, zone: Zone) -> bool {
    results.rows.iter().any(|found| found.fails.contains(&zone))
}

/// One number; the first panel has the legend.
fn panel(results: &Results, window: &Window, (place, is_first): (usize, bool), zones: &[Zone]) -> Panel {
    let axis = &results.axes[window.x];
    let number = results.number(place);
    let mut designs: Vec<(f64, &Found)> =
        axis.values.iter().map(|value| axis.spacing.place(*value)).zip(&results.rows).collect();
    designs.sort_by(|a, b| a.0.total_cmp(&b.0));
    let known: Vec<(f64, f64, f64)> = designs
        .iter()
        .filter(|(_, found)| found.numbers[place].is_finite() && found.is_known())
        .map(|(x, found)| (*x, found.numbers[place], found.bars.get(place).copied().unwrap_or(f64::NAN)))
        .collect();
    let curve: Vec<(f64, f64)> = known.iter().map(|(x, y, _)| (*x, *y)).collect();
    let look = Look::Line { color: color(0), width: 2.4, dash: &[] };
    let mut series = Vec::new();
    if !axis.has_names() {
        series.push(Series::silent(curve.clone(), look));
    }
    series.push(Series::silent(curve, Look::Dots { color: color(0) }));
    let own = axis.own.map(|own| axis.spacing.place(own)).zip(Some(results.base.outcome.numbers[place].amount.value));
    if let Some((x, y)) = own {
        let label = is_first.then(|| String::from("the case as it stands"));
        series.extend(label.map(|label| Series::new(label, vec![(x, y)], Look::Flag)));
        if !is_first {
            series.push(Series::silent(vec![(x, y)], Look::Circles { color: color(6) }));
        }
    }
    let least = LEAST * known.iter().map(|(_, y, _)| y.abs()).fold(0.0, f64::max);
    let height = HEIGHTS[usize::from(!is_first)];
    let y = Axis::named(number.label, number.amount.unit);
    let fit = Panel { x: axis.axis(), y, series, scale: Scale::Fit { height, least } };
    let fit = banded(fit, &known, is_first);
    let [_, up] = fit.ranges();
    let along = window.ranges()[0];
    let paper = PAPER * (along.1 - along.0);
    let along = (along.0 - paper, along.1 + paper);
    let behind = behind(window, zones, up, is_first);
    let mut series = fit.series;
    if let Some((x, _)) = own.filter(|_| !is_first) {
        series.insert(0, Series::silent(vec![(x, up.0), (x, up.1)], OWN));
    }
    let series = behind.into_iter().chain(series).collect();
    Panel { series, scale: Scale::Window { height, x: along, y: up }, ..fit }
}

/// With the error bars of all points, each stretch of points that have them a band.
fn banded(panel: Panel, known: &[(f64, f64, f64)], is_first: bool) -> Panel {
    let mut panel = panel;
    let mut is_told = !is_first;
    for stretch in known.split(|(_, _, half)| !half.is_finite()).filter(|stretch| !stretch.is_empty()) {
        let x: Vec<f64> = stretch.iter().map(|point| point.0).collect();
        let side = |sign: f64| stretch.iter().map(|(_, y, half)| y + sign * half).collect::<Vec<f64>>();
        // An end by itself is a line.
        panel = panel.with_band(String::from("Error band"), &x, [&side(-1.0), &side(1.0)], color(0));
        let told = panel.series.pop();
        panel.series.extend(told.filter(|_| !std::mem::replace(&mut is_told, true)));
    }
    panel
}

/// Zones over the whole height, and where designs are amber.
fn behind(window: &Window, zones: &[Zone], up: (f64, f64), is_first: bool) -> Vec<Series> {
    // Flags stand above the curves: what is behind goes on up there, and is cut at the panel's edge.
    let top = up.1 + (up.1 - up.0);
    let upright = |(from, to): (f64, f64)| vec![(from, up.0), (to, up.0), (to, top), (from, top)];
    let mut series = Vec::new();
    let amber = window.spans(|found| found.light == Some(Light::Amber));
    let is_amber = !amber.is_empty();
    series.extend(amber.into_iter().map(|span| Series::silent(upright(span), AMBER)));
    let spans: Vec<(Zone, Vec<(f64, f64)>)> = zones.iter().map(|zone| (*zone, window.zone_spans(*zone))).collect();
    for look in [ground, lines] {
        let drawn = spans.iter().flat_map(|(zone, spans)| spans.iter().map(move |span| (*zone, *span)));
        series.extend(drawn.map(|(zone, span)| Series::silent(upright(span), look(zone))));
    }
    if is_first {
        series.extend(is_amber.then(|| Series::new(String::from("Amber"), Vec::new(), AMBER)));
        series.extend(zones.iter().map(|zone| entry(*zone)));
    }
    series
}
