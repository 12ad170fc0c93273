//! One key at a time: how far each moves the numbers that decide, the largest swing on top.

use super::zones::OWN;
use crate::plot::chart::{Chart, Color, Look, Panel, Scale, Series, color, pale};
use crate::plot::font;
use crate::study::{End, Results, Swing, swings};
use crate::table::Axis;
use crate::units::joined;

/// Panels at most, and keys of each.
const MOST: usize = 4;
const KEYS: usize = 12;
/// Height of a bar with its room, and of half the bar \[px, and of 1 from bar to bar\].
const ROW: f64 = 34.0;
const HALF: f64 = 0.34;
/// Height of each of two bars that go to one side, so that their labels stand one above the other.
const STACKED: f64 = 0.48;
/// Size of the letters of labels and of names, and the room around a label \[px\].
const LABEL: f64 = 15.0;
const NAME: f64 = 17.0;
const AROUND: f64 = 16.0;
/// Width of a picture in a narrow column, and of what stands beside names and panel \[px\]: labels that have room there have
/// it everywhere.
const NARROW: f64 = 542.0;
const BESIDE: f64 = 95.0;
/// As narrow as a panel is taken to be \[px\].
const LEAST: f64 = 150.0;
/// Between a bar and its label, over the panel \[–\].
const GAP: f64 = 0.008;
/// Behind the value of a design that fails.
const FAILED: &str = " *";

/// Looks of bars whose key is above where the case stands, and below: apart in grey print.
const ABOVE: fn() -> Look = || Look::Area { fill: color(1), edge: Some((70, 70, 70)) };
const BELOW: fn() -> Look = || {
    let line: Color = color(0);
    Look::Hatched { fill: Some(pale(line)), line, rise: 45.0 }
};
const OTHER: Look = Look::Area { fill: (190, 190, 190), edge: Some((70, 70, 70)) };

/// A panel for each number.
pub(super) fn chart(results: &Results, title: String, mut notes: Vec<String>) -> Chart {
    notes.extend(failed(results));
    let all = results.deciding(MOST).into_iter().map(|place| (place, swings(results, place)));
    let mut panels: Vec<Panel> = all
        .filter(|(_, swings)| !swings.is_empty())
        .map(|(place, swings)| {
            let moves = swings.iter().take_while(|swing| swing.width() > 0.0).count();
            panel(results, place, &swings[..moves.min(KEYS)])
        })
        .collect();
    if let Some(first) = panels.first_mut() {
        let entries =
            [("Key above where the case stands", ABOVE()), ("Key below", BELOW()), ("The case as it stands", OWN)];
        let has_other = results.axes.iter().any(|axis| axis.own.is_none() || axis.has_names());
        let other = has_other.then_some(("Another choice", OTHER));
        let entries = entries.into_iter().chain(other);
        first.series.extend(entries.map(|(label, look)| Series::new(String::from(label), Vec::new(), look)));
    }
    Chart { title, legend: String::new(), panels, notes }
}

fn panel(results: &Results, place: usize, swings: &[Swing]) -> Panel {
    let number = results.number(place);
    let own = results.rows[0].numbers[place];
    let ends = swings.iter().flat_map(|swing| [swing.low.number, swing.high.number]);
    let (low, high) = ends.fold((own, own), |(low, high), v| (low.min(v), high.max(v)));
    let mut names: Vec<String> = swings.iter().map(|swing| String::from(results.axes[swing.axis].message())).collect();
    names.reverse();
    let px = (NARROW - BESIDE - NAME * names.iter().map(|name| font::width(name)).fold(0.0, f64::max)).max(LEAST);
    let share = |label: &str| (LABEL * font::width(label) + AROUND) / px;
    let bars: Vec<_> = swings.iter().enumerate().flat_map(|(i, swing)| bars(swing, i, swings.len())).collect();
    let labels = bars.iter().filter_map(|(swing, bar)| told(results, swing, bar.end));
    let widest = labels.map(|label| share(&label)).fold(0.0, f64::max);
    // The labels have room on either side of the longest bars.
    let width = (high - low) / (1.0 - 2.0 * widest).max(0.2);
    let x = (low - widest * width, high + widest * width);
    let count = swings.len();
    let mut series: Vec<Series> = bars
        .iter()
        .map(|(swing, Bar { end, y: (from, to) })| {
            let outline = vec![(own, *from), (end.number, *from), (end.number, *to), (own, *to)];
            Series::silent(outline, look(results, swing, *end))
        })
        .collect();
    series.push(Series::silent(vec![(own, -0.6), (own, count as f64 - 0.4)], OWN));
    for (swing, Bar { end, y: (from, to) }) in &bars {
        let Some(label) = told(results, swing, *end) else { continue };
        let (off, look) = if end.number < own { (-GAP, Look::Before) } else { (GAP, Look::Text) };
        series.push(Series::new(label, vec![(end.number + off * width, 0.5 * (from + to))], look));
    }
    let height = ROW * count as f64 + 12.0;
    Panel {
        x: Axis::named(number.label, number.amount.unit),
        y: Axis::of_names("", names),
        series,
        scale: Scale::Window { height, x, y: (-0.6, count as f64 - 0.4) },
    }
}

/// A bar from where the case stands to an end.
#[derive(Clone, Copy)]
struct Bar {
    end: End,
    /// From its lower edge to its upper one, of 1 from row to row.
    y: (f64, f64),
}

/// The bars of a swing, one of so many from the top: to either side, or to one side and one above the other.
fn bars(swing: &Swing, from_top: usize, of: usize) -> Vec<(Swing, Bar)> {
    let middle = (of - 1 - from_top) as f64;
    let ends = [swing.low, swing.high].into_iter().filter(|end| end.value.is_some());
    match swing.other {
        None => ends.map(|end| (*swing, Bar { end, y: (middle - HALF, middle + HALF) })).collect(),
        Some(other) => ends
            .map(|end| (*swing, Bar { end, y: (middle, middle + STACKED) }))
            .chain([(*swing, Bar { end: other, y: (middle - STACKED, middle) })])
            .collect(),
    }
}

/// The key's value at an end, marked where the design fails; nothing of the case as it stands.
fn told(results: &Results, swing: &Swing, end: End) -> Option<String> {
    let value = results.axes[swing.axis].told(end.value?).to_string();
    Some(if results.rows[end.row].is_sound() { value } else { value + FAILED })
}

/// What the mark means: each design that fails, and how.
fn failed(results: &Results) -> Option<String> {
    let failed = results.rows.iter().enumerate().skip(1).filter_map(|(row, found)| {
        let places = results.plan.place(row as u64);
        let (axis, place) = results.axes.iter().zip(places).find_map(|(axis, place)| Some((axis, place?)))?;
        let zone = found.worst()?;
        let value = axis.told(axis.values[place]);
        Some(format!("{axis} {value} ({zone})", axis = axis.message(), zone = zone.label()))
    });
    let failed = joined(failed, ", ");
    (!failed.is_empty()).then(|| format!("* fails: {failed}."))
}

/// Whether the key is above or below where the case stands at an end.
fn look(results: &Results, swing: &Swing, end: End) -> Look {
    let axis = &results.axes[swing.axis];
    match (axis.has_names(), end.value.zip(axis.own)) {
        (false, Some((value, own))) if value > own => ABOVE(),
        (false, Some(_)) => BELOW(),
        _ => OTHER,
    }
}
